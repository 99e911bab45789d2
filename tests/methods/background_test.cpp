// What a picture shows behind everything: the rasteriser's against the tracer's.
#include "core/frame/compose.hpp"
#include "core/frame/scene_renderer.hpp"
#include "scenes/common/lighting.hpp"
#include "tests/core/gl/test_context.hpp"
#include "tests/methods/traced_light_rig.hpp"

#include <cmath>
#include <numbers>

namespace alcove {
namespace {

class BackgroundTest : public GlTest {
  protected:
    [[nodiscard]] static Image compose(const LitScene& scene) {
        SceneRenderer renderer(gl(), scene);
        const GBuffer gbuffer(gl(), kTracedSize, kBaseChannels, {});
        const FrameView view = make_frame_view(scene.get_walkthrough(), 0, kTracedSize, true);
        context().reset_state();
        renderer.render(gbuffer, view);
        const gl::Texture visibility(gl(), GL_R32F, kTracedSize);
        gl::write_texture(gl(), visibility, Image(kTracedSize, 1, 1.0f));
        Surroundings surroundings(gl());
        surroundings.update(scene.get_lights());
        Compose compose(gl(), kTracedSize);
        PassRecorder recorder(PassTiming::none);
        context().reset_state();
        compose.render(gbuffer, surroundings.look_through(view.camera), view.camera,
                       {.visibility = &visibility}, recorder);
        context().check_errors();
        return gl::read_texture(gl(), compose.picture(), 3);
    }
};

TEST_F(BackgroundTest, ComposedBackgroundIsTheTracedOneInEveryDirection) {
    // Behind every camera below; a scene needs a surface.
    LitScene scene({make_wall(1.0f, 20.0f)});
    Lights lights;
    lights.environment = std::make_shared<const Environment>(
        make_environment(SurroundingLight::high_frequency, 1.0));
    lights.environment_turn_radians = 0.3;
    scene.set_lights(lights);
    PathSettings settings;
    settings.rays_per_half = 1;
    // Down is where the octahedral map's border lies.
    for (const glm::dvec3& target : {glm::dvec3(0.0, 0.0, -1.0), glm::dvec3(1.0, 0.0, 0.0),
                                     glm::dvec3(0.0, 1.0, 0.0), glm::dvec3(0.0, -1.0, 0.0)}) {
        const glm::dvec3 up =
            target.y == 0.0 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(0.0, 0.0, -1.0);
        scene.set_camera(
            make_look_at_camera(glm::dvec3(0.0), target, up, std::numbers::pi / 3.0, 0.1, 1000.0));
        const Camera& camera = scene.get_walkthrough().cameras[0];
        const Image picture = compose(scene);
        const Image truth = trace_light(scene, camera, lights, settings).indirect.a;
        int off_texels = 0;
        for (int y = 0; y < kTracedSize.height; ++y) {
            for (int x = 0; x < kTracedSize.width; ++x) {
                const glm::vec3 traced = get_pixel(truth, x, y);
                const glm::vec3 texel = compute_surrounding_radiance(
                    lights, compute_pixel_direction(camera, kTracedSize, {x + 0.5, y + 0.5}));
                off_texels += std::abs(traced.y - texel.y) > 0.01f ? 1 : 0;
                for (int channel = 0; channel < 3; ++channel) {
                    // Half floats of the picture: 2^-11 of the value. 128 texels times the rounding
                    // of a direction: 1e-4 of the contrast between neighbours.
                    ASSERT_NEAR(picture.at(x, y, channel), traced[channel],
                                0.0005f * traced[channel] + 0.0005f)
                        << target.x << " " << target.y << " at " << x << " " << y;
                }
            }
        }
        EXPECT_GT(off_texels, 100); // of 1728: not the light of single texels
    }
}

} // namespace
} // namespace alcove
