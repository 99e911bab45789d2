#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/gl/gl_timer_bench.hpp"
#include "harness/app/planned.hpp"
#include "harness/app/progress.hpp"
#include "harness/app/reports.hpp"
#include "harness/app/verbs.hpp"
#include "harness/run/environment.hpp"
#include "harness/run/run_experiment.hpp"

#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace alcove {
namespace {

namespace fs = std::filesystem;

struct RunFlags {
    std::string experiment_file;
    bool quick = false;
    std::vector<std::string> scenes;
    std::vector<std::string> methods;
    std::string size = "384x288";
    std::string frames;
    int repeats = 6;
    std::string target;
    std::string reference;
    bool warm = false;
    std::string precision;
    std::string context = "auto";
    std::string effects = "all";
    std::string out;
    std::string resume;
};

constexpr int kMostRepeats = 1000;

Experiment make_experiment(const RunFlags& flags, const std::string& command_line) {
    if (!flags.experiment_file.empty()) {
        throw_planned("EXPERIMENT.toml");
    }
    if (flags.effects != "all") {
        const std::vector<std::string> choices{"auto", "all"};
        if (flags.effects == "auto") {
            throw_planned("--effects auto");
        }
        throw InputError("--effects", "unknown choice", flags.effects,
                         describe_choices(flags.effects, choices));
    }
    if (flags.repeats < 1 || flags.repeats > kMostRepeats) {
        throw InputError("--repeat", "out of range", std::to_string(flags.repeats), "1 to 1000");
    }
    Experiment experiment;
    experiment.quick = flags.quick;
    experiment.scenes = flags.scenes;
    for (const std::string& text : flags.methods) {
        experiment.methods.push_back(parse_method_spec(text));
    }
    experiment.size = parse_size(flags.size);
    if (!flags.frames.empty()) {
        experiment.frames = flags.frames;
    }
    experiment.repeats = flags.repeats;
    if (flags.warm && flags.frames.empty()) {
        throw InputError("--warm", "holds the pose of A before [A,B)", "no --frames",
                         "--frames A:B");
    }
    experiment.warm = flags.warm;
    experiment.target = flags.target;
    if (!flags.reference.empty()) {
        experiment.reference = parse_method_spec(flags.reference, "--reference");
    }
    if (!flags.precision.empty()) {
        experiment.precision = parse_precision(flags.precision);
    }
    const bool is_own = !flags.scenes.empty() || !flags.methods.empty();
    experiment.name = is_own ? "command-line" : flags.quick ? "quick" : "default";
    experiment.command_line = command_line;
    return experiment;
}

void print_notes(const MadePlan& plan) {
    for (const std::string& warning : plan.warnings) {
        fmt::print(stderr, "alcove: warning: {}\n", warning);
    }
    for (const SkippedScene& skipped : plan.record.skipped) {
        fmt::print(stderr, "alcove: scene {} is skipped: {}\n", skipped.scene, skipped.reason);
    }
}

int execute(RunFolder& run, gl::Context& context, gl::TimerMode mode, const Units& units) {
    fmt::print(stderr, "alcove: writing to {} (continue with --resume {})\n", run.path().string(),
               run.path().string());
    {
        Progress progress;
        RunEvents events;
        events.progress = [&](double share, const std::string& what) {
            progress.show(share, what);
        };
        events.update = [&](const std::vector<FirstTime>& times) {
            std::vector<ProvisionalRow> rows;
            for (const FirstTime& time : times) {
                rows.push_back({time.round, time.cell, time.label, time.time_ms});
            }
            write_reports(run, !run.is_complete(), std::move(rows));
        };
        run_experiment(run, context, mode, units, events);
    }
    write_reports(run, false, {});
    print_table(run);
    return 0;
}

gl::TimerReport validate(gl::Context& context) {
    gl::GlTimerBench bench(context.functions());
    gl::TimerReport timers = gl::validate_timers(bench);
    context.check_errors();
    return timers;
}

/// The clock that a run was begun with, proved anew. On a busy machine a clock that is right can
/// fail, so it is tried again before the run is refused. Fenced wall time needs no proof.
gl::TimerReport validate_again(gl::Context& context, const std::string& recorded) {
    constexpr int kTries = 4;
    gl::TimerReport timers;
    if (recorded == gl::to_text(gl::TimerMode::fenced_wall)) {
        return timers;
    }
    for (int i = 0; i < kTries && (i == 0 || gl::to_text(timers.chosen()) != recorded); ++i) {
        timers = validate(context);
    }
    return timers;
}

int start(const RunFlags& flags, const std::string& command_line) {
    const Units units = get_units();
    const Experiment experiment = make_experiment(flags, command_line);
    const gl::ContextKind kind = gl::parse_context_kind(flags.context);
    const fs::path out = flags.out.empty()
                             ? fs::path("runs") / (make_utc_stamp() + "-" + experiment.name)
                             : fs::path(flags.out);
    const MadePlan plan = make_plan(experiment, units);
    print_notes(plan);
    // First: a context that is refused leaves no empty folder behind.
    const std::unique_ptr<gl::Context> context = gl::open_context(kind);
    create_output_folder(out);
    if (fs::exists(out / "context.json")) { // before seconds go into the timers
        throw InputError(out.string(), "the folder already holds a run", "context.json",
                         "an empty or new folder, or --resume");
    }
    const gl::TimerReport timers = validate(*context);
    RunFolder run = RunFolder::create(out, describe_environment(*context, timers), plan.record);
    return execute(run, *context, timers.chosen(), units);
}

int resume(const RunFlags& flags) {
    const Units units = get_units();
    RunFolder run = RunFolder::open(flags.resume);
    const std::unique_ptr<gl::Context> context =
        gl::open_context(gl::parse_context_kind(flags.context));
    // Build and driver first, the clock after seconds of validation.
    ContextRecord here = describe_environment(*context, {});
    here.timer_mode = run.context().timer_mode;
    check_same_environment(run.context(), here);
    const gl::TimerReport timers = validate_again(*context, run.context().timer_mode);
    check_same_environment(run.context(), describe_environment(*context, timers));
    return execute(run, *context, timers.chosen(), units);
}

std::string describe_planned_flags() {
    std::string text = "Planned:\n";
    for (const Planned& flag : list_planned_run_flags()) {
        text += fmt::format("  {:<28}{}\n", flag.name, flag.meaning);
    }
    return text;
}

} // namespace

