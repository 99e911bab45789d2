#include "reports/analysis/target_ranking.hpp"

#include "reports/analysis/metric_table.hpp"

#include <algorithm>
#include <set>
#include <tuple>

namespace alcove {
namespace {

auto get_group(const RoundRecord& round) {
    std::vector<std::pair<int, int>> segments;
    for (const SegmentRecord& segment : round.segments) {
        segments.emplace_back(segment.begin, segment.end);
    }
    return std::tuple(round.scene, round.walkthrough, round.width, round.height, round.precision,
                      round.reference.label, round.warm, segments);
}

bool has_singles(const RoundRecord& round) {
    return std::any_of(round.segments.begin(), round.segments.end(),
                       [](const SegmentRecord& segment) { return segment.is_single(); });
}

/// A cell with what it is sorted by.
struct Candidate {
    RankedCell cell;
    double cost = 0.0; ///< small is good; the floor for what lies under it
};

void add_cells(const RoundAnalysis& round, SampleState state, bool lower_is_better,
               std::vector<Candidate>& candidates) {
    for (const CellAnalysis& cell : round.cells) {
        const MetricAnalysis* error = cell.find(state, round.front_metric);
        if (cell.cell.role != CellRole::method || error == nullptr) {
            continue;
        }
        const double value = error->is_below_floor ? *error->floor : error->shown();
        candidates.push_back({{round.round.id, cell.cell.id, cell.cell.label, cell.cell.settings,
                               cell.cell.target_note, error->content, std::nullopt},
                              lower_is_better ? value : -value});
    }
}

RankedTarget rank(const std::string& target, std::vector<Candidate> candidates) {
    const auto natives =
        std::stable_partition(candidates.begin(), candidates.end(), [](const Candidate& c) {
            return c.cell.settings != kNativeSettings;
        });
    std::stable_sort(candidates.begin(), natives,
                     [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
    RankedTarget ranked{target, {}};
    for (auto it = candidates.begin(); it != candidates.end(); ++it) {
        if (it < natives) {
            const bool is_tied = it != candidates.begin() && (it - 1)->cost == it->cost;
            it->cell.place =
                is_tied ? ranked.cells.back().place
                        : std::optional(static_cast<std::size_t>(it - candidates.begin()) + 1);
        }
        ranked.cells.push_back(std::move(it->cell));
    }
    return ranked;
}

std::vector<std::string> list_moved(const TargetRanking& ranking) {
    std::vector<std::string> moved;
    for (const RankedCell& cell : ranking.targets.front().cells) {
        if (!cell.place) {
            continue;
        }
        const bool moves = std::any_of(
            ranking.targets.begin(), ranking.targets.end(), [&](const RankedTarget& target) {
                const RankedCell* other = ranking.find(target, cell.label);
                return other != nullptr && other->place != cell.place;
            });
        if (moves) {
            moved.push_back(cell.label);
        }
    }
    return moved;
}

TargetRanking rank_group(const RunAnalysis& run, const std::vector<const RoundAnalysis*>& rounds) {
    const RoundAnalysis& first = *rounds.front();
    TargetRanking ranking;
    ranking.scene = first.round.scene;
    ranking.walkthrough = first.round.walkthrough;
    ranking.width = first.round.width;
    ranking.height = first.round.height;
    ranking.precision = first.round.precision;
    ranking.reference = first.round.reference.label;
    ranking.metric = first.front_metric;
    ranking.state = has_singles(first.round) ? SampleState::converged : SampleState::cold;
    const bool lower = is_lower_better(run.plan, ranking.metric);
    std::vector<std::string> targets;
    for (const RoundAnalysis* round : rounds) {
        if (std::find(targets.begin(), targets.end(), round->round.target) == targets.end()) {
            targets.push_back(round->round.target);
        }
    }
    for (const std::string& target : targets) {
        std::vector<Candidate> candidates;
        for (const RoundAnalysis* round : rounds) {
            if (round->round.target == target) {
                add_cells(*round, ranking.state, lower, candidates);
            }
        }
        ranking.targets.push_back(rank(target, std::move(candidates)));
    }
    ranking.moved = list_moved(ranking);
    return ranking;
}

bool tells_something(const TargetRanking& ranking) {
    return ranking.targets.size() > 1 ||
           std::any_of(ranking.targets.front().cells.begin(), ranking.targets.front().cells.end(),
                       [](const RankedCell& cell) { return cell.settings != "common"; });
}

} // namespace

const RankedCell* TargetRanking::find(const RankedTarget& target, const std::string& label) const {
    const auto found = std::find_if(target.cells.begin(), target.cells.end(),
                                    [&](const RankedCell& cell) { return cell.label == label; });
    return found == target.cells.end() ? nullptr : &*found;
}

std::vector<TargetRanking> rank_targets(const RunAnalysis& run) {
    std::vector<decltype(get_group(RoundRecord{}))> groups;
    for (const RoundAnalysis& round : run.rounds) {
        const auto group = get_group(round.round);
        if (std::find(groups.begin(), groups.end(), group) == groups.end()) {
            groups.push_back(group);
        }
    }
    std::vector<TargetRanking> rankings;
    for (const auto& group : groups) {
        std::vector<const RoundAnalysis*> rounds;
        for (const RoundAnalysis& round : run.rounds) {
            if (get_group(round.round) == group) {
                rounds.push_back(&round);
            }
        }
        TargetRanking ranking = rank_group(run, rounds);
        if (!ranking.targets.front().cells.empty() && tells_something(ranking)) {
            rankings.push_back(std::move(ranking));
        }
    }
    return rankings;
}

} // namespace alcove
