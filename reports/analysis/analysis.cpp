#include "reports/analysis/analysis.hpp"

#include "reports/analysis/cell_series.hpp"
#include "reports/analysis/metrics.hpp"
#include "reports/analysis/sequences.hpp"
#include "reports/analysis/strata.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alcove {
namespace {

std::optional<double> find_fetches(const RoundDone& done, const std::string& cell,
                                   const std::string& pass) {
    const auto found =
        std::find_if(done.fetches.begin(), done.fetches.end(), [&](const FetchRecord& record) {
            return record.cell == cell && record.pass == pass;
        });
    return found == done.fetches.end() ? std::nullopt : std::optional(found->fetches_per_pixel);
}

std::vector<PassAnalysis> analyze_passes(const CellRecord& cell, const CellSeries& series,
                                         const RoundDone& done, double tick_ns, double pixels) {
    std::vector<PassAnalysis> passes;
    for (const std::string& name : series.pass_order) {
        PassAnalysis pass;
        pass.pass = name;
        pass.time_ms = *estimate_time_ms(series.passes.at(name));
        pass.is_input = is_input_pass(name);
        pass.is_cached = series.cached.at(name);
        if (!pass.is_input) {
            pass.ns_per_pixel = pass.time_ms.value * 1e6 / pixels;
            pass.fetches_per_pixel = find_fetches(done, cell.id, name);
            if (name == cell.sampling_pass) {
                pass.ns_per_sample = *pass.ns_per_pixel / cell.samples_per_pixel;
            }
        }
        pass.is_under_resolution =
            !pass.is_input && pass.time_ms.value * 1e6 < kResolvedTicks * tick_ns;
        passes.push_back(std::move(pass));
    }
    std::stable_sort(
        passes.begin(), passes.end(),
        [](const PassAnalysis& a, const PassAnalysis& b) { return a.is_input && !b.is_input; });
    return passes;
}

/// a / b of the repeats' medians, where that is finite.
std::map<int, double> divide_repeats(const Series& a, const Series& b) {
    std::map<int, double> result =
        combine_repeats(a.compute_repeat_medians_ms(), b.compute_repeat_medians_ms(),
                        [](double x, double y) { return x / y; });
    std::erase_if(result, [](const auto& entry) {
        return !(std::abs(entry.second) < std::numeric_limits<double>::infinity());
    });
    return result;
}

std::optional<Estimate> estimate_repeats(const std::map<int, double>& per_repeat) {
    if (per_repeat.empty()) {
        return std::nullopt;
    }
    return estimate_across_repeats(get_values(per_repeat));
}

std::optional<Estimate> estimate_total(const CellSeries& cell, const Series& base,
                                       bool has_passes) {
    const auto plus = [](double a, double b) { return a + b; };
    std::map<int, double> total = base.compute_repeat_medians_ms();
    if (!cell.compose.empty()) { // without light buffers there is no picture to compose
        total = combine_repeats(total, cell.compose.compute_repeat_medians_ms(), plus);
    }
    if (has_passes) {
        total = combine_repeats(total, cell.envelope.compute_repeat_medians_ms(), plus);
    }
    if (!cell.inputs.empty()) {
        total = combine_repeats(total, cell.inputs.compute_repeat_medians_ms(), plus);
    }
    return estimate_repeats(total);
}

Percentiles compute_percentiles(const std::vector<double>& times_ms) {
    return {compute_quantile(times_ms, 0.5), compute_quantile(times_ms, 0.95),
            compute_quantile(times_ms, 0.99), times_ms.size()};
}

void analyze_frames(CellAnalysis& cell, const Series& envelope) {
    std::vector<double> medians;
    for (const auto& [key, repeats] : envelope.times_ns()) {
        std::vector<double> times_ms = get_values(repeats);
        for (double& time : times_ms) {
            time *= 1e-6;
        }
        const auto [minimum, maximum] = std::minmax_element(times_ms.begin(), times_ms.end());
        const double median = compute_median(times_ms);
        cell.frame_times.push_back(
            {key.first, key.second, median, *minimum, *maximum, times_ms.size()});
        medians.push_back(median);
    }
    if (!medians.empty()) {
        cell.content = compute_percentiles(medians);
        cell.slow_frames = compute_slow_frames(medians);
        cell.noise = compute_percentiles(get_values(envelope.compute_repeat_medians_ms()));
    }
}

/// The logs that a cell's interval is made of; of the anchor those of its times.
std::vector<double> list_repeat_logs(CellRole role, const Series& envelope, const Series& anchor) {
    std::vector<double> logs;
    if (role != CellRole::anchor) {
        logs = get_values(compute_log_ratios(envelope, anchor));
    } else {
        for (const auto& [repeat, time_ms] : envelope.compute_repeat_medians_ms()) {
            logs.push_back(std::log(time_ms));
        }
    }
    std::erase_if(logs, [](double value) { return !std::isfinite(value); });
    return logs;
}

CellAnalysis analyze_cell(const CellRecord& record, const CellSeries& series, const Series& base,
                          const Series& anchor, const RoundDone& done, double tick_ns,
                          double pixels) {
    CellAnalysis cell;
    cell.cell = record;
    cell.time_ms = estimate_time_ms(series.envelope);
    cell.converged_time_ms =
        record.warm_frames > 0 ? estimate_time_ms(series.converged) : cell.time_ms;
    cell.converged_share = estimate_repeats(divide_repeats(series.converged, series.envelope));
    if (record.role != CellRole::anchor && !series.envelope.empty()) {
        cell.ratio = estimate_ratio(series.envelope, anchor);
    }
    cell.input_ms = estimate_time_ms(series.inputs);
    cell.compose_ms = estimate_time_ms(series.compose);
    cell.total_ms = estimate_total(series, base, record.has_passes);
    cell.has_cached_input = std::any_of(series.cached.begin(), series.cached.end(),
                                        [](const auto& entry) { return entry.second; });
    cell.passes = analyze_passes(record, series, done, tick_ns, pixels);
    cell.coverage = estimate_repeats(divide_repeats(series.divided, series.envelope));
    analyze_frames(cell, series.envelope);
    const std::vector<double> logs = list_repeat_logs(record.role, series.envelope, anchor);
    cell.outliers = classify_outliers(logs);
    cell.lag1 = compute_lag1_autocorrelation(logs);
    return cell;
}

RoundAnalysis analyze_round(const RunFolder& run, const RoundRecord& round,
                            const std::vector<SampleRow>& samples,
                            const std::vector<MetricRow>& metrics) {
    RoundAnalysis result;
    result.round = round;
    result.done = run.read_done(round.id).value_or(RoundDone{});
    RoundSeries sorted = sort_samples(samples);
    const Series& base = sorted.base;
    std::map<std::string, CellSeries>& series = sorted.cells;
    const auto find_role = [&](CellRole role) {
        const auto found = std::find_if(round.cells.begin(), round.cells.end(),
                                        [&](const CellRecord& cell) { return cell.role == role; });
        return found == round.cells.end() ? Series() : series[found->id].envelope;
    };
    const Series anchor = find_role(CellRole::anchor);
    for (const CellRecord& cell : round.cells) {
        result.cells.push_back(analyze_cell(cell, series[cell.id], base, anchor, result.done,
                                            run.context().timer_tick_ns,
                                            static_cast<double>(round.width) * round.height));
    }
    result.base_ms = estimate_time_ms(base);
    result.aa_ratio = estimate_ratio(find_role(CellRole::anchor_repeat), anchor);
    if (result.aa_ratio) {
        result.minimum_detectable_effect = compute_minimum_detectable_effect(*result.aa_ratio);
    }
    result.machine = judge_machine(round, sorted, result.done, run.context());
    analyze_metrics(result, metrics, run.plan());
    analyze_sequences(result, metrics, run.plan());
    analyze_strata(result, metrics, run.plan());
    mark_front(result, run.plan());
    return result;
}

const MetricAnalysis* find_measured(const std::vector<MetricAnalysis>& table,
                                    const std::string& metric) {
    const auto found = std::find_if(table.begin(), table.end(), [&](const MetricAnalysis& m) {
        return m.metric == metric && m.frames > 0;
    });
    return found == table.end() ? nullptr : &*found;
}

template <class Row>
std::map<std::string, std::vector<Row>> group_by_round(std::vector<Row> rows) {
    std::map<std::string, std::vector<Row>> groups;
    for (Row& row : rows) {
        groups[row.round].push_back(std::move(row));
    }
    return groups;
}

} // namespace

