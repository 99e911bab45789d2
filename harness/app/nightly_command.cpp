// `alcove nightly`: run, judge by history, measure suspects again, append, report.

#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "harness/app/context_flags.hpp"
#include "harness/app/experiment_flags.hpp"
#include "harness/app/night_reports.hpp"
#include "harness/app/running.hpp"
#include "harness/app/verbs.hpp"
#include "harness/run/environment.hpp"
#include "reports/analysis/history_points.hpp"

#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace alcove {
namespace {

namespace fs = std::filesystem;

constexpr int kGateNotMet = 3;

struct NightlyFlags {
    ExperimentFlags experiment;
    ContextFlags context;
    std::string store = "runs/store.sqlite";
    std::string out;
    std::string commit;
};

/// The mode that most of the last nights of this device were timed with: only times of one clock
/// have a history. Empty if there was none.
std::string find_usual_clock(const StoredHistory& history, const std::string& device) {
    std::map<std::string, std::size_t> modes;
    std::string usual;
    std::size_t nights = 0;
    for (auto run = history.runs.rbegin(); run != history.runs.rend() && nights < kFenceDifferences;
         ++run) {
        if (run->device == device) {
            ++nights;
            if (++modes[run->timer_mode] > modes[usual]) {
                usual = run->timer_mode;
            }
        }
    }
    return usual;
}

/// The usual clock where it can be proved, else the cheapest that is.
gl::TimerReport choose_clock(gl::Context& context, const StoredHistory& history) {
    const std::string device = name_device(describe_environment(context, {}));
    const std::string usual = find_usual_clock(history, device);
    if (usual.empty()) {
        return validate_clock(context);
    }
    gl::TimerReport timers = validate_clock_again(context, usual);
    if (gl::to_text(timers.chosen()) != usual) {
        fmt::print(stderr,
                   "alcove: warning: the clock of earlier nights, {}, could not be proved tonight: "
                   "times begin a new segment with {}\n",
                   usual, gl::to_text(timers.chosen()));
    }
    return timers;
}

/// The suspects' rounds once more. G-buffers, references and captures come from the cache.
RunFolder measure_again(const RunFolder& run, const std::set<std::string>& rounds,
                        const fs::path& out, gl::Context& context, gl::TimerMode mode,
                        const Units& units) {
    fmt::print(stderr, "alcove: times left their fence in {} of {} rounds: measuring them again\n",
               rounds.size(), run.plan().rounds.size());
    PlanRecord plan = run.plan();
    std::erase_if(plan.rounds,
                  [&](const RoundRecord& round) { return !rounds.contains(round.id); });
    plan.audit_share = 0.0; // the first measurement has audited what this one reads
    RunFolder second = RunFolder::create(out, run.context(), plan);
    execute(second, context, mode, units, Turns(false));
    return second;
}

/// Relative to the store's folder where one is above the other, so that both can move together.
std::string name_folder(const fs::path& run, const fs::path& store) {
    const fs::path whole = fs::weakly_canonical(run);
    const fs::path relative = whole.lexically_relative(fs::weakly_canonical(store).parent_path());
    const bool is_below = !relative.empty() && *relative.begin() != "..";
    return (is_below ? relative : whole).generic_string();
}

int run_night(NightlyFlags flags, const std::string& command_line) {
    const Units units = get_units();
    // Named, so that flags over it do not change the suite that series belong to.
    if (flags.experiment.experiment.empty()) {
        flags.experiment.experiment = "nightly";
    }
    const Experiment experiment = make_experiment(flags.experiment, "nightly", command_line, units);
    const ContextChoice chosen = flags.context.parse();
    const fs::path out = flags.out.empty() ? fs::path("runs") / (make_utc_stamp() + "-nightly")
                                           : fs::path(flags.out);
    const MadePlan plan = make_plan(experiment, units);
    print_notes(plan);
    const std::unique_ptr<gl::Context> context = open_chosen_context(chosen);
    Store store(flags.store); // before hours go into a run that it would not take
    create_output_folder(out);
    if (fs::exists(out / "run")) {
        throw InputError(out.string(), "the folder already holds a night", "run",
                         "an empty or new folder");
    }
    const gl::TimerReport timers = choose_clock(*context, store.read());
    RunFolder run =
        RunFolder::create(out / "run", describe_environment(*context, timers), plan.record);
    execute(run, *context, timers.chosen(), units, Turns(false));

    StoredRun record = describe_night(run);
    record.commit = flags.commit;
    record.folder = name_folder(run.path(), flags.store);
    Night night = judge_night(store.read(), record, collect_points(run));
    if (const std::set<std::string> rounds = list_suspect_rounds(night); !rounds.empty()) {
        const RunFolder second =
            measure_again(run, rounds, out / "second", *context, timers.chosen(), units);
        confirm_times(night, collect_points(second));
    }
    store.append(night.run, make_rows(night));
    write_night_reports(night, run, store.read(), out, fs::path(flags.store).parent_path());
    print_night(night, out, fs::path(flags.store).parent_path());
    return night.is_failed() ? kGateNotMet : 0;
}

} // namespace

Action add_nightly_verb(CLI::App& app, const std::string& command_line) {
    auto flags = std::make_shared<NightlyFlags>();
    flags->experiment.add_to(app);
    flags->context.add_to(app);
    app.add_option("--store", flags->store, "SQLite file that keeps the nights")
        ->capture_default_str();
    app.add_option("--out", flags->out, "folder of the night; default runs/<UTC>-nightly");
    app.add_option("--commit", flags->commit, "what is tested, in words that the dashboard shows");
    return [flags, command_line] { return run_night(*flags, command_line); };
}

} // namespace alcove
