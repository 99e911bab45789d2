#include "core/frame/scene_renderer.hpp"

#include "core/base/error.hpp"
#include "core/frame/compose.hpp"
#include "tests/core/gl/test_context.hpp"
#include "tests/test_scenes.hpp"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

constexpr ImageSize kSize{96, 64};

class SceneRendererTest : public GlTest {
  protected:
    struct Rendered {
        Image eye_depth;
        Image normal;
        Image motion;
        Image instance_id;
        Image motion_depth;
    };
    Rendered render(const Scene& scene, const Precision& precision = {}, int frame = 0) {
        const ChannelSet channels =
            kBaseChannels |
            ChannelSet{Channel::motion, Channel::instance_id, Channel::motion_depth};
        const GBuffer gbuffer(gl(), kSize, channels, precision);
        SceneRenderer renderer(gl(), scene);
        context().reset_state();
        renderer.render(gbuffer, make_frame_view(scene.get_walkthrough(), frame, kSize, false));
        return {gl::read_texture(gl(), gbuffer.texture(Channel::eye_depth), 1),
                gl::read_texture(gl(), gbuffer.texture(Channel::normal), 3),
                gl::read_texture(gl(), gbuffer.texture(Channel::motion), 3),
                gl::read_texture(gl(), gbuffer.texture(Channel::instance_id), 1),
                gl::read_texture(gl(), gbuffer.texture(Channel::motion_depth), 4)};
    }
};

TEST_F(SceneRendererTest, APlaneHasItsAnalyticDepthInEveryPrecision) {
    const double tilt = 40.0 * std::numbers::pi / 180.0;
    const TestScene scene = make_plane_scene(tilt);
    const Camera& camera = scene.get_walkthrough().cameras[0];
    for (const char* text :
         {"raster_depth=32F,eye_depth=32F", "raster_depth=32F,reversed,eye_depth=raster",
          "raster_depth=24,eye_depth=raster", "raster_depth=24,reversed,eye_depth=raster",
          "raster_depth=16,eye_depth=16F", "raster_depth=16,eye_depth=raster"}) {
        const Precision precision = parse_precision(text);
        const Rendered rendered = render(scene, precision);
        // Quantisation of the stored value: half floats are truncated here, 2^-10 relative. A step
        // of the raster depth (2^-16 or 2^-24) is step * e^2 / n in eye depth; llvmpipe
        // interpolates depth over this triangle of 400 m in float, which was measured to cost 12.5
        // steps of 24 bits.
        double largest = 0.0;
        for (int y = 0; y < kSize.height; ++y) {
            for (int x = 0; x < kSize.width; ++x) {
                const glm::dvec3 d = compute_pixel_direction(camera, kSize, {x + 0.5, y + 0.5});
                const double expected = intersect_test_plane(camera.position, d, tilt);
                double tolerance = 4e-6 * expected;
                if (precision.eye_depth == EyeDepth::float16) {
                    tolerance = expected * 0x1p-10;
                } else if (precision.eye_depth == EyeDepth::from_raster) {
                    const bool is_16 = precision.raster_depth == RasterDepth::unorm16;
                    const double step = is_16 ? 0x1p-16 : 16.0 * 0x1p-24;
                    tolerance += step * expected * expected / camera.near_m;
                }
                largest =
                    std::max(largest, std::abs(rendered.eye_depth.at(x, y) - expected) / tolerance);
            }
        }
        EXPECT_LT(largest, 1.0) << text;
    }
}

TEST_F(SceneRendererTest, NormalsAreInViewSpaceAndFaceTheViewer) {
    const double tilt = 40.0 * std::numbers::pi / 180.0;
    const Rendered rendered = render(make_plane_scene(tilt));
    // Half floats: 2^-11 a component.
    EXPECT_NEAR(rendered.normal.at(48, 32, 0), 0.0, 5e-4);
    EXPECT_NEAR(rendered.normal.at(48, 32, 1), std::sin(tilt), 5e-4);
    EXPECT_NEAR(rendered.normal.at(48, 32, 2), std::cos(tilt), 5e-4);
}

