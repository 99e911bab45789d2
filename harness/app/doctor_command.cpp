#include "core/frame/frame_view.hpp"
#include "core/gl/gl_timer_bench.hpp"
#include "harness/app/verbs.hpp"
#include "harness/run/environment.hpp"
#include "harness/run/reference_store.hpp"

#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace alcove {
namespace {

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
    fmt::print("{}", gl::format_timer_report(timers));
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
