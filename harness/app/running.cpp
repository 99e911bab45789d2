#include "harness/app/running.hpp"

#include "core/gl/gl_timer_bench.hpp"
#include "harness/app/progress.hpp"
#include "harness/app/reports.hpp"
#include "harness/run/run_experiment.hpp"

#include <cstdio>

#include <fmt/format.h>

namespace alcove {

void print_notes(const MadePlan& plan) {
    for (const std::string& warning : plan.warnings) {
        fmt::print(stderr, "alcove: warning: {}\n", warning);
    }
    for (const SkippedRecord& skipped : plan.record.skipped) {
        fmt::print(stderr, "alcove: {} is skipped: {}\n", skipped.what, skipped.reason);
    }
}

void execute(RunFolder& run, gl::Context& context, gl::TimerMode mode, const Units& units,
             const Turns& turns) {
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
        events.before_step = [&](const std::string& what) { turns.take(what); };
        run_experiment(run, context, mode, units, events);
    }
    write_reports(run, false, {});
    print_table(run);
}

gl::TimerReport validate_clock(gl::Context& context) {
    gl::GlTimerBench bench(context.functions());
    gl::TimerReport timers = gl::validate_timers(bench);
    context.check_errors();
    return timers;
}

gl::TimerReport validate_clock_again(gl::Context& context, const std::string& recorded) {
    constexpr int kTries = 4;
    gl::TimerReport timers;
    if (recorded == gl::to_text(gl::TimerMode::fenced_wall)) {
        return timers;
    }
    for (int i = 0; i < kTries && (i == 0 || gl::to_text(timers.chosen()) != recorded); ++i) {
        timers = validate_clock(context);
    }
    return timers;
}

} // namespace alcove
