#include "reports/analysis/comparison_time.hpp"

#include "core/base/hypothesis.hpp"
#include "core/base/rank_tests.hpp"

#include <algorithm>

namespace alcove {
namespace {

constexpr double kSignificance = 0.05;

using Repeats = std::map<int, double>;

struct Difference {
    Estimate estimate;
    std::optional<double> p_value;
    std::optional<RankEvidence> ranks;
};

RankEvidence rank_groups(std::span<const double> a, std::span<const double> b) {
    RankEvidence ranks;
    ranks.test = "mann_whitney";
    ranks.p_value = test_mann_whitney(a, b).p_value;
    ranks.ks_p_value = test_kolmogorov_smirnov(a, b).p_value;
    const std::vector<double> adjusted = adjust_holm(std::vector{ranks.p_value, *ranks.ks_p_value});
    ranks.adjusted_p_value = adjusted[0];
    ranks.ks_adjusted_p_value = adjusted[1];
    return ranks;
}

RankEvidence rank_pairs(std::span<const double> a, std::span<const double> b) {
    RankEvidence ranks;
    ranks.test = "signed_ranks";
    ranks.p_value = test_signed_ranks(a, b).p_value;
    ranks.adjusted_p_value = ranks.p_value;
    return ranks;
}

std::optional<Difference> difference_of_pairs(const Repeats& base, const Repeats& next) {
    std::vector<double> a;
    std::vector<double> b;
    std::vector<double> differences;
    for (const auto& [repeat, value] : base) {
        if (const auto found = next.find(repeat); found != next.end()) {
            a.push_back(value);
            b.push_back(found->second);
            differences.push_back(found->second - value);
        }
    }
    if (a.empty()) {
        return std::nullopt;
    }
    Difference difference{estimate_across_repeats(differences), {}, {}};
    if (a.size() >= kMinimumRepeatsForInterval) {
        difference.p_value = test_paired_means(a, b).p_value;
        difference.ranks = rank_pairs(a, b);
    }
    return difference;
}

std::optional<Difference> difference_of_groups(const Repeats& base, const Repeats& next) {
    if (base.empty() || next.empty()) {
        return std::nullopt;
    }
    const std::vector<double> a = get_values(base);
    const std::vector<double> b = get_values(next);
    const auto [a_minimum, a_maximum] = std::minmax_element(a.begin(), a.end());
    const auto [b_minimum, b_maximum] = std::minmax_element(b.begin(), b.end());
    const double minimum = *b_minimum - *a_maximum;
    const double maximum = *b_maximum - *a_minimum;
    const std::size_t n = std::min(a.size(), b.size());
    if (n >= kMinimumRepeatsForInterval) {
        const MeanTest test = test_independent_means(a, b);
        return Difference{
            {test.difference, test.interval, minimum, maximum, n}, test.p_value, rank_groups(a, b)};
    }
    return Difference{{compute_mean(b) - compute_mean(a), {}, minimum, maximum, n}, {}, {}};
}

std::optional<Difference> compute_difference(const Repeats& base, const Repeats& next,
                                             bool paired) {
    return paired ? difference_of_pairs(base, next) : difference_of_groups(base, next);
}

/// In each repeat the median over frames of part / anchor on the same frame. Not the logarithm: an
/// input cost is a difference and may be negative.
Repeats compute_shares(const Series& part, const Series& anchor) {
    std::map<int, std::vector<double>> shares;
    for (const auto& [frame, repeats] : part.times_ns()) {
        const auto anchored = anchor.times_ns().find(frame);
        if (anchored == anchor.times_ns().end()) {
            continue;
        }
        for (const auto& [repeat, time_ns] : repeats) {
            const auto unit = anchored->second.find(repeat);
            if (unit != anchored->second.end() && unit->second > 0.0) {
                shares[repeat].push_back(time_ns / unit->second);
            }
        }
    }
    Repeats medians;
    for (const auto& [repeat, values] : shares) {
        medians[repeat] = compute_median(values);
    }
    return medians;
}

/// Held frames have no anchor of their own: their median over that of the replayed frames.
Repeats compute_converged(const AnchoredCell& side) {
    const Repeats anchor = side.anchor.envelope.compute_repeat_medians_ms();
    Repeats ratios;
    for (const auto& [repeat, time_ms] : side.cell.converged.compute_repeat_medians_ms()) {
        const auto unit = anchor.find(repeat);
        if (unit != anchor.end() && unit->second > 0.0) {
            ratios[repeat] = time_ms / unit->second;
        }
    }
    return ratios;
}

std::optional<Estimate> estimate(const Repeats& repeats) {
    return repeats.empty() ? std::nullopt
                           : std::optional(estimate_across_repeats(get_values(repeats)));
}

PartComparison compare_part(const std::string& part, const Repeats& base, const Repeats& next,
                            bool paired) {
    PartComparison result;
    result.part = part;
    result.base = estimate(base);
    result.next = estimate(next);
    if (const auto difference = compute_difference(base, next, paired)) {
        result.difference = difference->estimate;
    }
    return result;
}

Repeats compute_pass(const AnchoredCell& side, const std::string& pass) {
    const auto found = side.cell.passes.find(pass);
    return found == side.cell.passes.end() ? Repeats()
                                           : compute_shares(found->second, side.anchor.divided);
}

bool is_cached(const CellSeries& cell, const std::string& pass) {
    const auto found = cell.cached.find(pass);
    return found != cell.cached.end() && found->second;
}

} // namespace

bool RankEvidence::is_silent() const {
    return adjusted_p_value > kSignificance &&
           (!ks_adjusted_p_value || *ks_adjusted_p_value > kSignificance);
}

AnchoredCell find_anchored_cell(RoundSeries& series, const RoundRecord& round,
                                const CellRecord& cell) {
    const auto find_role = [&](CellRole role) -> const CellSeries& {
        const auto found =
            std::find_if(round.cells.begin(), round.cells.end(),
                         [&](const CellRecord& other) { return other.role == role; });
        static const CellSeries kNone;
        return found == round.cells.end() ? kNone : series.cells[found->id];
    };
    const CellSeries& anchor = find_role(CellRole::anchor);
    const std::optional<Estimate> aa_ratio =
        estimate_ratio(find_role(CellRole::anchor_repeat).envelope, anchor.envelope);
    return {series.cells[cell.id], anchor,
            aa_ratio ? compute_minimum_detectable_effect(*aa_ratio) : 0.0};
}

std::optional<TimeComparison> compare_times(const AnchoredCell& base, const AnchoredCell& next,
                                            const ComparisonOptions& options) {
    const Repeats base_logs = compute_log_ratios(base.cell.envelope, base.anchor.envelope);
    const Repeats next_logs = compute_log_ratios(next.cell.envelope, next.anchor.envelope);
    const auto difference = compute_difference(base_logs, next_logs, options.paired);
    if (!difference) {
        return std::nullopt;
    }
    TimeComparison time;
    time.base = exponentiate(*estimate(base_logs));
    time.next = exponentiate(*estimate(next_logs));
    time.change = exponentiate(difference->estimate);
    time.p_value = difference->p_value;
    time.ranks = difference->ranks;
    time.detectable = std::max(base.detectable, next.detectable);
    time.margin = std::max(options.margin, time.detectable);
    return time;
}

void judge_times(const std::vector<TimeComparison*>& times) {
    std::vector<TimeComparison*> tested;
    std::vector<double> p_values;
    for (TimeComparison* time : times) {
        if (time->p_value && time->change.interval) {
            tested.push_back(time);
            p_values.push_back(*time->p_value);
        }
    }
    const std::vector<double> adjusted = adjust_holm(p_values);
    for (std::size_t i = 0; i < tested.size(); ++i) {
        TimeComparison& time = *tested[i];
        time.adjusted_p_value = adjusted[i];
        const Interval change = *time.change.interval;
        const double upper = 1.0 + time.margin;
        const double lower = 1.0 / upper;
        if (adjusted[i] <= kSignificance && change.lower > upper) {
            time.verdict = Verdict::worse;
        } else if (adjusted[i] <= kSignificance && change.upper < lower) {
            time.verdict = Verdict::better;
        } else if (change.lower >= lower && change.upper <= upper) {
            time.verdict = Verdict::same;
        }
        const bool is_change = time.verdict == Verdict::worse || time.verdict == Verdict::better;
        if (is_change && time.ranks && time.ranks->is_silent()) {
            time.verdict = Verdict::unknown;
            time.is_taken_back = true;
        }
    }
}

std::vector<PartShare> estimate_parts(const AnchoredCell& cell) {
    std::vector<PartShare> parts;
    const auto add = [&](std::string_view part, bool cached, const Repeats& shares) {
        if (const std::optional<Estimate> share = estimate(shares)) {
            parts.push_back({std::string(part), cached, *share});
        }
    };
    for (const std::string& pass : cell.cell.pass_order) {
        add(pass, is_cached(cell.cell, pass), compute_pass(cell, pass));
    }
    add(kConvergedPart, false, compute_converged(cell));
    return parts;
}

std::vector<PartComparison> compare_parts(const AnchoredCell& base, const AnchoredCell& next,
                                          bool paired) {
    std::vector<std::string> passes = base.cell.pass_order;
    for (const std::string& pass : next.cell.pass_order) {
        if (!base.cell.passes.contains(pass)) {
            passes.push_back(pass);
        }
    }
    std::vector<PartComparison> parts;
    for (const std::string& pass : passes) {
        parts.push_back(
            compare_part(pass, compute_pass(base, pass), compute_pass(next, pass), paired));
        parts.back().is_cached = is_cached(base.cell, pass) || is_cached(next.cell, pass);
    }
    if (!base.cell.converged.empty() || !next.cell.converged.empty()) {
        parts.push_back(compare_part(std::string(kConvergedPart), compute_converged(base),
                                     compute_converged(next), paired));
    }
    return parts;
}

} // namespace alcove
