// The reference against occlusion that is known: means within three standard errors, errors that
// fall as they should, and a noise estimate that is one. Standard errors come from independent
// randomisations (seeds), never from the scatter of a low-discrepancy set.
#include "methods/common/ray_tracer.hpp"

#include "core/base/statistics.hpp"
#include "tests/methods/analytic_occlusion.hpp"
#include "tests/test_scenes.hpp"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace alcove {
namespace {

constexpr ImageSize kPatch{24, 24}; // 576 pixels
constexpr int kSeeds = 8;
const glm::dmat4 kUpright(1.0);

/// Blocked share at a point of the floor.
using Truth = std::function<double(const glm::dvec3&)>;

/// A scene whose receivers are the floor y = 0, seen through a camera that sees nothing else, and
/// the truth there. All is built upright; `turned` only places it, so the truth is found where the
/// ray hits the upright floor.
struct Rig {
    TestScene scene;
    Camera upright_camera;
    Camera camera;
    Truth truth;
};

Rig make_rig(std::vector<Mesh> meshes, const glm::dvec3& eye, const glm::dvec3& target,
             const glm::dmat4& turned, Truth truth) {
    const Camera upright = make_look_at_camera(eye, target, {0.0, 1.0, 0.0},
                                               12.0 * std::numbers::pi / 180.0, 0.1, 100.0);
    Camera camera = upright;
    camera.position = glm::dvec3(turned * glm::dvec4(eye, 1.0));
    camera.world_from_view = glm::dmat3(turned) * upright.world_from_view;
    std::vector<glm::dmat4> transforms(meshes.size(), turned);
    return {{std::move(meshes), std::move(transforms), {camera}, 0.5},
            upright,
            camera,
            std::move(truth)};
}

Mesh make_floor() {
    return make_quad({-20, 0, 20}, {20, 0, 20}, {20, 0, -20}, {-20, 0, -20});
}
Mesh make_wall_x() {
    return make_quad({0, 0, 20}, {0, 0, -20}, {0, 20, -20}, {0, 20, 20});
}
Mesh make_wall_z() {
    return make_quad({-20, 0, 0}, {20, 0, 0}, {20, 20, 0}, {-20, 20, 0});
}

constexpr double kCornerRadius = 0.5;

/// Floor and the wall x = 0; the patch lies 0.13 to 0.37 m before it, from a quarter to three
/// quarters of the reach.
Rig make_corner(Falloff falloff, Weighting weighting, const glm::dmat4& turned = kUpright) {
    return make_rig({make_floor(), make_wall_x()}, {0.9, 0.9, 0.3}, {0.25, 0.0, 0.1}, turned,
                    [=](const glm::dvec3& p) {
                        return falloff == Falloff::none
                                   ? compute_wall_occlusion(p.x / kCornerRadius, weighting)
                                   : integrate_wall_occlusion(p.x / kCornerRadius, falloff,
                                                              weighting);
                    });
}

Rig make_three_plane_corner() {
    return make_rig({make_floor(), make_wall_x(), make_wall_z()}, {0.7, 1.0, 0.75},
                    {0.22, 0.0, 0.24}, kUpright, [](const glm::dvec3& p) {
                        EXPECT_GT(p.z, 0.01) << "the patch leaves the floor";
                        return compute_two_walls_occlusion(p.x / kCornerRadius,
                                                           p.z / kCornerRadius);
                    });
}

/// 256 rings: the inscribed mesh blocks 2e-5 of its share less than the sphere, a tenth of the
/// standard error or less.
Rig make_sphere_over_floor(double height) {
    constexpr float kRadius = 0.5f;
    return make_rig(
        {make_floor(), make_sphere({0.0f, static_cast<float>(height), 0.0f}, kRadius, 256)},
        {2.2, 1.5, 0.2}, {0.9, 0.0, 0.1}, kUpright, [height](const glm::dvec3& p) {
            return compute_sphere_occlusion({-p.x, -p.z, height}, 0.5);
        });
}

glm::dvec3 find_floor_point(const Rig& rig, int x, int y) {
    const Camera& camera = rig.upright_camera;
    const glm::dvec3 d = compute_pixel_direction(camera, kPatch, {x + 0.5, y + 0.5});
    return camera.position - d * (camera.position.y / d.y);
}

Image compute_expected(const Rig& rig) {
    Image expected(kPatch, 1);
    for (int y = 0; y < kPatch.height; ++y) {
        for (int x = 0; x < kPatch.width; ++x) {
            const glm::dvec3 point = find_floor_point(rig, x, y);
            EXPECT_GT(point.x, 0.01) << "the patch leaves the floor";
            expected.at(x, y) = static_cast<float>(1.0 - rig.truth(point));
        }
    }
    return expected;
}

TraceSettings make_settings(double radius, Falloff falloff, Weighting weighting, int rays_per_half,
                            std::uint32_t seed) {
    TraceSettings settings;
    settings.target = {radius, falloff, weighting, Normals::geometric};
    settings.rays_per_half = rays_per_half;
    settings.seed = seed;
    return settings;
}

/// Mean over the patch of (traced - expected), a seed.
std::vector<double> measure_deviations(const Rig& rig, TraceSettings settings) {
    const Image expected = compute_expected(rig);
    RayTracer tracer;
    tracer.update(pose_geometry(rig.scene, 0.0));
    std::vector<double> deviations;
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
        settings.seed = seed;
        const Image traced = compute_mean(tracer.trace(rig.camera, kPatch, settings));
        double sum = 0.0;
        for (std::size_t i = 0; i < kPatch.pixel_count(); ++i) {
            sum +=
                static_cast<double>(traced.values()[i]) - static_cast<double>(expected.values()[i]);
        }
        deviations.push_back(sum / static_cast<double>(kPatch.pixel_count()));
    }
    return deviations;
}

