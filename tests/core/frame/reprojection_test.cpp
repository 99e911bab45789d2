// Motion and reprojection against positions that are known: finite differences of rigid motion, in
// double.

#include "core/frame/reprojection.hpp"

#include "core/frame/scene_renderer.hpp"
#include "tests/core/gl/test_context.hpp"
#include "tests/test_scenes.hpp"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace alcove {
namespace {

constexpr ImageSize kSize{128, 96};
constexpr ChannelSet kChannels{Channel::eye_depth, Channel::normal, Channel::motion,
                               Channel::instance_id};

/// A floor, a box that turns and drifts, a ball at rest; the camera moves and turns.
TestScene make_moving_scene(const glm::dvec3& box_step = {0.03, 0.01, -0.02},
                            const glm::dvec3& origin = glm::dvec3(0.0)) {
    std::vector<Mesh> meshes{make_quad({-6, 0, 6}, {6, 0, 6}, {6, 0, -6}, {-6, 0, -6}),
                             make_box({-0.6f, -0.1f, -0.6f}, {0.6f, 1.2f, 0.6f}),
                             make_sphere({1.4f, 0.5f, 0.4f}, 0.5f, 24)};
    std::vector<glm::dmat4> transforms(meshes.size(), glm::dmat4(1.0));
    const auto camera = [](const glm::dvec3& position) {
        return make_look_at_camera(position, {0.2, 0.5, 0.0}, {0.0, 1.0, 0.0},
                                   std::numbers::pi / 3.0, 0.1, 100.0);
    };
    return {std::move(meshes),
            std::move(transforms),
            {camera({1.5, 1.6, 3.6}), camera({1.56, 1.62, 3.55})},
            0.5,
            origin,
            {{1, box_step, 5.0 * std::numbers::pi / 180.0}}};
}

class ReprojectionTest : public GlTest {
  protected:
    SurfaceImages render(const Scene& scene, const FrameView& view, const Precision& precision) {
        const GBuffer gbuffer(gl(), kSize, kChannels, precision);
        SceneRenderer renderer(gl(), scene);
        context().reset_state();
        renderer.render(gbuffer, view);
        return {gl::read_texture(gl(), gbuffer.texture(Channel::eye_depth), 1),
                gl::read_texture(gl(), gbuffer.texture(Channel::normal), 3),
                gl::read_texture(gl(), gbuffer.texture(Channel::motion), 3),
                gl::read_texture(gl(), gbuffer.texture(Channel::instance_id), 1)};
    }
    static FrameView get_view(const Scene& scene, int frame) {
        return make_frame_view(scene.get_walkthrough(), frame, kSize, false);
    }
    static Precision get_full_precision() { return parse_precision("motion=32F"); }
};

glm::dvec3 get_vector(const Image& image, int x, int y) {
    return {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)};
}

/// Where the surface point of a pixel stands in the world, from its depth.
glm::dvec3 find_world_position(const FrameView& view, const SurfaceImages& images, int x, int y) {
    const glm::dvec3 direction =
        compute_pixel_direction(view.camera, view.size, {x + 0.5, y + 0.5});
    return view.camera.position + direction * static_cast<double>(images.eye_depth.at(x, y));
}

TEST_F(ReprojectionTest, MotionIsTheFiniteDifferenceOfPositionsOnRigidMotion) {
    const TestScene scene = make_moving_scene();
    const FrameView view = get_view(scene, 1);
    const Pose now = scene.compute_pose(view.time_s);
    const Pose before = scene.compute_pose(view.previous_time_s);
    for (const char* precision : {"motion=32F", "motion=16F"}) {
        const bool is_half = parse_precision(precision).motion == MotionPrecision::float16;
        const SurfaceImages images = render(scene, view, parse_precision(precision));
        int moved = 0;
        for (int y = 0; y < kSize.height; ++y) {
            for (int x = 0; x < kSize.width; ++x) {
                const auto id = static_cast<std::size_t>(images.instance_id.at(x, y));
                if (id == 0) {
                    continue;
                }
                const glm::dvec3 position = find_world_position(view, images, x, y);
                const glm::dvec4 on_object =
                    glm::inverse(now.object_to_world[id - 1]) * glm::dvec4(position, 1.0);
                const glm::dvec3 expected =
                    glm::dvec3(before.object_to_world[id - 1] * on_object) - position;
                const glm::dvec3 motion = get_vector(images.motion, x, y);
                moved += glm::length(motion) > 0.0 ? 1 : 0;
                // 32F: interpolation over the triangle and the depth's 24 bits; 16F truncates at
                // 2^-10 relative, half a step more near 0.
                const double tolerance = is_half ? 0.1 * 0x1p-10 + 2e-6 : 2e-6;
                ASSERT_LT(glm::length(motion - expected), tolerance)
                    << precision << " at " << x << ", " << y;
            }
        }
        EXPECT_GT(moved, 500);
    }
}

