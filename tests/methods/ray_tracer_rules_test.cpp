// What the reference promises beside its accuracy: equal bits, what blocks a ray, where rays start.
#include "methods/common/ray_tracer.hpp"

#include "tests/test_scenes.hpp"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace alcove {
namespace {

constexpr ImageSize kSize{48, 36};

TraceSettings make_settings(double radius, Falloff falloff, Normals normals) {
    TraceSettings settings;
    settings.target = {radius, falloff, Weighting::cosine, normals};
    settings.rays_per_half = 32;
    settings.seed = 7;
    return settings;
}

ReferencePair trace(const TestScene& scene, const Camera& camera, const TraceSettings& settings) {
    RayTracer tracer;
    tracer.update(pose_geometry(scene, 0.0));
    return tracer.trace(camera, kSize, settings);
}

ReferencePair trace(const TestScene& scene, const TraceSettings& settings) {
    return trace(scene, scene.get_walkthrough().cameras[0], settings);
}

double compute_average(const Image& image) {
    double sum = 0.0;
    for (const float value : image.values()) {
        sum += static_cast<double>(value);
    }
    return sum / static_cast<double>(image.values().size());
}

float find_largest_difference(const Image& a, const Image& b) {
    float largest = 0.0f;
    for (std::size_t i = 0; i < a.values().size(); ++i) {
        largest = std::max(largest, std::abs(a.values()[i] - b.values()[i]));
    }
    return largest;
}

Camera make_forward_camera(double near_m, double far_m) {
    return make_look_at_camera({0.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0},
                               std::numbers::pi / 3.0, near_m, far_m);
}

TestScene make_scene(std::vector<Mesh> meshes) {
    std::vector<glm::dmat4> transforms(meshes.size(), glm::dmat4(1.0));
    return {std::move(meshes), std::move(transforms), {make_forward_camera(0.1, 1000.0)}, 0.5};
}

/// A square at depth `-z` that faces the viewer, or turns its back.
Mesh make_facing_square(float half_side, float z, bool faces_viewer) {
    const float s = half_side;
    return faces_viewer ? make_quad({-s, -s, z}, {s, -s, z}, {s, s, z}, {-s, s, z})
                        : make_quad({-s, s, z}, {s, s, z}, {s, -s, z}, {-s, -s, z});
}

TEST(RayTracerRules, TheImageDoesNotDependOnTheNumberOfThreads) {
    const TestScene scene = make_box_scene();
    TraceSettings settings = make_settings(0.5, Falloff::linear, Normals::shading);
    settings.threads = 1;
    const ReferencePair one = trace(scene, settings);
    for (const int threads : {2, 5, 0}) {
        settings.threads = threads;
        const ReferencePair many = trace(scene, settings);
        EXPECT_EQ(hash_image(one.a), hash_image(many.a)) << threads;
        EXPECT_EQ(hash_image(one.b), hash_image(many.b)) << threads;
        EXPECT_EQ(one.ray_count, many.ray_count) << threads;
    }
}

TEST(RayTracerRules, OtherSeedsAndTheOtherHalfGiveOtherBits) {
    const TestScene scene = make_box_scene();
    TraceSettings settings = make_settings(0.5, Falloff::linear, Normals::shading);
    const ReferencePair first = trace(scene, settings);
    settings.seed += 1;
    const ReferencePair other = trace(scene, settings);
    EXPECT_NE(hash_image(first.a), hash_image(first.b));
    EXPECT_NE(hash_image(first.a), hash_image(other.a));
    EXPECT_NE(hash_image(first.a), hash_image(other.b));
    EXPECT_NE(hash_image(first.b), hash_image(other.b));
}

TEST(RayTracerRules, RaysPerHalfNeedNotFillABundle) {
    // One ray either hits or not; five give fifths. A lane that is not masked would break both.
    const TestScene scene = make_box_scene();
    for (const int rays : {1, 5}) {
        TraceSettings settings = make_settings(0.5, Falloff::none, Normals::geometric);
        settings.rays_per_half = rays;
        const ReferencePair pair = trace(scene, settings);
        bool any_blocked = false;
        for (const float value : pair.a.values()) {
            const float scaled = value * static_cast<float>(rays);
            ASSERT_NEAR(scaled, std::round(scaled), 1e-5f);
            any_blocked = any_blocked || value < 1.0f;
        }
        EXPECT_TRUE(any_blocked) << rays;
    }
}

TEST(RayTracerRules, TheBackgroundIsExactlyOneAndCastsNoRays) {
    const TestScene scene = make_box_scene();
    const TraceSettings settings = make_settings(0.5, Falloff::none, Normals::shading);
    Camera away = scene.get_walkthrough().cameras[0];
    away.world_from_view[0] = -away.world_from_view[0];
    away.world_from_view[2] = -away.world_from_view[2];
    away.position.y += 50.0;
    const ReferencePair pair = trace(scene, away, settings);
    EXPECT_EQ(pair.ray_count, 0u);
    EXPECT_EQ(find_largest_difference(compute_mean(pair), Image(kSize, 1, 1.0f)), 0.0f);
}

TEST(RayTracerRules, TheNearPlaneClipsCameraRaysOnly) {
    // The square 0.3 m before the wall is cut away for the camera, and still blocks.
    const TestScene scene = make_scene(
        {make_facing_square(20.0f, -5.0f, true), make_facing_square(20.0f, -4.7f, true)});
    const TraceSettings settings = make_settings(0.5, Falloff::none, Normals::geometric);
    const Image wall = compute_mean(trace(scene, make_forward_camera(4.8, 1000.0), settings));
    // Directions whose cosine is above 0.3 / 0.5 reach it: 1 - 0.36 of the cosine-weighted
    // hemisphere. 64 rays: 0.02.
    EXPECT_NEAR(compute_average(wall), 0.36, 0.02);
    const Image square = compute_mean(trace(scene, make_forward_camera(0.1, 1000.0), settings));
    EXPECT_EQ(compute_average(square), 1.0);
}

TEST(RayTracerRules, TheFarPlaneClipsCameraRaysOnly) {
    // A slope from 4.5 m to beyond the far plane at 5 m, and a wall behind the far plane within the
    // reach of its end.
    const TestScene scene =
        make_scene({make_quad({-20, -1, -4}, {20, -1, -4}, {20, 1, -6}, {-20, 1, -6}),
                    make_facing_square(20.0f, -5.1f, true)});
    const TraceSettings settings = make_settings(1.0, Falloff::none, Normals::geometric);
    const Image whole = compute_mean(trace(scene, make_forward_camera(0.1, 1000.0), settings));
    const Camera cut = make_forward_camera(0.1, 5.0);
    const Image clipped = compute_mean(trace(scene, cut, settings));
    int equal_and_blocked = 0;
    for (int y = 0; y < kSize.height; ++y) {
        const glm::dvec3 d = compute_pixel_direction(cut, kSize, {24.5, y + 0.5});
        // The slope z = -5 - y, seen along (d.y, -1).
        const double depth = 5.0 / (1.0 - d.y);
        const bool is_visible = depth < 5.0;
        EXPECT_EQ(clipped.at(24, y), is_visible ? whole.at(24, y) : 1.0f) << y;
        equal_and_blocked += is_visible && clipped.at(24, y) < 0.995f ? 1 : 0;
    }
    EXPECT_GE(equal_and_blocked, 2);
}

TEST(RayTracerRules, ALidAMillimetreAwayBlocksEverything) {
    // No ray starts beyond it. The near plane lets the camera see below the lid. Open are
    // directions with a cosine under 0.001 / 0.5: 4e-6 of the hemisphere.
    const TestScene scene = make_scene(
        {make_facing_square(20.0f, -5.0f, true), make_facing_square(20.0f, -4.999f, true)});
    for (const Falloff falloff : {Falloff::none, Falloff::linear}) {
        const Image image = compute_mean(trace(scene, make_forward_camera(4.9995, 1000.0),
                                               make_settings(0.5, falloff, Normals::geometric)));
        // Linear falloff leaves mean(d / r) = 2 x 0.001 / 0.5.
        EXPECT_LT(compute_average(image), falloff == Falloff::none ? 1e-4 : 0.0045);
    }
}

TEST(RayTracerRules, BothSidesOfASurfaceBlockAndReceive) {
    // A half plane's edge 0.2 m before a wall; turning either surface over changes nothing but the
    // rounding of hits on the edges between triangles: under one ray in a thousand.
    const TraceSettings settings = make_settings(0.5, Falloff::none, Normals::shading);
    const auto measure = [&](bool wall_faces, bool blocker_faces) {
        const TestScene scene = make_scene({make_facing_square(20.0f, -5.0f, wall_faces),
                                            make_facing_square(1.0f, -4.8f, blocker_faces)});
        return compute_average(
            compute_mean(trace(scene, make_forward_camera(4.9, 1000.0), settings)));
    };
    const double both_face = measure(true, true);
    EXPECT_LT(both_face, 0.95);
    EXPECT_NEAR(measure(true, false), both_face, 1e-3);
    EXPECT_NEAR(measure(false, true), both_face, 1e-3);
    EXPECT_NEAR(measure(false, false), both_face, 1e-3);
}

TEST(RayTracerRules, AWorldFarFromZeroGivesTheSameImage) {
    const TraceSettings settings = make_settings(0.5, Falloff::linear, Normals::shading);
    const Image here = compute_mean(trace(make_box_scene(), settings));
    const Image far = compute_mean(trace(make_box_scene(glm::dvec3(1e7, -1e7, 1e7)), settings));
    EXPECT_LT(compute_average(here), 0.99);
    EXPECT_LE(find_largest_difference(here, far), 1.0f / 255.0f);
}

TEST(RayTracerRules, AnotherSceneGetsItsOwnTree) {
    const TraceSettings settings = make_settings(0.5, Falloff::none, Normals::shading);
    const TestScene boxes = make_box_scene();
    const TestScene wall = make_scene({make_facing_square(20.0f, -5.0f, true)});
    RayTracer tracer;
    tracer.update(pose_geometry(boxes, 0.0));
    tracer.update(pose_geometry(wall, 0.0));
    EXPECT_EQ(compute_average(
                  compute_mean(tracer.trace(make_forward_camera(0.1, 1000.0), kSize, settings))),
              1.0);
    tracer.update(pose_geometry(boxes, 0.0));
    const Image again =
        compute_mean(tracer.trace(boxes.get_walkthrough().cameras[0], kSize, settings));
    EXPECT_EQ(hash_image(again), hash_image(compute_mean(trace(boxes, settings))));
}

TEST(RayTracerRules, ACoarseSphereWithSmoothNormalsDoesNotBlockItself) {
    // Nothing stands around it. Without the lifted origin, rays of smooth normals run into the
    // facet they start on.
    const TestScene scene = make_scene({make_sphere({0.0f, 0.0f, -4.0f}, 1.5f, 5)});
    TraceSettings settings = make_settings(1.0, Falloff::none, Normals::shading);
    // Mean and largest blocked share of the pixels that show the sphere.
    const auto measure = [&] {
        const ReferencePair pair = trace(scene, settings);
        const Image image = compute_mean(pair);
        const double receivers =
            static_cast<double>(pair.ray_count) / (2.0 * settings.rays_per_half);
        const double blocked =
            (1.0 - compute_average(image)) * static_cast<double>(kSize.pixel_count()) / receivers;
        return std::pair{blocked, find_largest_difference(image, Image(kSize, 1, 1.0f))};
    };
    const auto [safe_mean, safe_largest] = measure();
    settings.terminator_safe = false;
    const auto [plain_mean, plain_largest] = measure();
    RecordProperty("average_safe", std::to_string(safe_mean));
    RecordProperty("average_plain", std::to_string(plain_mean));
    RecordProperty("average_plain_largest", std::to_string(plain_largest));
    // One ray of the 64 at most: at grazing angles a ray may meet a neighbouring facet by rounding.
    EXPECT_LE(safe_largest, 1.0f / 64.0f);
    EXPECT_LT(safe_mean, 1e-3);
    EXPECT_GT(plain_mean, 10.0 * 1e-3);
    EXPECT_GT(plain_largest, 0.05f);
}

} // namespace
} // namespace alcove