TEST_F(SceneRendererTest, TheBackgroundIsInfinitelyFar) {
    const Rendered rendered = render(make_box_scene());
    EXPECT_TRUE(std::isinf(rendered.eye_depth.at(0, 0)));
    EXPECT_TRUE(std::isfinite(rendered.eye_depth.at(48, 40)));
}

TEST_F(SceneRendererTest, AWorldFarFromZeroLooksTheSame) {
    const Rendered near_zero = render(make_box_scene());
    const Rendered far_away = render(make_box_scene(glm::dvec3(1e7, -1e7, 1e7)));
    for (std::size_t i = 0; i < near_zero.eye_depth.values().size(); ++i) {
        const float a = near_zero.eye_depth.values()[i];
        const float b = far_away.eye_depth.values()[i];
        // An edge may move by rounding; no surface may.
        if (std::isfinite(a) && std::isfinite(b)) {
            ASSERT_NEAR(a, b, 1e-4);
        }
    }
}

TEST_F(SceneRendererTest, MotionIsThatOfTheObjectAndZeroForStaticOnesUnderAMovingCamera) {
    const TestScene scene = make_box_scene();
    const Rendered rendered = render(scene, {}, 1);
    int moved = 0;
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            // The canary's object 3 steps by (0.02, 0.2, 0); half floats, truncated (2^-10
            // relative).
            const bool moves = rendered.instance_id.at(x, y) == 3.0f;
            moved += moves ? 1 : 0;
            ASSERT_NEAR(rendered.motion.at(x, y, 0), moves ? -0.02f : 0.0f, moves ? 2e-5 : 0.0);
            ASSERT_NEAR(rendered.motion.at(x, y, 1), moves ? -0.2f : 0.0f, moves ? 2e-4 : 0.0);
            ASSERT_EQ(rendered.motion.at(x, y, 2), 0.0f);
        }
    }
    EXPECT_GT(moved, 100);
}

TEST_F(SceneRendererTest, MotionAndDepthInOneTexelAreTheSameInFullPrecision) {
    const TestScene scene = make_box_scene();
    const Rendered rendered = render(scene, parse_precision("motion=32F"), 1);
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            for (int c = 0; c < 3; ++c) {
                ASSERT_EQ(rendered.motion_depth.at(x, y, c), rendered.motion.at(x, y, c));
            }
            ASSERT_EQ(rendered.motion_depth.at(x, y, 3), rendered.eye_depth.at(x, y));
        }
    }
}

TEST_F(SceneRendererTest, ComposeIsDirectPlusAmbientTimesAlbedoTimesVisibility) {
    const TestScene scene = make_box_scene();
    const GBuffer gbuffer(gl(), kSize, kBaseChannels, {});
    SceneRenderer renderer(gl(), scene);
    const FrameView view = make_frame_view(scene.get_walkthrough(), 0, kSize, true);
    context().reset_state();
    renderer.render(gbuffer, view);
    const gl::Texture visibility(gl(), GL_R32F, kSize);
    gl::write_texture(gl(), visibility, Image(kSize, 1, 0.25f));
    Lights lights;
    lights.ambient = glm::vec3(0.5f);
    Surroundings surroundings(gl());
    surroundings.update(lights);
    Compose compose(gl(), kSize);
    PassRecorder recorder(PassTiming::none);
    context().reset_state();
    compose.render(gbuffer, surroundings.look_through(view.camera), view.camera,
                   {.visibility = &visibility}, recorder);
    const Image picture = gl::read_texture(gl(), compose.picture(), 3);
    const Image albedo = gl::read_texture(gl(), gbuffer.texture(Channel::albedo), 3);
    const Image direct = gl::read_texture(gl(), gbuffer.texture(Channel::direct_light), 3);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(picture.at(48, 40, c),
                    direct.at(48, 40, c) + 0.5f * 0.25f * albedo.at(48, 40, c), 1e-3);
        EXPECT_NEAR(picture.at(0, 0, c), 0.5f, 1e-3);
    }
    ASSERT_EQ(recorder.names().size(), 1u);
    EXPECT_EQ(recorder.names()[0], "harness/compose");
}

} // namespace
} // namespace alcove
