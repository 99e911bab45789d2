#include "harness/run/repeat_rule.hpp"

#include "core/base/statistics.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <utility>

namespace alcove {
namespace {

using TimesByFrame = std::map<std::pair<int, int>, std::map<int, double>>; ///< frame -> repeat

std::map<std::string, TimesByFrame> sort_envelopes(const std::vector<SampleRow>& samples) {
    std::map<std::string, TimesByFrame> cells;
    for (const SampleRow& row : samples) {
        if (row.kind == SampleKind::envelope && row.state == SampleState::cold) {
            cells[row.cell][{row.segment, row.frame}][row.repeat] =
                static_cast<double>(row.time_ns);
        }
    }
    return cells;
}

/// Rows are repeats, columns the frames of the anchor.
RepeatsByFrames make_table(const TimesByFrame& times, const TimesByFrame& anchor, int repeats) {
    RepeatsByFrames table(
        static_cast<std::size_t>(repeats),
        std::vector<double>(anchor.size(), std::numeric_limits<double>::quiet_NaN()));
    std::size_t column = 0;
    for (const auto& [frame, unused] : anchor) {
        if (const auto found = times.find(frame); found != times.end()) {
            for (const auto& [repeat, time_ns] : found->second) {
                table[static_cast<std::size_t>(repeat)][column] = time_ns;
            }
        }
        ++column;
    }
    return table;
}

} // namespace

void find_widest(const RoundRecord& round, const std::vector<SampleRow>& samples,
                 RepeatsRecord& record) {
    record.widest.reset();
    record.widest_cell.clear();
    std::map<std::string, TimesByFrame> times = sort_envelopes(samples);
    const auto anchor =
        std::find_if(round.cells.begin(), round.cells.end(),
                     [](const CellRecord& cell) { return cell.role == CellRole::anchor; });
    if (anchor == round.cells.end()) {
        return;
    }
    RepeatsRecord widest;
    const RepeatsByFrames units = make_table(times[anchor->id], times[anchor->id], record.taken);
    for (const CellRecord& cell : round.cells) {
        if (cell.role == CellRole::anchor || !cell.has_passes) {
            continue;
        }
        const std::optional<Estimate> ratio = estimate_paired_ratio(
            make_table(times[cell.id], times[anchor->id], record.taken), units);
        if (!ratio || !ratio->interval) {
            return;
        }
        const double half_width =
            0.5 * (ratio->interval->upper - ratio->interval->lower) / ratio->value;
        if (!widest.widest || half_width > *widest.widest) {
            widest.widest = half_width;
            widest.widest_cell = cell.id;
        }
    }
    record.widest = widest.widest;
    record.widest_cell = widest.widest_cell;
}

int RepeatRule::find_next_look(int taken) const {
    if (m_plan.until_width <= 0.0) {
        return m_plan.repeats;
    }
    int look = std::max(m_plan.repeats, kFirstLook);
    while (look <= taken && look < m_plan.limit_repeats()) {
        look *= 2;
    }
    return std::min(look, m_plan.limit_repeats());
}

bool RepeatRule::is_enough(int taken, double timed_s, const std::vector<SampleRow>& samples,
                           RepeatsRecord& record) const {
    // The look that is due now, if one is: the next after the repeat before.
    const bool is_look = find_next_look(taken - 1) == taken;
    const bool is_last = taken >= m_plan.limit_repeats();
    const bool is_late = m_plan.until_width > 0.0 && m_plan.time_limit_s > 0.0 &&
                         timed_s >= m_plan.time_limit_s && taken >= m_plan.repeats;
    if (!is_look && !is_last && !is_late) {
        return false;
    }
    record.taken = taken;
    find_widest(m_round, samples, record);
    if (m_plan.until_width <= 0.0) {
        record.reason = StopReason::planned;
        return is_last;
    }
    if (is_look && record.widest && *record.widest <= m_plan.until_width) {
        record.reason = StopReason::width;
        return true;
    }
    record.reason = is_last ? StopReason::most : StopReason::time;
    return is_last || is_late;
}

} // namespace alcove
