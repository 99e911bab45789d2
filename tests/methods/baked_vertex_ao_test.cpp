// baked_vertex_ao: what is baked is the closed form, and a frame does not depend on those before.
#include "methods/baked_vertex_ao/baked_geometry.hpp"
#include "methods/baked_vertex_ao/baked_vertex_ao.hpp"
#include "tests/contract/method_shot.hpp"
#include "tests/core/gl/test_context.hpp"
#include "tests/methods/analytic_occlusion.hpp"
#include "tests/test_scenes.hpp"

#include <algorithm>
#include <cmath>

namespace alcove {
namespace {

/// A floor of 40 x 40 squares over [0, 2] x [-1, 1], +y up.
Mesh make_fine_floor() {
    constexpr int kCells = 40;
    Mesh mesh;
    mesh.name = "floor";
    for (int row = 0; row <= kCells; ++row) {
        for (int column = 0; column <= kCells; ++column) {
            mesh.positions.emplace_back(2.0f * static_cast<float>(column) / kCells, 0.0f,
                                        2.0f * static_cast<float>(row) / kCells - 1.0f);
            mesh.normals.emplace_back(0.0f, 1.0f, 0.0f);
        }
    }
    const auto get_index = [](int column, int row) {
        return static_cast<std::uint32_t>(row * (kCells + 1) + column);
    };
    for (int row = 0; row < kCells; ++row) {
        for (int column = 0; column < kCells; ++column) {
            for (const auto& [x, y] : {std::pair{0, 0}, {0, 1}, {1, 1}, {0, 0}, {1, 1}, {1, 0}}) {
                mesh.indices.push_back(get_index(column + x, row + y));
            }
        }
    }
    return mesh;
}

/// The floor, and a wall at x = 0 that faces it.
TestScene make_corner() {
    return {{make_fine_floor(), make_quad({0.0f, 0.0f, -3.0f}, {0.0f, 3.0f, -3.0f},
                                          {0.0f, 3.0f, 3.0f}, {0.0f, 0.0f, 3.0f})},
            {glm::dmat4(1.0), glm::dmat4(1.0)},
            make_box_scene().get_walkthrough().cameras,
            0.5};
}

TEST(BakedVertices, BesideAWallHoldItsClosedForm) {
    const TestScene scene = make_corner();
    const PosedGeometry geometry = pose_geometry(scene, 0.0);
    RayTracer tracer;
    tracer.update(geometry);
    TraceSettings settings;
    settings.target = {0.5, Falloff::linear, Weighting::cosine, Normals::shading};
    settings.rays_per_half = 512;
    const std::vector<SurfacePoint> points = list_vertex_points(geometry, 0.02);
    ASSERT_EQ(points.size(), 41u * 41u + 4u);
    const std::vector<float> visibility = tracer.trace_points(points, settings);
    int compared = 0;
    for (std::size_t i = 0; i < 41u * 41u; ++i) {
        const double k = static_cast<double>(points[i].position.x) / 0.5;
        if (std::abs(points[i].position.z) > 0.4f || k < 0.1) {
            continue;
        }
        const double expected =
            k < 1.0 ? integrate_wall_occlusion(k, Falloff::linear, Weighting::cosine) : 0.0;
        // 1024 rays, stratified.
        EXPECT_NEAR(1.0 - static_cast<double>(visibility[i]), expected, 0.01) << "at " << k << " r";
        ++compared;
    }
    EXPECT_GE(compared, 300);
}

TEST(BakedVertices, OfASphereDoNotLookInside) {
    const TestScene scene{{make_sphere({0.0f, 0.0f, 0.0f}, 1.0f, 12)},
                          {glm::dmat4(1.0)},
                          make_box_scene().get_walkthrough().cameras,
                          0.5};
    const PosedGeometry geometry = pose_geometry(scene, 0.0);
    RayTracer tracer;
    tracer.update(geometry);
    TraceSettings settings;
    settings.target = {0.5, Falloff::none, Weighting::cosine, Normals::shading};
    const std::vector<float> visibility =
        tracer.trace_points(list_vertex_points(geometry, 0.02), settings);
    // Facets of 12 rings rise by 7.5 degrees above the shading normal's horizon at their corners:
    // of the cosine-weighted hemisphere a tenth at most.
    EXPECT_GT(*std::min_element(visibility.begin(), visibility.end()), 0.9f);
}

using BakedVertexAoTest = GlTest;

TEST_F(BakedVertexAoTest, AFrameDoesNotDependOnTheOnesBefore) {
    const TestScene scene = make_box_scene();
    const MethodUnit unit = baked_vertex_ao_unit();
    const ResolvedParameters resolved = unit.parameters.resolve({}, {{"scene_radius", 0.5}});
    const auto shoot_frames = [&](std::vector<int> frames) {
        const auto method = unit.create(context(), resolved);
        return hash_image(
            shoot(context(), *method, scene, {{96, 72}, std::move(frames), nullptr}).visibility);
    };
    EXPECT_EQ(shoot_frames({1}), shoot_frames({0, 1}));
    EXPECT_NE(shoot_frames({1}), shoot_frames({0}));
}

} // namespace
} // namespace alcove