void expect_unbiased(const std::string& name, const Rig& rig, const TraceSettings& settings) {
    const std::vector<double> deviations = measure_deviations(rig, settings);
    const double mean = compute_mean(deviations);
    const double error = compute_standard_deviation(deviations) / std::sqrt(double{kSeeds});
    testing::Test::RecordProperty(name + "_standard_error", std::to_string(error));
    testing::Test::RecordProperty(name + "_deviation_in_errors", std::to_string(mean / error));
    EXPECT_LT(std::abs(mean), 3.0 * error) << name << ": mean " << mean << ", error " << error;
    // A twentieth of an 8-bit step: coarser, and three errors would let a wrong weight or a lost
    // ray pass.
    EXPECT_LT(error, 0.05 / 255.0) << name;
}

TEST(AnalyticOcclusion, ClosedFormsAgreeWithQuadratureOfTheVisibility) {
    // 2e-5 is the midpoint rule's own error on an edge at 2,000 x 2,000 cells, with room for two
    // edges.
    constexpr int kSteps = 2000;
    constexpr double kTolerance = 5e-5;
    for (const double k : {0.2, 0.7}) {
        for (const Weighting weighting : {Weighting::cosine, Weighting::uniform}) {
            for (const Falloff falloff : {Falloff::none, Falloff::linear, Falloff::quadratic}) {
                const double quadrature = integrate_hemisphere(
                    [&](const glm::dvec3& d) {
                        return d.x > k ? compute_falloff(falloff, k / d.x) : 0.0;
                    },
                    weighting, kSteps);
                EXPECT_NEAR(integrate_wall_occlusion(k, falloff, weighting), quadrature,
                            kTolerance);
                if (falloff == Falloff::none) {
                    EXPECT_NEAR(compute_wall_occlusion(k, weighting), quadrature, kTolerance);
                }
            }
        }
    }
    for (const glm::dvec2& k : {glm::dvec2(0.3, 0.5), glm::dvec2(0.8, 0.7)}) {
        const double quadrature = integrate_hemisphere(
            [&](const glm::dvec3& d) { return d.x > k.x || d.y > k.y ? 1.0 : 0.0; },
            Weighting::cosine, kSteps);
        EXPECT_NEAR(compute_two_walls_occlusion(k.x, k.y), quadrature, kTolerance);
    }
    const glm::dvec3 to_center(0.9, 0.1, 0.5);
    const double quadrature = integrate_hemisphere(
        [&](const glm::dvec3& d) {
            return glm::length(glm::cross(d, to_center)) < 0.5 && glm::dot(d, to_center) > 0.0
                       ? 1.0
                       : 0.0;
        },
        Weighting::cosine, kSteps);
    EXPECT_NEAR(compute_sphere_occlusion(to_center, 0.5), quadrature, kTolerance);
}

TEST(ReferenceRayTraced, ASphereOnOrAboveAPlaneBlocksItsProjectedSolidAngle) {
    const TraceSettings settings = make_settings(4.0, Falloff::none, Weighting::cosine, 256, 0);
    expect_unbiased("resting", make_sphere_over_floor(0.5), settings);
    expect_unbiased("floating", make_sphere_over_floor(0.8), settings);
}

TEST(ReferenceRayTraced, AHardDistanceOutOfReachBlocksNothing) {
    // The nearest point of the patch is 0.36 m from the resting sphere (distance to its centre less
    // its radius).
    const Rig rig = make_sphere_over_floor(0.5);
    RayTracer tracer;
    tracer.update(pose_geometry(rig.scene, 0.0));
    const Image traced = compute_mean(tracer.trace(
        rig.camera, kPatch, make_settings(0.2, Falloff::none, Weighting::cosine, 64, 1)));
    for (const float value : traced.values()) {
        ASSERT_EQ(value, 1.0f);
    }
}

