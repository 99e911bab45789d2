// The path-traced reference as a method among methods: what it maps, and that its image is the
// tracer's.
#include "methods/reference_path_traced/reference_path_traced.hpp"

#include "core/frame/scene_renderer.hpp"
#include "tests/core/gl/test_context.hpp"
#include "tests/methods/traced_light_rig.hpp"
#include "tests/test_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>

namespace alcove {
namespace {

using ReferencePathTracedTest = GlTest;

TEST_F(ReferencePathTracedTest, MapsAllOfATargetButUniformWeighting) {
    const MethodUnit unit = reference_path_traced_unit();
    for (const Falloff falloff : {Falloff::none, Falloff::linear, Falloff::quadratic}) {
        for (const Weighting weighting : {Weighting::cosine, Weighting::uniform}) {
            for (const Normals normals : {Normals::shading, Normals::geometric}) {
                const TargetMapping mapping = unit.map_target({0.37, falloff, weighting, normals});
                EXPECT_EQ(mapping.reason.empty(), weighting == Weighting::cosine);
                const auto params = unit.parameters.bind<ReferencePathTracedParams>(
                    unit.parameters.resolve(mapping.overrides, {{"scene_radius", 0.5}}));
                EXPECT_EQ(params.radius, 0.37);
                EXPECT_EQ(params.falloff, falloff);
                EXPECT_EQ(params.normals, normals);
            }
        }
    }
}

TEST_F(ReferencePathTracedTest, ItsImagesAreTheTracersUpToHalfFloats) {
    const TestScene scene = make_box_scene();
    const PosedGeometry geometry = pose_geometry(scene, 0.0);
    const FrameView view = make_frame_view(scene.get_walkthrough(), 0, kTracedSize, false);
    const MethodUnit unit = reference_path_traced_unit();
    struct Case {
        std::vector<ParameterOverride> overrides;
        PathSettings settings;
    };
    PathSettings settings;
    settings.radius_m = 0.5;
    settings.seed = 99;
    // An odd number of rays is rounded down: 16 in each half.
    settings.rays_per_half = 16;
    std::vector<Case> cases(3, Case{{{"rays", "33"}}, settings});
    cases[0].overrides.push_back({"falloff", "quadratic"});
    cases[0].settings.falloff = Falloff::quadratic;
    cases[1].overrides.push_back({"reach", "full"});
    cases[1].settings.reach = PathReach::full;
    cases[2].overrides.push_back({"bounces", "0"});
    cases[2].settings.bounces = 0;
    cases[2].overrides.push_back({"normals", "geometric"});
    cases[2].settings.normals = Normals::geometric;
    const GBuffer gbuffer(gl(), kTracedSize, kBaseChannels, {});
    for (const Case& c : cases) {
        const auto method =
            unit.create(context(), unit.parameters.resolve(c.overrides, {{"scene_radius", 0.5}}));
        EXPECT_TRUE(method->get_requests().posed_geometry);
        method->resize(kTracedSize);
        PassRecorder passes(PassTiming::none);
        MethodInputs inputs{view, gbuffer};
        inputs.geometry = &geometry;
        inputs.lights = &scene.get_lights();
        inputs.noise_seed = 99;
        const MethodOutput output = method->render(inputs, passes);
        const TracedRadiance expected =
            trace_light(scene, view.camera, scene.get_lights(), c.settings);
        EXPECT_EQ(hash_image(gl::read_texture(gl(), *output.visibility, 1)),
                  hash_image(expected.visibility));
        const Image radiance = gl::read_texture(gl(), *output.radiance, 3);
        const Image mean = compute_mean(expected.indirect);
        for (std::size_t i = 0; i < mean.values().size(); ++i) {
            ASSERT_NEAR(radiance.values()[i], mean.values()[i],
                        mean.values()[i] * 0x1p-10f + 1e-7f);
        }
        EXPECT_EQ(passes.names(), std::vector<std::string>{"reference_path_traced/trace"});
    }
}

/// Of the shared channels of both, the share of pixels that differ by more than `tolerance`: pixel
/// centres on edges fall to either side.
double compute_share_apart(const Image& a, const Image& b, float tolerance) {
    int apart = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const glm::vec3 difference = glm::abs(get_pixel(a, x, y) - get_pixel(b, x, y));
            apart += std::max({difference.x, difference.y, difference.z}) > tolerance ? 1 : 0;
        }
    }
    return apart / static_cast<double>(a.size().pixel_count());
}

/// The base channel as it is rasterised.
class RasterisedTest : public GlTest {
  protected:
    Image rasterise(const Scene& scene, Channel channel) {
        const GBuffer gbuffer(gl(), kTracedSize, kBaseChannels, {});
        SceneRenderer renderer(gl(), scene);
        context().reset_state();
        renderer.render(gbuffer, make_frame_view(scene.get_walkthrough(), 0, kTracedSize, false));
        return gl::read_texture(gl(), gbuffer.texture(channel), 3);
    }
};

TEST_F(RasterisedTest, LightWithoutShadowsIsTheTracersDirectLight) {
    const TestScene scene = make_box_scene();
    ASSERT_FALSE(scene.get_lights().directional.front().casts_shadow);
    const Image direct = trace_light(scene, scene.get_walkthrough().cameras[0], scene.get_lights(),
                                     PathSettings{.rays_per_half = 1})
                             .direct;
    EXPECT_GT(compute_average(direct).x, 0.1);
    // Albedo, normal and light are rounded to the channels' formats.
    EXPECT_LT(compute_share_apart(rasterise(scene, Channel::direct_light), direct, 0.01f), 0.01);
}

TEST_F(RasterisedTest, AlbedoIsTheTracers) {
    // Two texels over a wall that fills the image, each larger than ten pixels, by vertex colours.
    Mesh wall = paint(make_wall(4.0f, -4.0f), {1.0f, 0.7f, 0.4f});
    wall.texture = 0;
    for (const glm::vec3& p : wall.positions) {
        wall.texture_coordinates.emplace_back(0.8f + 0.1f * p.x, 0.3f - 0.1f * p.y);
        wall.colors.emplace_back(0.5f + 0.125f * p.x, 1.0f, 0.5f + 0.125f * p.y);
    }
    const LitScene scene(
        {wall}, {{"texels", {2, 2}, {255, 0, 188, 0, 255, 188, 128, 128, 188, 0, 0, 188}}});
    Lights lights = make_surroundings(glm::vec3(0.0f));
    lights.directional.push_back({{0.0, 0.0, 1.0}, glm::vec3(std::numbers::pi_v<float>), false});
    const Image albedo =
        trace_light(scene, make_forward_camera(), lights, PathSettings{.rays_per_half = 1}).direct;
    // 8 bits, and 8 bits of the texture filter's weights.
    EXPECT_EQ(compute_share_apart(rasterise(scene, Channel::albedo), albedo, 2.0f / 255.0f), 0.0);
}

} // namespace
} // namespace alcove