Action add_run_verb(CLI::App& app, const std::string& command_line) {
    auto flags = std::make_shared<RunFlags>();
    app.add_option("experiment", flags->experiment_file, "EXPERIMENT.toml (planned)");
    app.add_flag("--quick", flags->quick, "one scene, 24 frames");
    app.add_option("--scene", flags->scenes,
                   "NAME[:key=value,...], or a .gltf or .glb file (repeatable)")
        ->expected(1)
        ->take_all();
    app.add_option("--method", flags->methods, "M[@PRESET][:key=value,...][#label] (repeatable)")
        ->expected(1)
        ->take_all();
    app.add_option("--size", flags->size, "WxH in pixels")->capture_default_str();
    app.add_option("--frames", flags->frames, "A:B, half-open, in place of the default segments");
    app.add_option("--repeat", flags->repeats, "timing replays a round; 5 or more give intervals")
        ->capture_default_str();
    app.add_option("--target", flags->target,
                   "radius=R,falloff=none|linear|quadratic,weighting=cosine|uniform");
    app.add_option(
        "--reference", flags->reference,
        "what errors are measured against: M[@PRESET][:key=value,...][#label]; default "
        "reference_ray_traced. tssao@reference_480 is what its estimator can do at most");
    app.add_flag("--warm", flags->warm,
                 "with --frames A:B: hold the pose of A until histories have converged");
    app.add_option("--precision", flags->precision,
                   "raster_depth=32F|24|16[,reversed],eye_depth=32F|16F|raster,motion=16F|32F");
    app.add_option("--context", flags->context, "auto, osmesa (egl and glfw are planned)")
        ->capture_default_str();
    app.add_option("--effects", flags->effects, "all (auto is planned)")->capture_default_str();
    app.add_option("--out", flags->out, "run folder; default runs/<UTC>-<experiment>");
    app.add_option("--resume", flags->resume, "continue this run folder");
    app.footer(describe_planned_flags());
    return [flags, command_line] {
        return flags->resume.empty() ? start(*flags, command_line) : resume(*flags);
    };
}

} // namespace alcove
