// The reference as a method among methods: what it maps, and that its image is the tracer's.
#include "methods/common/ray_tracer.hpp"
#include "methods/reference_ray_traced/reference_ray_traced.hpp"
#include "tests/core/gl/test_context.hpp"
#include "tests/test_scenes.hpp"

namespace alcove {
namespace {

constexpr ImageSize kSize{48, 36};

using ReferenceMethodTest = GlTest;

TEST_F(ReferenceMethodTest, MapsTheWholeOfEveryTarget) {
    const MethodUnit unit = reference_ray_traced_unit();
    for (const Falloff falloff : {Falloff::none, Falloff::linear, Falloff::quadratic}) {
        for (const Weighting weighting : {Weighting::cosine, Weighting::uniform}) {
            for (const Normals normals : {Normals::shading, Normals::geometric}) {
                const TargetMapping mapping = unit.map_target({0.37, falloff, weighting, normals});
                EXPECT_TRUE(mapping.reason.empty()) << mapping.reason;
                const auto params = unit.parameters.bind<ReferenceRayTracedParams>(
                    unit.parameters.resolve(mapping.overrides, {{"scene_radius", 0.5}}));
                EXPECT_EQ(params.radius, 0.37);
                EXPECT_EQ(params.falloff, falloff);
                EXPECT_EQ(params.weighting, weighting);
                EXPECT_EQ(params.normals, normals);
            }
        }
    }
}

TEST_F(ReferenceMethodTest, ItsImageIsTheMeanOfTheTracersHalves) {
    const TestScene scene = make_box_scene();
    const PosedGeometry geometry = pose_geometry(scene, 0.0);
    const FrameView view = make_frame_view(scene.get_walkthrough(), 0, kSize, false);
    const MethodUnit unit = reference_ray_traced_unit();
    // An odd number of rays is rounded down: 16 in each half.
    const std::vector<ParameterOverride> overrides{{"rays", "33"}, {"falloff", "quadratic"}};
    const auto method =
        unit.create(context(), unit.parameters.resolve(overrides, {{"scene_radius", 0.5}}));
    EXPECT_TRUE(method->get_requests().posed_geometry);
    method->resize(kSize);
    const GBuffer gbuffer(gl(), kSize, kBaseChannels, {});
    PassRecorder passes(PassTiming::none);
    MethodInputs inputs{view, gbuffer};
    inputs.geometry = &geometry;
    inputs.noise_seed = 99;
    const MethodOutput output = method->render(inputs, passes);

    TraceSettings settings;
    settings.target = {0.5, Falloff::quadratic, Weighting::cosine, Normals::shading};
    settings.rays_per_half = 16;
    settings.seed = 99;
    RayTracer tracer;
    tracer.update(geometry);
    const Image expected = compute_mean(tracer.trace(view.camera, kSize, settings));
    EXPECT_EQ(hash_image(gl::read_texture(gl(), *output.visibility, 1)), hash_image(expected));
    EXPECT_EQ(passes.names(), std::vector<std::string>{"reference_ray_traced/trace"});
}

} // namespace
} // namespace alcove
