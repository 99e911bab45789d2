#include "reports/analysis/comparison.hpp"

#include "core/base/error.hpp"
#include "reports/analysis/comparison_matching.hpp"
#include "reports/analysis/comparison_quality.hpp"
#include "reports/analysis/comparison_time.hpp"
#include "reports/analysis/discoveries.hpp"
#include "reports/analysis/fitness.hpp"

#include <algorithm>
#include <set>

#include <fmt/core.h>

namespace alcove {
namespace {

/// One run's rows, where they are looked for.
struct Side {
    const RunFolder& run;
    std::map<std::string, RoundSeries> times;                                      ///< by round
    std::map<std::pair<std::string, std::string>, std::vector<MetricRow>> metrics; ///< and cell
};

Side read_side(const RunFolder& run) {
    Side side{run, {}, {}};
    std::map<std::string, std::vector<SampleRow>> samples;
    for (SampleRow& row : run.read_samples()) {
        samples[row.round].push_back(std::move(row));
    }
    for (const auto& [round, rows] : samples) {
        side.times[round] = sort_samples(rows);
    }
    for (MetricRow& row : run.read_metrics()) {
        side.metrics[{row.round, row.cell}].push_back(std::move(row));
    }
    return side;
}

AnchoredCell find_times(Side& side, const PlacedCell& place) {
    return find_anchored_cell(side.times[place.round->id], *place.round, *place.cell);
}

CellComparison compare_cell(Side& base, const PlacedCell& base_place, Side& next,
                            const PlacedCell& next_place, const ComparisonOptions& options) {
    CellComparison result;
    result.round = *base_place.round;
    result.next_round = next_place.round->id;
    result.base = *base_place.cell;
    result.next = *next_place.cell;
    result.parameters = list_parameter_changes(result.base, result.next);
    const AnchoredCell base_times = find_times(base, base_place);
    const AnchoredCell next_times = find_times(next, next_place);
    result.time = compare_times(base_times, next_times, options);
    result.parts = compare_parts(base_times, next_times, options.paired);
    const auto measure = [](Side& side, const PlacedCell& place) {
        return MeasuredCell{side.run, *place.round, *place.cell,
                            side.metrics[{place.round->id, place.cell->id}]};
    };
    const MeasuredCell base_images = measure(base, base_place);
    const MeasuredCell next_images = measure(next, next_place);
    result.images = compare_images(base_images, next_images);
    result.quality = compare_quality(base_images, next_images, result.images);
    return result;
}

template <class Unit>
void note_sources(std::vector<std::string>& notes, const char* what, const std::vector<Unit>& base,
                  const std::vector<Unit>& next) {
    for (const Unit& unit : base) {
        const auto found = std::find_if(next.begin(), next.end(),
                                        [&](const Unit& u) { return u.name == unit.name; });
        if (found != next.end() && found->content_hash != unit.content_hash) {
            notes.push_back(fmt::format("{} {} has other sources", what, unit.name));
        }
    }
}

std::vector<std::string> list_notes(const RunFolder& base, const RunFolder& next) {
    std::vector<std::string> notes;
    const auto compare = [&](const char* what, const std::string& a, const std::string& b) {
        if (a != b) {
            notes.push_back(fmt::format("{}: {} against {}", what, a, b));
        }
    };
    const ContextRecord& a = base.context();
    const ContextRecord& b = next.context();
    notes.push_back(a.build_id == b.build_id ? "both runs come from the same build " + a.build_id
                                             : "builds " + a.build_id + " and " + b.build_id);
    compare("build type", a.build_type, b.build_type);
    compare("compiler", a.compiler, b.compiler);
    compare("processor", a.cpu, b.cpu);
    compare("processor features (image hashes can differ)", a.cpu_features, b.cpu_features);
    compare("reference rays in each half", std::to_string(base.plan().reference_rays_per_half),
            std::to_string(next.plan().reference_rays_per_half));
    note_sources(notes, "method", base.plan().methods, next.plan().methods);
    note_sources(notes, "scene", base.plan().scenes, next.plan().scenes);
    for (const MetricDescription& metric : base.plan().metrics) {
        for (const MetricDescription& other : next.plan().metrics) {
            if (metric.name == other.name && metric.definition != other.definition) {
                notes.push_back("metric " + metric.name + " is defined otherwise");
            }
        }
    }
    return notes;
}

void list_unpaired_metrics(std::vector<Unpaired>& unpaired, const PlanRecord& plan,
                           const PlanRecord& other, bool is_base) {
    for (const MetricDescription& metric : plan.metrics) {
        if (std::none_of(other.metrics.begin(), other.metrics.end(),
                         [&](const MetricDescription& m) { return m.name == metric.name; })) {
            unpaired.push_back(
                {is_base, "metric " + metric.name, "the other run does not have it"});
        }
    }
}

/// Where the machine was not fit, of the rounds that were compared.
void note_machines(std::vector<std::string>& notes, Side& side, const char* name,
                   const std::set<const RoundRecord*>& rounds) {
    for (const RoundRecord& round : side.run.plan().rounds) {
        if (!rounds.contains(&round)) {
            continue;
        }
        const Fitness fitness =
            judge_machine(round, side.times[round.id],
                          side.run.read_done(round.id).value_or(RoundDone{}), side.run.context());
        if (fitness.verdict != MachineVerdict::fit) {
            notes.push_back(fmt::format("{}, {}: {}", name, round.id, describe_fitness(fitness)));
        }
    }
}

std::string name_run(const RunFolder& run, const std::string& name) {
    if (!name.empty()) {
        return name;
    }
    return std::filesystem::weakly_canonical(run.path()).filename().string();
}

} // namespace

std::string_view to_text(Verdict verdict) {
    switch (verdict) {
    case Verdict::worse:
        return "worse";
    case Verdict::better:
        return "better";
    case Verdict::same:
        return "same";
    case Verdict::unknown:
        break;
    }
    return "unknown";
}

std::string_view to_text(MetricColumn column) {
    switch (column) {
    case MetricColumn::cold:
        return "cold";
    case MetricColumn::converged:
        return "converged";
    case MetricColumn::over_time:
        return "over time";
    case MetricColumn::history_cold:
        return "history, cold";
    case MetricColumn::history_converged:
        break;
    }
    return "history, converged";
}

std::size_t Comparison::count(Verdict verdict) const {
    std::size_t number = 0;
    for (const CellComparison& cell : cells) {
        number += cell.time && cell.time->verdict == verdict ? 1 : 0;
        number += static_cast<std::size_t>(
            std::count_if(cell.quality.begin(), cell.quality.end(),
                          [&](const QualityComparison& q) { return q.verdict == verdict; }));
    }
    return number;
}

void check_comparable(const ContextRecord& base, const ContextRecord& next) {
    const auto check = [](const char* field, const std::string& a, const std::string& b) {
        if (a != b) {
            throw InputError("compare", std::string("the runs cannot be compared: other ") + field,
                             b, "`" + a + "` as in BASE");
        }
    };
    check("anchor_version", base.anchor_version, next.anchor_version);
    check("device_class", base.device_class, next.device_class);
    check("gl_renderer", base.gl_renderer, next.gl_renderer);
    check("gl_version", base.gl_version, next.gl_version);
    check("driver_threads", std::to_string(base.driver_threads),
          std::to_string(next.driver_threads));
    check("timer_mode", base.timer_mode, next.timer_mode);
}

Comparison compare_runs(const RunFolder& base, const RunFolder& next,
                        const ComparisonOptions& options) {
    check_comparable(base.context(), next.context());
    Comparison comparison;
    comparison.options = options;
    comparison.base = {name_run(base, options.base_name), base.path(), base.context(),
                       base.plan().command_line};
    comparison.next = {name_run(next, options.next_name), next.path(), next.context(),
                       next.plan().command_line};
    const MatchedCells matched = match_cells(base, next);
    if (matched.pairs.empty()) {
        throw InputError("compare", "nothing in the two runs is the same question",
                         matched.unpaired.empty() ? "no method"
                                                  : matched.unpaired.front().what + ": " +
                                                        matched.unpaired.front().reason,
                         "a method, scene, size, target and frames that both have finished");
    }
    comparison.unpaired = matched.unpaired;
    list_unpaired_metrics(comparison.unpaired, base.plan(), next.plan(), true);
    list_unpaired_metrics(comparison.unpaired, next.plan(), base.plan(), false);
    comparison.notes = list_notes(base, next);
    Side base_side = read_side(base);
    Side next_side = read_side(next);
    std::set<const RoundRecord*> base_rounds;
    std::set<const RoundRecord*> next_rounds;
    for (const auto& [base_place, next_place] : matched.pairs) {
        base_rounds.insert(base_place.round);
        next_rounds.insert(next_place.round);
        comparison.cells.push_back(
            compare_cell(base_side, base_place, next_side, next_place, options));
    }
    note_machines(comparison.notes, base_side, "BASE", base_rounds);
    note_machines(comparison.notes, next_side, "NEW", next_rounds);
    std::vector<TimeComparison*> times;
    for (CellComparison& cell : comparison.cells) {
        if (cell.time) {
            times.push_back(&*cell.time);
        }
    }
    judge_times(times);
    find_discoveries(comparison);
    return comparison;
}

} // namespace alcove
