#include "core/base/statistics.hpp"
#include "core/contract/method.hpp"
#include "core/gl/gl_timer_bench.hpp"
#include "harness/app/verbs.hpp"
#include "harness/run/environment.hpp"
#include "harness/run/reference_store.hpp"
#include "methods/registry.hpp"

#include <memory>

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

int examine(const std::string& kind) {
    const std::unique_ptr<gl::Context> context = gl::open_context(gl::parse_context_kind(kind));
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
    auto kind = std::make_shared<std::string>("auto");
    app.add_option("--context", *kind, "auto, osmesa (egl and glfw are planned)")
        ->capture_default_str();
    return [kind] { return examine(*kind); };
}

} // namespace alcove
