// Both parts of shanmugam_arikan against their formulas in double precision.
#include "core/contract/method_gbuffers.hpp"
#include "core/frame/scene_renderer.hpp"
#include "methods/common/kernels.hpp"
#include "methods/shanmugam_arikan/shanmugam_arikan.hpp"
#include "methods/shanmugam_arikan/sphere_clusters.hpp"
#include "methods/shanmugam_arikan/sphere_occlusion.hpp"
#include "tests/contract/method_shot.hpp"
#include "tests/methods/depth_scenes.hpp"
#include "tests/methods/estimator_oracle.hpp"
#include "tests/test_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

namespace alcove {
namespace {

constexpr double kPi = std::numbers::pi;

OracleAnswer evaluate_near(const OracleImage& image, const OracleImage::Receiver& receiver,
                           const ShanmugamArikanParams& params) {
    OracleAnswer answer;
    const double reach_px =
        0.5 * params.r_far * image.size().y / (receiver.depth * image.tangents().y);
    const double pixels = kPi * reach_px * reach_px;
    const int count = std::clamp(static_cast<int>(pixels), 1, params.samples);
    answer.is_doubtful = pixels < params.samples && std::abs(pixels - std::round(pixels)) < 1e-3;
    const std::vector<glm::vec4> kernel = make_disc_kernel(params.samples);
    double sum = 0.0;
    for (int i = 0; i < count; ++i) {
        const OracleImage::Place place =
            image.find_place(glm::dvec2(receiver.pixel) + 0.5 +
                             reach_px * glm::dvec2(kernel[static_cast<std::size_t>(i)]));
        answer.is_doubtful = answer.is_doubtful || place.is_near_edge;
        if (!place.is_inside || std::isinf(image.get_depth(place.pixel))) {
            continue;
        }
        const OracleImage::Receiver neighbour = image.get_receiver(place.pixel.x, place.pixel.y);
        const glm::dvec3 off = neighbour.position - receiver.position;
        const double distance = glm::length(off);
        answer.is_doubtful = answer.is_doubtful || std::abs(distance - params.r_far) < 1e-4;
        if (distance >= params.r_far || distance == 0.0) {
            continue;
        }
        const double radius = neighbour.depth * image.tangents().y / image.size().y;
        const glm::dvec3 center = off - params.push_back * radius * neighbour.normal;
        sum += compute_sphere_occlusion_sr(center, radius, receiver.normal);
    }
    answer.visibility = std::clamp(1.0 - sum * pixels / count / kPi, 0.0, 1.0);
    return answer;
}

class ShanmugamArikanTest : public DepthImageTest {
  protected:
    const MethodUnit m_unit = shanmugam_arikan_unit();
};

TEST_F(ShanmugamArikanTest, TheNearPartEqualsItsFormulaInDouble) {
    for (const DepthImage& input : {make_corner_with_spheres_image(), make_random_blocks_image()}) {
        const ResolvedParameters resolved = resolve(m_unit, "near_only",
                                                    {{"r_far", "1.5"},
                                                     {"rotation", "false"},
                                                     {"samples", "48"},
                                                     {"layers", "1"},
                                                     {"pattern", "random"}});
        const auto params = m_unit.parameters.bind<ShanmugamArikanParams>(resolved);
        expect_oracle(
            input, run(m_unit, resolved, input),
            [&params](const OracleImage& image, const OracleImage::Receiver& receiver) {
                return evaluate_near(image, receiver, params);
            },
            2e-4);
    }
}

TEST_F(ShanmugamArikanTest, APlaneDoesNotBlockItselfAtAnyTilt) {
    for (const char* pattern : {"logarithmic", "random", "square"}) {
        for (const double slope : {0.0, 0.5, 2.0, 4.0}) {
            DepthImage input = make_wall_image({96, 72}, 1.0f);
            for (int y = 0; y < 72; ++y) {
                for (int x = 0; x < 96; ++x) {
                    RayCaster ray(
                        compute_pixel_direction(input.camera, {96, 72}, {x + 0.5, y + 0.5}));
                    ray.add_plane({0.0, 0.0, -3.0}, {0.0, slope, 1.0});
                    write_hit(input, x, y, ray);
                }
            }
            const RigResult result =
                run(m_unit, resolve(m_unit, "near_only", {{"layers", "1"}, {"pattern", pattern}}),
                    input);
            for (const float value : result.visibility.values()) {
                EXPECT_GT(value, 0.99f) << pattern << " slope " << slope;
            }
        }
    }
}

TEST_F(ShanmugamArikanTest, TheSumDoesNotDependOnTheNumberOfNeighbours) {
    const DepthImage input = make_floor_and_wall_image(1.0);
    std::vector<double> means;
    for (const char* samples : {"32", "128", "1024"}) {
        const RigResult result = run(
            m_unit, resolve(m_unit, "near_only", {{"layers", "1"}, {"samples", samples}}), input);
        double sum = 0.0;
        for (const float value : result.visibility.values()) {
            sum += 1.0 - static_cast<double>(value);
        }
        means.push_back(sum / static_cast<double>(result.visibility.values().size()));
    }
    EXPECT_GT(means.back(), 0.005);
    // Noise over the image, and what clamping at 0 takes from it.
    for (const double mean : means) {
        EXPECT_NEAR(mean / means.back(), 1.0, 0.12);
    }
}

/// Every sphere at every pixel, without billboards.
Image sum_spheres(const std::vector<Sphere>& spheres, const PosedGeometry& geometry,
                  const FrameView& view, const Image& depth, const Image& normal,
                  const ShanmugamArikanParams& params) {
    const glm::dmat4 view_from_origin =
        compute_view_from_object(view.camera, glm::translate(glm::dmat4(1.0), geometry.origin));
    const double far_distance = compute_far_distance_in_radii(params.epsilon);
    Image visibility(view.size, 1, 1.0f);
    for (int y = 0; y < view.size.height; ++y) {
        for (int x = 0; x < view.size.width; ++x) {
            if (std::isinf(depth.at(x, y))) {
                continue;
            }
            const glm::dvec2 tangents = compute_tangents(view.camera, view.size);
            const double z = static_cast<double>(depth.at(x, y));
            const glm::dvec3 p(((x + 0.5) / view.size.width * 2.0 - 1.0) * tangents.x * z,
                               (1.0 - (y + 0.5) / view.size.height * 2.0) * tangents.y * z, -z);
            const glm::dvec3 n = glm::normalize(
                glm::dvec3(normal.at(x, y, 0), normal.at(x, y, 1), normal.at(x, y, 2)));
            double sum = 0.0;
            double open = 1.0;
            for (const Sphere& sphere : spheres) {
                const glm::dvec3 to_center =
                    glm::dvec3(view_from_origin * glm::dvec4(glm::dvec3(sphere.center), 1.0)) - p;
                const double distance = glm::length(to_center);
                const auto radius = static_cast<double>(sphere.radius);
                double steradians = 0.0;
                if (distance <= radius) {
                    steradians = params.inside_value;
                } else if (distance <= std::min(far_distance * radius, params.reach)) {
                    steradians = compute_sphere_occlusion_sr(to_center, radius, n);
                }
                sum += steradians / kPi;
                open *= std::max(1.0 - steradians / kPi, 0.0);
            }
            const double occlusion =
                params.blending == OcclusionBlending::additive ? sum : 1.0 - open;
            visibility.at(x, y) = static_cast<float>(1.0 - std::clamp(occlusion, 0.0, 1.0));
        }
    }
    return visibility;
}

TEST_F(ShanmugamArikanTest, BillboardsMissNoReceiverOfAnySphere) {
    const TestScene scene = make_box_scene();
    const ShotSettings settings{{64, 48}, {1}, nullptr};
    const FrameView view = make_frame_view(scene.get_walkthrough(), 1, settings.size, false);
    const GBuffer gbuffer(gl(), settings.size, kBaseChannels, {});
    SceneRenderer renderer(gl(), scene);
    context().reset_state();
    renderer.render(gbuffer, view);
    const Image depth = gl::read_texture(gl(), gbuffer.texture(Channel::eye_depth), 1);
    const Image normal = gl::read_texture(gl(), gbuffer.texture(Channel::normal), 3);
    for (const char* blending : {"additive", "multiplicative"}) {
        const ResolvedParameters resolved =
            resolve(m_unit, "far_only",
                    {{"spheres", "300"}, {"blending", blending}, {"inside_value", "0.3"}});
        const auto params = m_unit.parameters.bind<ShanmugamArikanParams>(resolved);
        const auto method = m_unit.create(context(), resolved);
        const Image shot = shoot(context(), *method, scene, settings).visibility;
        SpherePoser poser(find_clusters(pose_geometry(scene, 0.0), {300, params.members}),
                          params.radius_rule, params.sphere_push_back);
        static_cast<void>(poser.pose(pose_geometry(scene, 0.0)));
        const PosedGeometry geometry = pose_geometry(scene, view.time_s);
        const Image expected =
            sum_spheres(poser.pose(geometry), geometry, view, depth, normal, params);
        int occluded = 0;
        int different = 0;
        for (std::size_t i = 0; i < shot.values().size(); ++i) {
            occluded += expected.values()[i] < 0.95f ? 1 : 0;
            different += std::abs(shot.values()[i] - expected.values()[i]) > 1e-3f ? 1 : 0;
        }
        EXPECT_GT(occluded, 100) << blending;
        // A receiver within 1e-6 of a sphere's edge or reach may fall to the other side.
        EXPECT_LE(different, 3) << blending;
    }
}

TEST_F(ShanmugamArikanTest, ASecondLayerFindsWhatTheFirstHides) {
    const TestScene scene = make_box_scene();
    const ShotSettings settings{{96, 72}, {1}, nullptr};
    const auto shoot_with = [&](const std::vector<std::pair<std::string, std::string>>& overrides) {
        const auto method = m_unit.create(context(), resolve(m_unit, "near_only", overrides));
        const Image image = shoot(context(), *method, scene, settings).visibility;
        double sum = 0.0;
        for (const float value : image.values()) {
            sum += static_cast<double>(value);
        }
        return sum / static_cast<double>(image.values().size());
    };
    const double one = shoot_with({{"layers", "1"}});
    const double two = shoot_with({{"layers", "2"}});
    const double back = shoot_with({{"second", "back_faces"}});
    EXPECT_LT(two, one);
    EXPECT_LT(back, one);
}

} // namespace
} // namespace alcove
