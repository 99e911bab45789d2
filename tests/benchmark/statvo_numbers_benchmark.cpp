// What statvo's tables lose to their numbers on a frame as deep as a city: depths that a box means,
// and visibility, against the same formulas in double precision; and what each kind costs. Tells
// figures, holds nothing to a bound.
//   benchmark_statvo_numbers [DOWNSAMPLE]      below 4 the means alone: the double evaluation of
//                                              layers takes minutes

#include "core/base/statistics.hpp"
#include "core/frame/scene_renderer.hpp"
#include "scenes/registry.hpp"
#include "tests/benchmark/ratio.hpp"
#include "tests/methods/statvo_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace {

using namespace alcove;

constexpr ImageSize kSize{1280, 720};
constexpr int kFrame = 60;
constexpr int kRepeats = 9;
// A box so high that psi never leaves its straight part: visibility 1/2 + (mean - depth) / height.
constexpr double kTallBoxM = 1000.0;

struct Errors {
    double rms = 0.0;
    double p999 = 0.0;
    double largest = 0.0;
};

Errors summarise(std::vector<double> errors) {
    std::sort(errors.begin(), errors.end());
    Errors result;
    for (const double error : errors) {
        result.rms += error * error / static_cast<double>(errors.size());
    }
    result.rms = std::sqrt(result.rms);
    result.p999 = errors[static_cast<std::size_t>(0.999 * static_cast<double>(errors.size()))];
    result.largest = errors.back();
    return result;
}

class Stage {
  public:
    Stage(gl::Context& context, const Scene& scene)
        : m_context(context), m_radius_m(scene.get_ao_radius_m()),
          m_view(hold(make_frame_view(scene.get_walkthrough(), kFrame, kSize, true))),
          m_gbuffer(context.functions(), kSize, kBaseChannels, {}) {
        SceneRenderer renderer(context.functions(), scene);
        context.reset_state();
        renderer.render(m_gbuffer, m_view);
        m_depth = gl::read_texture(context.functions(), m_gbuffer.texture(Channel::eye_depth), 1);
        m_normal = gl::read_texture(context.functions(), m_gbuffer.texture(Channel::normal), 3);
    }

    void print_depths() const {
        double farthest = 0.0;
        double nearest = INFINITY;
        for (const float depth : m_depth.values()) {
            nearest = std::min(nearest, static_cast<double>(depth));
            farthest =
                std::isinf(depth) ? farthest : std::max(farthest, static_cast<double>(depth));
        }
        std::printf("# depths %.2f to %.1f m, radius %.2f m\n", nearest, farthest, m_radius_m);
    }

    /// One line a kind of numbers: errors of visibility times `unit`, and milliseconds.
    void compare(const std::string& title, const std::string& unit_name, double unit,
                 const std::vector<ParameterOverride>& settings) {
        const MethodUnit unit_of_method = statvo_unit();
        std::vector<StatvoPixel> oracle;
        for (const char* numbers : {"float32", "float32_centred", "integer"}) {
            std::vector<ParameterOverride> overrides = settings;
            overrides.push_back({"numbers", numbers});
            const ResolvedParameters resolved =
                unit_of_method.parameters.resolve(overrides, {{"scene_radius", m_radius_m}});
            if (oracle.empty()) {
                oracle =
                    evaluate_statvo_oracle(m_depth, m_normal, {}, m_view.camera,
                                           unit_of_method.parameters.bind<StatvoParams>(resolved));
            }
            const auto method = unit_of_method.create(m_context, resolved);
            method->resize(kSize);
            std::vector<double> times;
            Image visibility;
            for (int i = 0; i <= kRepeats; ++i) {
                const double seconds = time_call([&] { visibility = render(*method); });
                if (i > 0) {
                    times.push_back(1e3 * seconds);
                }
            }
            std::vector<double> errors; // but where a sample might lie in another layer
            for (std::size_t i = 0; i < oracle.size(); ++i) {
                const double truth = oracle[i].visibility;
                if (!std::isinf(m_depth.values()[i]) && oracle[i].flagged_share == 0.0) {
                    errors.push_back(unit *
                                     std::abs(static_cast<double>(visibility.values()[i]) - truth));
                }
            }
            const std::size_t pixels = errors.size();
            const Errors result = summarise(std::move(errors));
            std::printf("%-24s | %-16s | rms %9.3g %s | 99.9 %% %9.3g | largest %9.3g | %6.1f ms "
                        "(median, n=%zu) | %zu pixels\n",
                        title.c_str(), numbers, result.rms, unit_name.c_str(), result.p999,
                        result.largest, compute_median(times), times.size(), pixels);
            std::fflush(stdout);
        }
    }

  private:
    Image render(Method& method) {
        m_context.reset_state();
        PassRecorder passes(PassTiming::none);
        MethodInputs inputs{m_view, m_gbuffer};
        const MethodOutput output = method.render(inputs, passes);
        m_context.functions().Finish();
        return gl::read_texture(m_context.functions(), *output.visibility, 1);
    }

    gl::Context& m_context;
    double m_radius_m;
    FrameView m_view;
    GBuffer m_gbuffer;
    Image m_depth;
    Image m_normal;
};

} // namespace

int main(int count, char** arguments) {
    const std::string downsample = count > 1 ? arguments[1] : "4";
    const std::unique_ptr<gl::Context> context = gl::open_context(gl::ContextKind::autodetect);
    const Registry<SceneUnit> scenes = scenes_registry();
    const SceneUnit& unit = scenes.find("city");
    const std::unique_ptr<Scene> scene = unit.open(unit.parameters.resolve({}, {}));
    Stage stage(*context, *scene);
    stage.print_depths();
    stage.compare("mean depth of a box", "m", kTallBoxM,
                  {{"levels", "0"},
                   {"projection", "view_aligned"},
                   {"box", "centre"},
                   {"height", std::to_string(kTallBoxM)},
                   {"downsample", downsample}});
    if (downsample == "4") {
        stage.compare("visibility, 4 layers", "/ 255", 255.0, {{"downsample", downsample}});
    }
    return 0;
}
