#include "harness/run/effects_saving.hpp"

#include "core/base/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alcove {
namespace {

/// The round as it would be with all effects, and only what it says of its first frames.
RoundRecord make_pilot(const RoundRecord& round, bool full) {
    RoundRecord pilot = round;
    const SegmentRecord& first = round.segments.front();
    pilot.segments = {
        {first.begin, std::min(first.end, first.begin + static_cast<int>(kSavingFrames))}};
    if (full) {
        for (CellRecord& cell : pilot.cells) {
            cell.effects = describe(EffectSet::all());
        }
    }
    return pilot;
}

/// G-buffer and passes of one cell, or nothing for a cell without passes.
double time_cell(RoundStage& stage, MethodCell& cell) {
    std::int64_t input_ns = 0;
    for (const GBufferKey& key : RoundStage::list_keys(cell)) {
        input_ns += stage.draw_gbuffer_timed(key);
    }
    CellTimes times;
    static_cast<void>(
        cell.render(stage.make_inputs(cell), PassTiming::envelope, stage.timer(), times));
    return static_cast<double>(input_ns + times.pass_ns.front());
}

Image take_image(RoundStage& stage, MethodCell& cell) {
    stage.render_gbuffers(RoundStage::list_keys(cell));
    if (stage.measures_pictures()) {
        stage.render_gbuffer(kBaseGBuffer);
    }
    CellTimes times;
    const MethodOutput output =
        cell.render(stage.make_measured_inputs(cell), PassTiming::none, stage.timer(), times);
    return stage.read_measured(cell, output);
}

double find_largest_difference(const Image& a, const Image& b) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.values().size(); ++i) {
        largest = std::max(largest, std::abs(static_cast<double>(a.values()[i]) -
                                             static_cast<double>(b.values()[i])));
    }
    return largest;
}

class SavingPilot {
  public:
    SavingPilot(RoundStage& planned, RoundStage& full) : m_planned(planned), m_full(full) {}

    void run(std::vector<SavingRecord>& savings) {
        for (std::size_t i = 0; i < m_planned.cells().size(); ++i) {
            const CellRecord& record = m_planned.cells()[i].record();
            if (record.role == CellRole::method && record.has_passes &&
                record.effects != describe(EffectSet::all())) {
                m_cells.push_back(i);
            }
        }
        std::vector<RepeatsByFrames> planned(m_cells.size());
        std::vector<RepeatsByFrames> full(m_cells.size());
        for (int repeat = 0; repeat < kSavingRepeats; ++repeat) {
            time_repeat(repeat, planned, full);
        }
        const std::vector<double> differences = compare_images();
        for (std::size_t c = 0; c < m_cells.size(); ++c) {
            const std::optional<Estimate> ratio = estimate_paired_ratio(planned[c], full[c]);
            ALCOVE_ASSERT(ratio && ratio->interval, "enough repeats for an interval");
            savings.push_back({m_planned.cells()[m_cells[c]].record().id, ratio->value,
                               ratio->interval->lower, ratio->interval->upper,
                               static_cast<int>(ratio->n), differences[c]});
        }
    }

  private:
    void set_frame(std::size_t frame) {
        for (RoundStage* stage : {&m_planned, &m_full}) {
            stage->prepare_histories(stage->frames()[frame]);
            stage->set_frame(stage->frames()[frame].view);
        }
    }

    void time_repeat(int repeat, std::vector<RepeatsByFrames>& planned,
                     std::vector<RepeatsByFrames>& full) {
        for (std::size_t c = 0; c < m_cells.size(); ++c) {
            planned[c].emplace_back();
            full[c].emplace_back();
        }
        for (std::size_t frame = 0; frame < m_planned.frames().size(); ++frame) {
            set_frame(frame);
            for (std::size_t c = 0; c < m_cells.size(); ++c) {
                const bool planned_first = (static_cast<std::size_t>(repeat) + frame + c) % 2 == 0;
                for (const bool is_planned : {planned_first, !planned_first}) {
                    RoundStage& stage = is_planned ? m_planned : m_full;
                    (is_planned ? planned : full)[c].back().push_back(
                        time_cell(stage, stage.cells()[m_cells[c]]));
                }
            }
        }
    }

    std::vector<double> compare_images() {
        std::vector<double> largest(m_cells.size(), 0.0);
        for (std::size_t frame = 0; frame < m_planned.frames().size(); ++frame) {
            set_frame(frame);
            for (std::size_t c = 0; c < m_cells.size(); ++c) {
                largest[c] = std::max(
                    largest[c],
                    find_largest_difference(take_image(m_planned, m_planned.cells()[m_cells[c]]),
                                            take_image(m_full, m_full.cells()[m_cells[c]])));
            }
        }
        return largest;
    }

    RoundStage& m_planned;
    RoundStage& m_full;
    std::vector<std::size_t> m_cells;
};

} // namespace

std::vector<SavingRecord> measure_savings(gl::Context& context, gl::TimerMode timer_mode,
                                          const Units& units, const PlanRecord& plan,
                                          const RoundRecord& round, const Scene& scene) {
    std::vector<SavingRecord> savings;
    const bool saves =
        std::any_of(round.cells.begin(), round.cells.end(), [](const CellRecord& cell) {
            return cell.role == CellRole::method && cell.effects != describe(EffectSet::all());
        });
    if (!saves) {
        return savings;
    }
    const RoundRecord planned_round = make_pilot(round, false);
    const RoundRecord full_round = make_pilot(round, true);
    RoundStage planned(context, timer_mode, units, plan, planned_round, scene);
    RoundStage full(context, timer_mode, units, plan, full_round, scene);
    SavingPilot(planned, full).run(savings);
    return savings;
}

} // namespace alcove