TEST(ReferenceRayTraced, ACornerBlocksASegmentOfTheDiscInEveryOrientation) {
    // Floors whose normals are +y, -y, +z and exactly -z (the frame's pole), +x, and one along no
    // axis.
    const double quarter = 0.5 * std::numbers::pi;
    const auto turn = [](double angle, const glm::dvec3& axis) {
        return glm::rotate(glm::dmat4(1.0), angle, axis);
    };
    const std::vector<std::pair<const char*, glm::dmat4>> orientations{
        {"up", kUpright},
        {"down", turn(2.0 * quarter, {0.0, 0.0, 1.0})},
        {"towards", turn(quarter, {1.0, 0.0, 0.0})},
        {"away", turn(-quarter, {1.0, 0.0, 0.0})},
        {"right", turn(-quarter, {0.0, 0.0, 1.0})},
        {"oblique", turn(0.7, glm::normalize(glm::dvec3(1.0, 2.0, -0.5)))},
    };
    const TraceSettings settings =
        make_settings(kCornerRadius, Falloff::none, Weighting::cosine, 256, 0);
    for (const auto& [name, turned] : orientations) {
        expect_unbiased(name, make_corner(Falloff::none, Weighting::cosine, turned), settings);
    }
}

TEST(ReferenceRayTraced, ThreePlanesBlockTheUnionOfTwoSegments) {
    expect_unbiased("three_planes", make_three_plane_corner(),
                    make_settings(kCornerRadius, Falloff::none, Weighting::cosine, 256, 0));
}

TEST(ReferenceRayTraced, FalloffsAndWeightingsMatchQuadratureInACorner) {
    for (const Weighting weighting : {Weighting::cosine, Weighting::uniform}) {
        for (const Falloff falloff : {Falloff::none, Falloff::linear, Falloff::quadratic}) {
            const std::string name =
                std::string(to_text(weighting)) + "_" + std::string(to_text(falloff));
            expect_unbiased(name, make_corner(falloff, weighting),
                            make_settings(kCornerRadius, falloff, weighting, 256, 0));
        }
    }
}

/// RMS over the patch and all seeds of (mean of the halves - expected), and of the reported noise.
struct ErrorAndNoise {
    double error = 0.0;
    double noise = 0.0;
};

ErrorAndNoise measure_error(const Rig& rig, TraceSettings settings) {
    const Image expected = compute_expected(rig);
    RayTracer tracer;
    tracer.update(pose_geometry(rig.scene, 0.0));
    ErrorAndNoise result;
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
        settings.seed = seed;
        const ReferencePair pair = tracer.trace(rig.camera, kPatch, settings);
        const Image traced = compute_mean(pair);
        for (std::size_t i = 0; i < kPatch.pixel_count(); ++i) {
            const double difference =
                static_cast<double>(traced.values()[i]) - static_cast<double>(expected.values()[i]);
            result.error += difference * difference;
        }
        result.noise += compute_noise(pair) * compute_noise(pair);
    }
    result.error = std::sqrt(result.error / (kSeeds * static_cast<double>(kPatch.pixel_count())));
    result.noise = std::sqrt(result.noise / kSeeds);
    return result;
}

TEST(ReferenceRayTraced, TheErrorFallsFasterThanPlainMonteCarlo) {
    for (const Falloff falloff : {Falloff::none, Falloff::linear}) {
        const Rig rig = make_corner(falloff, Weighting::cosine);
        std::vector<double> log_rays;
        std::vector<double> log_errors;
        for (int rays_per_half = 2; rays_per_half <= 128; rays_per_half *= 2) {
            const TraceSettings settings =
                make_settings(kCornerRadius, falloff, Weighting::cosine, rays_per_half, 0);
            log_rays.push_back(std::log(2.0 * rays_per_half));
            log_errors.push_back(std::log(measure_error(rig, settings).error));
        }
        const double mean_x = compute_mean(log_rays);
        const double mean_y = compute_mean(log_errors);
        double xy = 0.0;
        double xx = 0.0;
        for (std::size_t i = 0; i < log_rays.size(); ++i) {
            xy += (log_rays[i] - mean_x) * (log_errors[i] - mean_y);
            xx += (log_rays[i] - mean_x) * (log_rays[i] - mean_x);
        }
        const double slope = xy / xx;
        RecordProperty(std::string("slope_") + std::string(to_text(falloff)),
                       std::to_string(slope));
        // Random points give -0.5; stratified ones -0.75 on an edge, -1 or better on smooth
        // integrands.
        EXPECT_GE(slope, -1.1) << to_text(falloff);
        EXPECT_LE(slope, -0.45) << to_text(falloff);
    }
}

TEST(ReferenceRayTraced, TheReportedNoiseIsTheErrorOfTheMean) {
    for (const Falloff falloff : {Falloff::none, Falloff::linear}) {
        for (const int rays_per_half : {8, 64}) {
            const TraceSettings settings =
                make_settings(kCornerRadius, falloff, Weighting::cosine, rays_per_half, 0);
            const ErrorAndNoise measured =
                measure_error(make_corner(falloff, Weighting::cosine), settings);
            const double ratio = measured.noise / measured.error;
            RecordProperty("noise_over_error_" + std::string(to_text(falloff)) + "_" +
                               std::to_string(rays_per_half),
                           std::to_string(ratio));
            // Each RMS is over 4,608 values: 1 % of its own. 6 % is four times what both together
            // scatter.
            EXPECT_NEAR(ratio, 1.0, 0.06);
        }
    }
}

} // namespace
} // namespace alcove