TEST_F(ReprojectionTest, AReprojectedPointIsWhereTheOldCameraSawIt) {
    for (const glm::dvec3& origin : {glm::dvec3(0.0), glm::dvec3(1e7, -1e7, 1e7)}) {
        const TestScene scene = make_moving_scene({0.03, 0.01, -0.02}, origin);
        const FrameView view = get_view(scene, 1);
        const Reprojection reprojection = make_reprojection(view);
        const glm::dvec3 view_position(0.3, -0.2, -2.5);
        const glm::dvec3 motion(0.01, -0.02, 0.03);
        const glm::dvec3 old_world =
            view.camera.position + view.camera.world_from_view * view_position + motion;
        const glm::dvec3 expected = glm::transpose(view.previous_camera.world_from_view) *
                                    (old_world - view.previous_camera.position);
        const glm::dvec3 old = reproject(reprojection, view_position, motion);
        // 1e7 m leave 2e-9 m of a double.
        EXPECT_LT(glm::distance(old, expected), 1e-8);
        // The pixel that the old camera's own direction goes through.
        const glm::dvec2 place = project_previous(reprojection, old).value();
        const glm::dvec3 direction = compute_pixel_direction(
            view.previous_camera, kSize, {place.x * kSize.width, place.y * kSize.height});
        const glm::dvec3 ray =
            glm::transpose(view.previous_camera.world_from_view) * direction * -old.z;
        EXPECT_LT(glm::distance(ray, old), 1e-8);
    }
}

TEST_F(ReprojectionTest, NothingBehindTheOldCameraHasAPlace) {
    EXPECT_FALSE(project_previous({}, {0.0, 0.0, 0.5}).has_value());
    EXPECT_FALSE(project_previous({}, {0.0, 0.0, 0.0}).has_value());
}

TEST_F(ReprojectionTest, CorrespondingPixelsShowTheSamePointOfTheSameObject) {
    const TestScene scene = make_moving_scene();
    const FrameView first = get_view(scene, 0);
    const FrameView view = get_view(scene, 1);
    const SurfaceImages before = render(scene, first, get_full_precision());
    const SurfaceImages now = render(scene, view, get_full_precision());
    const Correspondence found = make_correspondence(view, now, before);
    const Pose pose_now = scene.compute_pose(view.time_s);
    const Pose pose_before = scene.compute_pose(first.time_s);
    int valid = 0;
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            if (found.valid.at(x, y) == 0.0f) {
                continue;
            }
            ++valid;
            const auto id = static_cast<std::size_t>(now.instance_id.at(x, y));
            const glm::dvec3 position = find_world_position(view, now, x, y);
            const glm::dvec3 old(pose_before.object_to_world[id - 1] *
                                 glm::inverse(pose_now.object_to_world[id - 1]) *
                                 glm::dvec4(position, 1.0));
            const glm::dvec3 direction = compute_pixel_direction(
                first.camera, kSize, {found.position.at(x, y, 0), found.position.at(x, y, 1)});
            const double along =
                glm::dot(old - first.camera.position, direction) / glm::dot(direction, direction);
            // A thousandth of a pixel, to which places are snapped, at the far end of the floor, 8
            // m.
            ASSERT_LT(glm::distance(first.camera.position + along * direction, old), 1e-4);
            ASSERT_EQ(found.appeared.at(x, y), 0.0f);
        }
    }
    EXPECT_GT(valid, kSize.width * kSize.height / 3);
}

