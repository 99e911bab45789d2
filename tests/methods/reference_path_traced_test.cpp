// The path-traced reference as a method among methods: what it maps, and that its image is the
// tracer's.
#include "methods/reference_path_traced/reference_path_traced.hpp"

#include "tests/core/gl/test_context.hpp"
#include "tests/methods/traced_light_rig.hpp"
#include "tests/test_scenes.hpp"

#include <cmath>

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

} // namespace
} // namespace alcove
