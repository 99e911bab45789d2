// statvo against crytek_ssao, as figure 12 of Hendrickx et al. 2015 compares them: AO passes, still
// camera, 1280x720, wall time fenced by glFinish, in turn. Lines with # give each pass in ns a
// pixel. With a preset and settings as arguments ("paper_quarter:numbers=integer") it times that
// configuration instead of the published one.

#include "core/base/statistics.hpp"
#include "core/base/text.hpp"
#include "core/frame/scene_renderer.hpp"
#include "methods/registry.hpp"
#include "scenes/registry.hpp"
#include "tests/benchmark/ratio.hpp"

#include <cstdio>
#include <map>

namespace {

using namespace alcove;

constexpr ImageSize kSize{1280, 720};
constexpr int kFrame = 60;
constexpr int kPairs = 15;

std::unique_ptr<Method> make_method(gl::Context& context, const MethodUnit& unit,
                                    const std::string& preset, const std::string& settings,
                                    double radius_m) {
    std::vector<ParameterOverride> overrides = unit.find_preset(preset).overrides;
    for (const KeyValue& entry :
         settings.empty() ? std::vector<KeyValue>{} : parse_key_values(settings, "settings")) {
        overrides.push_back({entry.key, entry.value});
    }
    auto method =
        unit.create(context, unit.parameters.resolve(overrides, {{"scene_radius", radius_m}}));
    method->resize(kSize);
    return method;
}

class Stage {
  public:
    Stage(gl::Context& context, const Scene& scene)
        : m_context(context),
          m_view(hold(make_frame_view(scene.get_walkthrough(), kFrame, kSize, true))),
          m_gbuffer(context.functions(), kSize, kBaseChannels, {}) {
        SceneRenderer renderer(context.functions(), scene);
        context.reset_state();
        renderer.render(m_gbuffer, m_view);
    }

    double time_method(Method& method) {
        return time_call([&] {
            PassRecorder passes(PassTiming::none);
            render(method, passes);
        });
    }
    /// Adds ns of each pass.
    void time_passes(Method& method, std::map<std::string, std::vector<double>>& times) {
        gl::IntervalTimer timer(m_context.functions(), gl::TimerMode::fenced_wall);
        PassRecorder passes(PassTiming::divided, &timer);
        render(method, passes);
        const std::vector<std::int64_t> intervals = timer.collect();
        for (std::size_t i = 0; i < intervals.size(); ++i) {
            times[passes.names()[i]].push_back(static_cast<double>(intervals[i]));
        }
    }

  private:
    void render(Method& method, PassRecorder& passes) {
        m_context.reset_state();
        m_context.functions().Finish();
        MethodInputs inputs{m_view, m_gbuffer};
        inputs.noise_seed = 1;
        static_cast<void>(method.render(inputs, passes));
        m_context.functions().Finish();
    }

    gl::Context& m_context;
    FrameView m_view;
    GBuffer m_gbuffer;
};

void print_passes(Stage& stage, Method& method) {
    std::map<std::string, std::vector<double>> times;
    for (int i = 0; i < kPairs; ++i) {
        stage.time_passes(method, times);
    }
    for (const auto& [name, values] : times) {
        std::printf("# %-28s %8.2f ns a pixel (median, n=%zu)\n", name.c_str(),
                    compute_median(values) / static_cast<double>(kSize.pixel_count()),
                    values.size());
    }
}

} // namespace

int main(int count, char** arguments) {
    const std::string wanted = count > 1 ? arguments[1] : "paper_quarter";
    const std::string preset = wanted.substr(0, wanted.find(':'));
    const std::string settings =
        preset.size() < wanted.size() ? wanted.substr(preset.size() + 1) : "";
    const std::unique_ptr<gl::Context> context = gl::open_context(gl::ContextKind::autodetect);
    const Registry<MethodUnit> methods = methods_registry();
    const Registry<SceneUnit> scenes = scenes_registry();
    const SceneUnit& unit = scenes.find("cathedral");
    const std::unique_ptr<Scene> scene = unit.open(unit.parameters.resolve({}, {}));
    Stage stage(*context, *scene);
    const double radius_m = scene->get_ao_radius_m();
    const auto statvo = make_method(*context, methods.find("statvo"), preset, settings, radius_m);
    const auto points =
        make_method(*context, methods.find("crytek_ssao"), "paper_fig12", "", radius_m);
    const std::vector<double> ratios = time_in_turn([&] { stage.time_method(*statvo); },
                                                    [&] { stage.time_method(*points); }, kPairs);
    print_passes(stage, *statvo);
    print_passes(stage, *points);
    return print_target("statvo / crytek_ssao-17 at half resolution", 1.0, false, ratios) ? 0 : 3;
}
