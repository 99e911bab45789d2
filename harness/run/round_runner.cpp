#include "harness/run/round_runner.hpp"

#include "harness/run/effects_saving.hpp"
#include "harness/run/error_explainer.hpp"
#include "harness/run/fetch_count.hpp"
#include "harness/run/machine_watch.hpp"
#include "harness/run/repeat_rule.hpp"
#include "harness/run/round_capture.hpp"
#include "harness/run/round_timing.hpp"
#include "harness/run/wall_time.hpp"

namespace alcove {

RoundResult run_round(gl::Context& context, gl::TimerMode timer_mode, const Units& units,
                      const PlanRecord& plan, const RoundRecord& round, const Scene& scene,
                      const std::filesystem::path& run_folder, const RoundEvents& events) {
    RoundResult result;
    double wall_s = 0.0;
    {
        const WallTime wall(wall_s);
        RoundStage stage(context, timer_mode, units, plan, round, scene);
        const RepeatRule rule(plan, round);
        RoundProgress progress;
        const auto expect_repeats = [&](int repeats) {
            progress.all = stage.frames().size() * static_cast<std::size_t>(repeats + 1);
            progress.is_timing = true;
        };
        const auto frame_done = [&] {
            ++progress.done;
            events.progress(progress);
        };
        {
            RoundTiming timing(stage, result.samples, result.done);
            timing.warm_up();
            double timed_s = 0.0;
            int taken = 0;
            do {
                expect_repeats(rule.find_next_look(taken));
                events.before_step("repeat " + std::to_string(taken) + " " + round.id);
                const MachineWatch machine;
                timing.time_repeat(taken, frame_done);
                result.done.machine.push_back(machine.read());
                timed_s += result.done.machine.back().wall_s;
                events.repeat_done(result.samples, ++taken);
            } while (!rule.is_enough(taken, timed_s, result.samples, result.done.repeats));
            expect_repeats(taken);
            progress.is_timing = false;
            events.before_step("capture " + round.id);
            timing.store_gbuffers();
        }
        {
            const WallTime saving_wall(result.done.passes_s);
            result.done.savings = measure_savings(context, timer_mode, units, plan, round, scene);
        }
        RoundReuse reuse(stage, run_folder);
        RoundCapture capture(stage, reuse, result.metrics, result.done, run_folder);
        capture.run(frame_done);
        reuse.finish(result.metrics, result.done);
        if (plan.explains_errors) {
            // Behind reuse: its pictures are no part of a cell's capture.
            ErrorExplainer(stage, result.done, run_folder).run();
        }
        if (plan.counts_fetches) {
            const WallTime counting_wall(result.done.counting_s);
            result.done.fetches = count_fetches(stage);
        }
        result.done.gbuffers_drawn = static_cast<int>(stage.gbuffers().drawn());
        result.done.gbuffers_loaded = static_cast<int>(stage.gbuffers().loaded());
        result.done.audited += static_cast<int>(stage.gbuffers().audited());
    }
    prune_cache(get_cache_folder());
    result.done.wall_s = wall_s;
    return result;
}

} // namespace alcove