TEST_F(ReprojectionTest, UnderAStillCameraAtRestAllButEdgesIsValidAndNothingAppears) {
    const TestScene scene = make_moving_scene();
    const FrameView view = hold(get_view(scene, 0));
    const SurfaceImages images = render(scene, view, get_full_precision());
    const Correspondence found = make_correspondence(view, images, images);
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            ASSERT_EQ(found.appeared.at(x, y), 0.0f);
            const bool is_surface = images.instance_id.at(x, y) != 0.0f;
            if (is_surface) {
                ASSERT_EQ(found.position.at(x, y, 0), static_cast<float>(x) + 0.5f) << "exactly";
                ASSERT_EQ(found.position.at(x, y, 1), static_cast<float>(y) + 0.5f) << "exactly";
            }
            bool borders_background = false;
            for (int dy = -1; dy <= 1; ++dy) {
                for (int dx = -1; dx <= 1; ++dx) {
                    const bool inside =
                        x + dx >= 0 && y + dy >= 0 && x + dx < kSize.width && y + dy < kSize.height;
                    borders_background = borders_background ||
                                         (inside && images.instance_id.at(x + dx, y + dy) == 0.0f);
                }
            }
            ASSERT_EQ(found.valid.at(x, y) != 0.0f, !borders_background) << x << ", " << y;
        }
    }
}

TEST_F(ReprojectionTest, WhatAMovingObjectUncoversHasAppeared) {
    const TestScene scene = make_moving_scene({0.3, 0.0, 0.0});
    FrameView view = get_view(scene, 1);
    view.previous_camera = view.camera;
    FrameView first = get_view(scene, 0);
    first.camera = view.camera;
    const SurfaceImages before = render(scene, first, get_full_precision());
    const SurfaceImages now = render(scene, view, get_full_precision());
    const Correspondence found = make_correspondence(view, now, before);
    constexpr float kFloor = 1.0f;
    int uncovered = 0;
    for (int y = 1; y + 1 < kSize.height; ++y) {
        for (int x = 1; x + 1 < kSize.width; ++x) {
            if (now.instance_id.at(x, y) != kFloor) {
                continue;
            }
            // Edges that moved by a fraction of a pixel leave slivers: those do not count.
            bool was_near_floor = false;
            for (int dy = -1; dy <= 1; ++dy) {
                for (int dx = -1; dx <= 1; ++dx) {
                    was_near_floor =
                        was_near_floor || before.instance_id.at(x + dx, y + dy) == kFloor;
                }
            }
            ASSERT_EQ(found.appeared.at(x, y) != 0.0f, !was_near_floor) << x << ", " << y;
            uncovered += was_near_floor ? 0 : 1;
        }
    }
    EXPECT_GT(uncovered, 5);
}

TEST_F(ReprojectionTest, WithoutHistoryNothingIsValidAndAllSurfacesHaveAppeared) {
    const TestScene scene = make_moving_scene();
    const FrameView view = make_frame_view(scene.get_walkthrough(), 1, kSize, true);
    const SurfaceImages images = render(scene, view, get_full_precision());
    const Correspondence found = make_correspondence(view, images, images);
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            ASSERT_EQ(found.valid.at(x, y), 0.0f);
            ASSERT_EQ(found.appeared.at(x, y) != 0.0f, images.instance_id.at(x, y) != 0.0f);
        }
    }
}

TEST_F(ReprojectionTest, ABorderAddsPixelsAndMovesNone) {
    const TestScene scene = make_moving_scene();
    const FrameView view = get_view(scene, 1);
    const Border border = make_border(kSize, 0.075);
    EXPECT_EQ(border, (Border{10, 8}));
    const FrameView extended = extend(view, border);
    EXPECT_EQ(extended.size, (ImageSize{148, 112}));
    for (const glm::dvec2& pixel :
         {glm::dvec2(0.5, 0.5), {127.5, 0.5}, {64.0, 48.0}, {3.5, 95.5}}) {
        const glm::dvec3 plain = compute_pixel_direction(view.camera, view.size, pixel);
        const glm::dvec3 inside = compute_pixel_direction(extended.camera, extended.size,
                                                          pixel + glm::dvec2(border.x, border.y));
        EXPECT_LT(glm::distance(plain, inside), 1e-12);
    }
}

} // namespace
} // namespace alcove
