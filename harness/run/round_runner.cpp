#include "harness/run/round_runner.hpp"

#include "harness/run/effects_saving.hpp"
#include "harness/run/error_explainer.hpp"
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
        const std::size_t frames =
            stage.frames().size() * static_cast<std::size_t>(plan.repeats + 1);
        std::size_t frames_done = 0;
        const auto frame_done = [&] { events.progress(++frames_done, frames); };
        {
            RoundTiming timing(stage, result.samples, result.done);
            timing.warm_up();
            for (int repeat = 0; repeat < plan.repeats; ++repeat) {
                events.before_step("repeat " + std::to_string(repeat) + " " + round.id);
                timing.time_repeat(repeat, frame_done);
                events.repeat_done(result.samples, repeat + 1);
            }
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
        result.done.gbuffers_drawn = static_cast<int>(stage.gbuffers().drawn());
        result.done.gbuffers_loaded = static_cast<int>(stage.gbuffers().loaded());
        result.done.audited += static_cast<int>(stage.gbuffers().audited());
    }
    prune_cache(get_cache_folder());
    result.done.wall_s = wall_s;
    return result;
}

} // namespace alcove
