#include "harness/run/run_experiment.hpp"

#include "core/base/statistics.hpp"
#include "harness/run/round_runner.hpp"
#include "harness/run/scene_source.hpp"

namespace alcove {
namespace {

std::vector<FirstTime> summarise_first_repeat(const RoundRecord& round,
                                              const std::vector<SampleRow>& samples) {
    std::vector<FirstTime> times;
    for (const CellRecord& cell : round.cells) {
        std::vector<double> envelopes;
        for (const SampleRow& row : samples) {
            if (row.cell == cell.id && row.kind == SampleKind::envelope &&
                row.state == SampleState::cold) {
                envelopes.push_back(static_cast<double>(row.time_ns) * 1e-6);
            }
        }
        if (!envelopes.empty()) {
            times.push_back({round.id, cell.id, cell.label, compute_median(envelopes)});
        }
    }
    return times;
}

} // namespace

void run_experiment(RunFolder& run, gl::Context& context, gl::TimerMode timer_mode,
                    const Units& units, const RunEvents& events) {
    const PlanRecord& plan = run.plan();
    for (std::size_t index = 0; index < plan.rounds.size(); ++index) {
        const RoundRecord& round = plan.rounds[index];
        if (run.is_finished(round.id)) {
            continue;
        }
        const auto share = [&](double within) {
            return (static_cast<double>(index) + within) / static_cast<double>(plan.rounds.size());
        };
        events.before_step("prepare " + round.id);
        events.progress(share(0.0), round.scene + ": opening");
        std::vector<std::string> ignored; // said when the plan was made
        const std::unique_ptr<Scene> scene = open_scene(units.scenes, round.scene, ignored);
        RoundEvents round_events;
        round_events.before_step = events.before_step;
        round_events.progress = [&](const RoundProgress& progress) {
            events.progress(
                share(static_cast<double>(progress.done) / static_cast<double>(progress.all)),
                round.scene + (progress.is_timing ? ": timing" : ": images and reference"));
        };
        round_events.repeat_done = [&](const std::vector<SampleRow>& samples, int repeats) {
            if (repeats == 1) {
                events.update(summarise_first_repeat(round, samples));
            }
        };
        const RoundResult result =
            run_round(context, timer_mode, units, plan, round, *scene, run.path(), round_events);
        run.finish_round(round.id, result.samples, result.metrics, result.done);
        events.update({});
    }
}

} // namespace alcove
