// Converged tssao against hemisphere_ssao with 32 samples and its blur: AO passes plus input cost,
// still camera, 384x288, wall time fenced by glFinish, in turn. The target is asked of a scene at
// rest; the line below tells the same where an object moves out of sight, so that every pixel's
// neighbourhood is tested. With settings as arguments
// ("packing=packed") it times that configuration instead of the default one.

#include "core/base/statistics.hpp"
#include "core/base/text.hpp"
#include "core/frame/scene_renderer.hpp"
#include "methods/hemisphere_ssao/hemisphere_ssao.hpp"
#include "methods/tssao/tssao.hpp"
#include "scenes/registry.hpp"
#include "tests/benchmark/ratio.hpp"

#include <cstdio>

namespace {

using namespace alcove;

constexpr ImageSize kSize{384, 288};
constexpr int kFrame = 60;
constexpr int kPairs = 31;

std::unique_ptr<Method> make_method(gl::Context& context, const MethodUnit& unit,
                                    const std::string& preset, const std::string& settings,
                                    double radius_m, int& warm_frames) {
    std::vector<ParameterOverride> overrides = unit.find_preset(preset).overrides;
    if (!settings.empty()) {
        for (const KeyValue& entry : parse_key_values(settings, "settings")) {
            overrides.push_back({entry.key, entry.value});
        }
    }
    const ResolvedParameters resolved =
        unit.parameters.resolve(overrides, {{"scene_radius", radius_m}});
    warm_frames = unit.warm_frames(resolved);
    auto method = unit.create(context, resolved);
    method->resize(kSize);
    return method;
}

class Stage {
  public:
    Stage(gl::Context& context, const Scene& scene)
        : m_context(context), m_renderer(context.functions(), scene),
          m_view(hold(make_frame_view(scene.get_walkthrough(), kFrame, kSize, true))) {}

    /// What the frame says of objects that are not seen.
    void let_objects_move(bool may_move) { m_view.objects_may_move = may_move; }

    double time_gbuffer(const GBuffer& gbuffer) {
        m_context.reset_state();
        m_context.functions().Finish();
        return time_call([&] {
            m_renderer.render(gbuffer, m_view);
            m_context.functions().Finish();
        });
    }
    double time_method(Method& method, const GBuffer& gbuffer) {
        m_context.reset_state();
        m_context.functions().Finish();
        PassRecorder passes(PassTiming::none);
        MethodInputs inputs{m_view, gbuffer};
        inputs.noise_seed = 1;
        return time_call([&] {
            static_cast<void>(method.render(inputs, passes));
            m_context.functions().Finish();
        });
    }

  private:
    gl::Context& m_context;
    SceneRenderer m_renderer;
    FrameView m_view;
};

bool measure(gl::Context& context, const std::string& name, const std::string& settings) {
    const Registry<SceneUnit> scenes = scenes_registry();
    const SceneUnit& unit = scenes.find(name);
    if (const auto obstacle = unit.find_obstacle()) {
        std::printf("# %s: %s\n", name.c_str(), obstacle->c_str());
        return true;
    }
    const std::unique_ptr<Scene> scene = unit.open(unit.parameters.resolve({}, {}));
    Stage stage(context, *scene);
    int warm_frames = 0;
    const auto ssao = make_method(context, hemisphere_ssao_unit(), "paper_weak_blur", "",
                                  scene->get_ao_radius_m(), warm_frames);
    const auto tssao = make_method(context, tssao_unit(), "default", settings,
                                   scene->get_ao_radius_m(), warm_frames);
    const gl::Functions& gl = context.functions();
    const GBuffer base(gl, kSize, kBaseChannels, {});
    const GBuffer extended(gl, kSize, kBaseChannels | tssao->get_requests().channels, {});
    stage.time_gbuffer(base);
    stage.time_gbuffer(extended);
    for (int i = 0; i < warm_frames; ++i) {
        stage.time_method(*tssao, extended);
    }
    stage.time_method(*ssao, base);
    stage.let_objects_move(true);
    stage.time_method(*tssao, extended);
    stage.let_objects_move(false);
    std::vector<double> ratios;
    std::vector<double> ratios_beside_movers;
    std::vector<double> parts[3];
    for (int i = 0; i < kPairs; ++i) {
        const double input_s = stage.time_gbuffer(extended) - stage.time_gbuffer(base);
        const double tssao_s = stage.time_method(*tssao, extended);
        const double ssao_s = stage.time_method(*ssao, base);
        ratios.push_back((tssao_s + input_s) / ssao_s);
        stage.let_objects_move(true);
        ratios_beside_movers.push_back((stage.time_method(*tssao, extended) + input_s) / ssao_s);
        stage.let_objects_move(false);
        parts[0].push_back(tssao_s);
        parts[1].push_back(input_s);
        parts[2].push_back(ssao_s);
    }
    std::printf("# %s, medians: tssao %.2f ms, its input %.2f ms, hemisphere_ssao %.2f ms\n",
                name.c_str(), 1e3 * compute_median(parts[0]), 1e3 * compute_median(parts[1]),
                1e3 * compute_median(parts[2]));
    std::printf("# %s, where an object moves elsewhere: %.3f (median, n=%zu)\n", name.c_str(),
                compute_median(ratios_beside_movers), ratios_beside_movers.size());
    return print_target("converged tssao / SSAO-32 with blur, " + name, 0.55, false, ratios);
}

} // namespace

int main(int count, char** arguments) {
    const std::string settings = count > 1 ? arguments[1] : "";
    const std::unique_ptr<gl::Context> context = gl::open_context(gl::ContextKind::autodetect);
    bool met = true;
    for (const char* scene : {"bunny", "cathedral"}) {
        met = measure(*context, scene, settings) && met;
    }
    return met ? 0 : 3;
}
