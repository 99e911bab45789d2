#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "harness/app/context_flags.hpp"
#include "harness/app/experiment_flags.hpp"
#include "harness/app/planned.hpp"
#include "harness/app/running.hpp"
#include "harness/app/turns.hpp"
#include "harness/app/verbs.hpp"
#include "harness/run/environment.hpp"
#include "harness/run/estimate.hpp"

#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace alcove {
namespace {

namespace fs = std::filesystem;

struct RunFlags {
    ExperimentFlags experiment;
    bool dry_run = false;
    ContextFlags context;
    std::string out;
    std::string resume;
    bool turns = false;
    std::string clock_of;
};

/// The clock for a new run: the cheapest that is proved, or that of another run, which alone makes
/// the two comparable.
gl::TimerReport choose_clock(gl::Context& context, const std::string& clock_of) {
    if (clock_of.empty()) {
        return validate_clock(context);
    }
    const std::string recorded = RunFolder::open(clock_of).context().timer_mode;
    gl::TimerReport timers = validate_clock_again(context, recorded);
    if (gl::to_text(timers.chosen()) != recorded) {
        throw FailureError("--clock-of", "the clock of that run could not be proved here", recorded,
                           "a machine with less else to do");
    }
    return timers;
}

/// "1 min 20 s"
std::string describe_duration(double seconds) {
    const auto whole = static_cast<std::int64_t>(seconds + 0.5);
    if (whole < 60) {
        return fmt::format("{} s", whole);
    }
    return whole < 3600 ? fmt::format("{} min {} s", whole / 60, whole % 60)
                        : fmt::format("{} h {} min", whole / 3600, whole / 60 % 60);
}

void print_dry_run(const PlanRecord& plan, gl::Context& context, const Units& units) {
    std::size_t cells = 0;
    double total_s = 0.0;
    fmt::print("{:<28} {:>5} {:>7} {:>9} {:>10}\n", "round", "cells", "frames", "size", "time");
    for (const RoundRecord& round : plan.rounds) {
        const std::size_t methods = round.cells.size() - 2; // the rest is the anchor
        const RoundEstimate estimate = estimate_round(context, units, plan, round);
        cells += methods;
        total_s += estimate.total_s;
        fmt::print("{:<28} {:>5} {:>7} {:>9} {:>10}\n", round.id, methods, estimate.frames,
                   fmt::format("{}x{}", round.width, round.height),
                   describe_duration(estimate.total_s));
    }
    fmt::print(
        "{} cells in {} rounds of {}{} repeats, {}: about {}, from two frames of each round "
        "on this machine as busy and with its cache as full as it is now\n",
        cells, plan.rounds.size(), plan.until_width > 0.0 ? "at most " : "", plan.limit_repeats(),
        plan.skipped.empty() ? "nothing left out" : fmt::format("{} left out", plan.skipped.size()),
        describe_duration(total_s));
}

int start(const RunFlags& flags, const std::string& command_line) {
    const Units units = get_units();
    const Experiment experiment = make_experiment(flags.experiment, "default", command_line, units);
    const ContextChoice chosen = flags.context.parse();
    const fs::path out = flags.out.empty()
                             ? fs::path("runs") / (make_utc_stamp() + "-" + experiment.name)
                             : fs::path(flags.out);
    const MadePlan plan = make_plan(experiment, units);
    print_notes(plan);
    if (flags.dry_run) {
        print_dry_run(plan.record, *open_chosen_context(chosen), units);
        return 0;
    }
    // First: a context that is refused leaves no empty folder behind.
    const std::unique_ptr<gl::Context> context = open_chosen_context(chosen);
    create_output_folder(out);
    if (fs::exists(out / "context.json")) { // before seconds go into the timers
        throw InputError(out.string(), "the folder already holds a run", "context.json",
                         "an empty or new folder, or --resume");
    }
    const Turns turns(flags.turns);
    turns.take("clock");
    const gl::TimerReport timers = choose_clock(*context, flags.clock_of);
    RunFolder run = RunFolder::create(out, describe_environment(*context, timers), plan.record);
    execute(run, *context, timers.chosen(), units, turns);
    return 0;
}

int resume(const RunFlags& flags) {
    const Units units = get_units();
    RunFolder run = RunFolder::open(flags.resume);
    const std::unique_ptr<gl::Context> context = open_chosen_context(flags.context.parse());
    // Build and driver first, the clock after seconds of validation.
    ContextRecord here = describe_environment(*context, {});
    here.timer_mode = run.context().timer_mode;
    check_same_environment(run.context(), here);
    const Turns turns(flags.turns);
    turns.take("clock");
    const gl::TimerReport timers = validate_clock_again(*context, run.context().timer_mode);
    check_same_environment(run.context(), describe_environment(*context, timers));
    execute(run, *context, timers.chosen(), units, turns);
    return 0;
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
    flags->experiment.add_to(app);
    app.add_flag("--dry-run", flags->dry_run, "cells, rounds and estimated time only");
    flags->context.add_to(app);
    app.add_option("--out", flags->out, "run folder; default runs/<UTC>-<experiment>");
    app.add_option("--resume", flags->resume, "continue this run folder");
    // For `ab`: written down in harness/README.md, not in --help (an empty group).
    app.add_flag("--turns", flags->turns, "ask before every step")->group("");
    app.add_option("--clock-of", flags->clock_of, "use the timer mode of this run")->group("");
    app.footer(describe_planned_flags());
    return [flags, command_line] {
        return flags->resume.empty() ? start(*flags, command_line) : resume(*flags);
    };
}

} // namespace alcove
