// volumetric_obscurance where the filled share of the ball is known in closed form.
#include "methods/volumetric_obscurance/volumetric_obscurance.hpp"
#include "tests/methods/depth_scenes.hpp"

#include <cmath>

namespace alcove {
namespace {

class VolumetricObscuranceTest : public DepthImageTest {
  protected:
    /// Mean of a column's middle rows.
    static double average_column(const Image& image, int x) {
        double sum = 0.0;
        for (int y = image.height() / 2 - 20; y < image.height() / 2 + 20; ++y) {
            sum += static_cast<double>(image.at(x, y));
        }
        return sum / 40.0;
    }
    const MethodUnit m_unit = volumetric_obscurance_unit();
};

/// Share of a ball, or of half of it, beyond a plane at `k` radii from its centre that halves the
/// half ball: the spherical cap of height 1 - k.
double compute_cap_share(double k) {
    const double h = 1.0 - k;
    return h * h * (3.0 - h) / 4.0;
}

TEST_F(VolumetricObscuranceTest, AWallFillsItsSphericalCap) {
    const double wall = 1.0;
    const double radius = 0.6;
    const DepthImage input = make_floor_and_wall_image(wall);
    const RigResult result =
        run(m_unit, resolve(m_unit, "converged", {{"radius", "0.6"}, {"cut", "4"}}), input);
    const glm::dvec2 tangents = compute_tangents(input.camera, input.depth.size());
    int compared = 0;
    for (int x = 96; x < 192; ++x) {
        const double at = (2.0 * (x + 0.5) / 192.0 - 1.0) * tangents.x * 3.0;
        const double k = (wall - at) / radius;
        if (k < 0.08 || k > 1.5) {
            continue;
        }
        const double expected = 1.0 - (k < 1.0 ? compute_cap_share(k) : 0.0);
        // 512 points of one unrotated Halton set: 0.02 of the half ball; nearer to the wall than
        // a few pixels the wall's own pixels are too coarse.
        EXPECT_NEAR(average_column(result.visibility, x), expected, 0.025) << "at " << k << " r";
        ++compared;
    }
    EXPECT_GE(compared, 20);
}

TEST_F(VolumetricObscuranceTest, APlaneFillsHalfOfTheBallAndNothingOfItsUpperHalf) {
    const DepthImage wall = make_wall_image({64, 48}, 3.0f);
    EXPECT_EQ(run(m_unit, resolve(m_unit, "default", {}), wall).visibility.at(32, 24), 1.0f);
    EXPECT_NEAR(run(m_unit, resolve(m_unit, "ball", {}), wall).visibility.at(32, 24), 0.5f, 0.01f);
}

TEST_F(VolumetricObscuranceTest, PointsAreEvenInVolume) {
    int inner = 0;
    int lower = 0;
    for (const glm::vec4& point : make_ball_kernel(4096, true)) {
        EXPECT_NEAR(std::hypot(point.x, point.y, point.z), 1.0f, 1e-5f);
        inner += point.w < 0.5f ? 1 : 0;
        lower += point.z < 0.0f ? 1 : 0;
    }
    EXPECT_NEAR(inner / 4096.0, 0.125, 0.003);
    EXPECT_NEAR(lower / 4096.0, 0.5, 0.003);
}

} // namespace
} // namespace alcove
