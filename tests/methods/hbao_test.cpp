// hbao where the horizon is known in closed form.
#include "methods/hbao/hbao.hpp"
#include "tests/methods/depth_scenes.hpp"

#include <cmath>
#include <numbers>

namespace alcove {
namespace {

class HbaoTest : public DepthImageTest {
  protected:
    const MethodUnit m_unit = hbao_unit();
};

/// A wall at `k` radii on a plane, higher than the reach, without attenuation and bias: in a
/// direction at angle a to the wall's the ball cuts the wall at a height whose sine is sqrt(1 - (k
/// / cos a)^2). Mean over all directions, by the midpoint rule.
double compute_wall_obscurance(double k) {
    constexpr int kSteps = 20000;
    const double most = std::acos(k);
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double ratio = k / std::cos((i + 0.5) / kSteps * most);
        sum += std::sqrt(1.0 - ratio * ratio);
    }
    return sum / kSteps * most / std::numbers::pi;
}

TEST_F(HbaoTest, AWallRaisesTheHorizonOfItsClosedForm) {
    const double wall = 1.0;
    const DepthImage input = make_floor_and_wall_image(wall);
    const RigResult result =
        run(m_unit,
            resolve(m_unit, "converged",
                    {{"radius", "0.6"}, {"attenuation", "false"}, {"steps", "64"}}),
            input);
    const glm::dvec2 tangents = compute_tangents(input.camera, input.depth.size());
    int compared = 0;
    for (int x = 96; x < 192; ++x) {
        const double at = (2.0 * (x + 0.5) / 192.0 - 1.0) * tangents.x * 3.0;
        const double k = (wall - at) / 0.6;
        if (k < 0.15 || k > 1.5) {
            continue;
        }
        const double expected = 1.0 - (k < 1.0 ? compute_wall_obscurance(k) : 0.0);
        // The wall's height is known where it has pixels, the sphere's edge between two of them:
        // always too low, by up to 0.03. Elevations are told from the view ray, which is tilted by
        // up to 18 degrees here.
        EXPECT_NEAR(result.visibility.at(x, 72), expected, 0.05) << "at " << k << " r";
        ++compared;
    }
    EXPECT_GE(compared, 20);
}

TEST_F(HbaoTest, ATiltedPlaneNeverRisesAboveItself) {
    DepthImage input = make_wall_image({96, 72}, 1.0f);
    for (int y = 0; y < 72; ++y) {
        for (int x = 0; x < 96; ++x) {
            RayCaster ray(compute_pixel_direction(input.camera, {96, 72}, {x + 0.5, y + 0.5}));
            ray.add_plane({0.0, 0.0, -3.0}, {0.0, 1.0, 0.3});
            write_hit(input, x, y, ray);
        }
    }
    const RigResult result =
        run(m_unit, resolve(m_unit, "unfiltered", {{"angle_bias", "1"}}), input);
    for (const float value : result.visibility.values()) {
        EXPECT_EQ(value, 1.0f);
    }
}

TEST_F(HbaoTest, AngleBiasTakesAwayLowHorizons) {
    const DepthImage input = make_corner_with_spheres_image();
    double before = 0.0;
    for (const char* bias : {"0", "10", "30", "60"}) {
        const RigResult result =
            run(m_unit, resolve(m_unit, "converged", {{"angle_bias", bias}}), input);
        double sum = 0.0;
        for (const float value : result.visibility.values()) {
            sum += static_cast<double>(value);
        }
        EXPECT_GT(sum, before) << bias;
        before = sum;
    }
}

} // namespace
} // namespace alcove
