#include "core/base/statistics.hpp"
#include "core/contract/method.hpp"
#include "core/gl/context_survey.hpp"
#include "core/gl/gl_timer_bench.hpp"
#include "harness/app/context_flags.hpp"
#include "harness/app/verbs.hpp"
#include "harness/run/environment.hpp"
#include "harness/run/reference_store.hpp"
#include "methods/registry.hpp"

#include <cstdio>
#include <memory>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace alcove {
namespace {

/// Time of one anchor pass at 512x384, the yardstick of DESIGN 6: median of 9, in ns.
double time_anchor(gl::Context& context, gl::TimerMode mode, ImageSize size) {
    const gl::Functions& gl = context.functions();
    const Registry<MethodUnit> methods = methods_registry();
    const MethodUnit& unit = methods.find("anchor");
    const std::unique_ptr<Method> anchor = unit.create(context, unit.parameters.resolve({}, {}));
    anchor->resize(size);
    const GBuffer gbuffer(gl, size, kBaseChannels, {});
    gl::write_texture(gl, gbuffer.texture(Channel::eye_depth), Image(size, 1, 5.0f));
    FrameView view;
    view.size = size;
    gl::IntervalTimer timer(gl, mode);
    std::vector<double> times;
    for (int i = 0; i < 10; ++i) {
        context.reset_state();
        gl.Finish();
        PassRecorder recorder(PassTiming::divided, &timer);
        static_cast<void>(anchor->render({view, gbuffer}, recorder));
        const auto time_ns = static_cast<double>(timer.collect().front());
        if (i > 0) { // the first use compiles
            times.push_back(time_ns);
        }
    }
    return compute_median(times);
}

void print_contexts(const std::vector<gl::ContextFinding>& findings) {
    fmt::print("this machine can open\n");
    for (const gl::ContextFinding& finding : findings) {
        const bool is_open = finding.failure.empty();
        fmt::print("  {:<17}{:<14}{}\n", finding.context, is_open ? finding.device_class : "no",
                   is_open ? finding.renderer : finding.failure);
    }
    fmt::print("\n");
}

int examine(const ContextFlags& flags) {
    const ContextChoice chosen = flags.parse();
    // First: where the chosen one is refused, this is what there is to choose from.
    print_contexts(gl::survey_contexts());
    std::fflush(stdout);
    const std::unique_ptr<gl::Context> context = open_chosen_context(chosen);
    gl::GlTimerBench bench(context->functions());
    gl::TimerValidationOptions options;
    options.exhaustive = true;
    const gl::TimerReport timers = gl::validate_timers(bench, options);
    context->check_errors();
    const ContextRecord record = describe_environment(*context, timers);
    fmt::print("context   {}\nrenderer  {} ({})\ndriver    {}\nvendor    {}\n", record.context_kind,
               record.gl_renderer, record.device_class, record.gl_version, record.gl_vendor);
    fmt::print("cpu       {}, {} threads, driver uses {}, {}\n", record.cpu, record.cpu_threads,
               record.driver_threads, record.cpu_features);
    fmt::print("build     {} {} {}\ncache     {}\n\n", record.build_id, record.build_type,
               record.compiler, get_cache_folder().string());
    fmt::print("{}\n", gl::format_timer_report(timers));
    constexpr ImageSize kSize{512, 384};
    const double anchor_ns = time_anchor(*context, timers.chosen(), kSize);
    const double fetches = 32.0 * static_cast<double>(kSize.pixel_count());
    fmt::print(
        "ceiling   32 depth fetches a pixel at 512x384: {:.2f} ms (n=9), {:.2f} G fetches/s, {}\n",
        anchor_ns * 1e-6, fetches / anchor_ns, record.device_class);
    return 0;
}

} // namespace

Action add_doctor_verb(CLI::App& app) {
    auto flags = std::make_shared<ContextFlags>();
    flags->add_to(app);
    return [flags] { return examine(*flags); };
}

} // namespace alcove