bool is_compared(const CellAnalysis& cell) {
    return cell.cell.role == CellRole::method && cell.cell.settings != kNativeSettings;
}

const MetricAnalysis* CellAnalysis::find(SampleState state, const std::string& metric) const {
    return find_measured(state == SampleState::cold ? cold : converged, metric);
}

const MetricAnalysis* CellAnalysis::find_temporal(const std::string& metric) const {
    return find_measured(temporal, metric);
}

const MetricAnalysis* CellAnalysis::find_history(SampleState state,
                                                 const std::string& number) const {
    return find_measured(state == SampleState::cold ? history_cold : history_converged, number);
}

const MetricDescription* RunAnalysis::find_metric(const std::string& name) const {
    const auto found = std::find_if(plan.metrics.begin(), plan.metrics.end(),
                                    [&](const MetricDescription& m) { return m.name == name; });
    return found == plan.metrics.end() ? nullptr : &*found;
}

RunAnalysis analyze_run(const RunFolder& run, std::vector<ProvisionalRow> provisional) {
    RunAnalysis analysis;
    analysis.context = run.context();
    analysis.plan = run.plan();
    analysis.is_complete = run.is_complete();
    analysis.is_timer_validated =
        std::any_of(run.context().timer_trials.begin(), run.context().timer_trials.end(),
                    [&](const TimerTrialRecord& trial) {
                        return trial.accepted && trial.mode == run.context().timer_mode;
                    });
    std::map<std::string, std::vector<SampleRow>> samples = group_by_round(run.read_samples());
    analysis.metric_rows = run.read_metrics();
    std::map<std::string, std::vector<MetricRow>> metrics = group_by_round(analysis.metric_rows);
    for (const RoundRecord& round : run.plan().rounds) {
        if (run.is_finished(round.id)) {
            analysis.rounds.push_back(
                analyze_round(run, round, samples[round.id], metrics[round.id]));
        }
    }
    std::erase_if(provisional,
                  [&](const ProvisionalRow& row) { return run.is_finished(row.round); });
    analysis.provisional = std::move(provisional);
    return analysis;
}

} // namespace alcove
