#include "reports/papers/evidence.hpp"

#include "core/base/assert.hpp"
#include "core/base/error.hpp"

#include <algorithm>
#include <cmath>

namespace alcove {
namespace {

std::map<int, double> add(const std::map<int, double>& a, const std::map<int, double>& b) {
    return combine_repeats(a, b, [](double x, double y) { return x + y; });
}

Estimate divide(const std::map<int, double>& a, const std::map<int, double>& b) {
    std::vector<double> ratios;
    for (const auto& [repeat, ratio] :
         combine_repeats(a, b, [](double x, double y) { return x / y; })) {
        ratios.push_back(ratio);
    }
    ALCOVE_ASSERT(!ratios.empty(), "cells of one round share repeats");
    return estimate_across_repeats(ratios);
}

} // namespace

void Evidence::add(const std::string& part, const RunFolder& run) {
    Part loaded;
    loaded.plan = run.plan();
    loaded.metrics = run.read_metrics();
    const std::vector<SampleRow> samples = run.read_samples();
    for (const RoundRecord& round : loaded.plan.rounds) {
        std::vector<SampleRow> own;
        std::copy_if(samples.begin(), samples.end(), std::back_inserter(own),
                     [&round](const SampleRow& row) { return row.round == round.id; });
        loaded.series.push_back(sort_samples(own));
        loaded.fetches.push_back(run.read_done(round.id).value_or(RoundDone{}).fetches);
    }
    m_parts.insert_or_assign(part, std::move(loaded));
    m_context = run.context();
}

const Evidence::Part& Evidence::get_part(const std::string& part) const {
    const auto found = m_parts.find(part);
    if (found == m_parts.end()) {
        throw InputError("reproduce", "a part was not run", part);
    }
    return found->second;
}

const RoundRecord& Evidence::get_round(const std::string& part, std::size_t round) const {
    return get_part(part).plan.rounds.at(round);
}

const CellRecord& Evidence::get_cell(const CellAddress& address) const {
    for (const CellRecord& cell : get_round(address.part, address.round).cells) {
        if (cell.label == address.label) {
            return cell;
        }
    }
    throw InputError("reproduce", "no such cell in part " + address.part, address.label);
}

std::string Evidence::find_parameter(const CellAddress& address,
                                     const std::string& parameter) const {
    for (const ParameterRecord& record : get_cell(address).parameters) {
        if (record.name == parameter) {
            return record.value;
        }
    }
    throw InputError("reproduce", "no such parameter in " + address.label, parameter);
}

const CellSeries* Evidence::find_series(const CellAddress& address) const {
    const RoundSeries& round = get_part(address.part).series.at(address.round);
    const auto found = round.cells.find(get_cell(address).id);
    return found == round.cells.end() ? nullptr : &found->second;
}

std::map<int, double> Evidence::get_cost_ms(const CellAddress& address) const {
    const CellSeries* series = find_series(address);
    ALCOVE_ASSERT(series != nullptr, "a cell with samples");
    const std::map<int, double> passes = series->envelope.compute_repeat_medians_ms();
    return series->inputs.empty() ? passes
                                  : alcove::add(passes, series->inputs.compute_repeat_medians_ms());
}

std::map<int, double> Evidence::get_frame_ms(const CellAddress& address) const {
    const Series& base = get_part(address.part).series.at(address.round).base;
    const CellSeries* series = find_series(address);
    ALCOVE_ASSERT(series != nullptr, "a cell with samples");
    std::map<int, double> frame =
        alcove::add(base.compute_repeat_medians_ms(), series->compose.compute_repeat_medians_ms());
    return series->envelope.empty() ? frame : alcove::add(frame, get_cost_ms(address));
}

std::optional<double> Evidence::find_fetches(const CellAddress& address,
                                             const std::string& pass) const {
    const std::string& cell = get_cell(address).id;
    for (const FetchRecord& record : get_part(address.part).fetches.at(address.round)) {
        if (record.cell == cell && record.pass == pass) {
            return record.fetches_per_pixel;
        }
    }
    return std::nullopt;
}

std::map<int, double> Evidence::get_passes_ms(const CellAddress& address,
                                              const std::vector<std::string>& passes) const {
    const CellSeries* series = find_series(address);
    ALCOVE_ASSERT(series != nullptr, "a cell with samples");
    std::map<int, double> sum;
    for (const std::string& pass : passes) {
        const auto found = series->passes.find(pass);
        if (found == series->passes.end()) {
            throw InputError("reproduce", "no such pass of " + address.label, pass);
        }
        const std::map<int, double> medians = found->second.compute_repeat_medians_ms();
        sum = sum.empty() ? medians : alcove::add(sum, medians);
    }
    return sum;
}

std::vector<double> Evidence::get_frame_costs_ms(const CellAddress& address) const {
    const CellSeries* series = find_series(address);
    ALCOVE_ASSERT(series != nullptr, "a cell with samples");
    std::vector<double> costs;
    for (const auto& [key, repeats] : series->envelope.times_ns()) {
        double cost = compute_median(alcove::get_values(repeats));
        const auto input = series->inputs.times_ns().find(key);
        if (input != series->inputs.times_ns().end()) {
            cost += compute_median(alcove::get_values(input->second));
        }
        costs.push_back(cost * 1e-6);
    }
    return costs;
}

Estimate Evidence::compare_costs(const CellAddress& a, const CellAddress& b) const {
    return divide(get_cost_ms(a), get_cost_ms(b));
}

Estimate Evidence::compare_frames(const CellAddress& a, const CellAddress& b) const {
    return divide(get_frame_ms(a), get_frame_ms(b));
}

Estimate Evidence::compare_passes(const CellAddress& a, const std::vector<std::string>& passes_of_a,
                                  const CellAddress& b,
                                  const std::vector<std::string>& passes_of_b) const {
    return divide(get_passes_ms(a, passes_of_a), get_passes_ms(b, passes_of_b));
}

Estimate Evidence::compare_converged(const CellAddress& a, const CellAddress& b) const {
    const auto get = [this](const CellAddress& address) {
        const CellSeries* series = find_series(address);
        ALCOVE_ASSERT(series != nullptr, "a cell with samples");
        return (series->converged.empty() ? series->envelope : series->converged)
            .compute_repeat_medians_ms();
    };
    return divide(get(a), get(b));
}

std::vector<double> Evidence::get_values(const CellAddress& address, const std::string& metric,
                                         SampleState state) const {
    const RoundRecord& round = get_round(address.part, address.round);
    const CellRecord& cell = get_cell(address);
    // A method without history has one value that stands for both states.
    const SampleState wanted = cell.warm_frames == 0 ? SampleState::cold : state;
    std::vector<double> values;
    for (const MetricRow& row : get_part(address.part).metrics) {
        if (row.round == round.id && row.cell == cell.id && row.metric == metric &&
            row.state == wanted && row.value) {
            values.push_back(row.debiased.value_or(*row.value));
        }
    }
    return values;
}

Estimate Evidence::compare_metric(const CellAddress& a, const CellAddress& b,
                                  const std::string& metric, SampleState state) const {
    const std::vector<double> of_a = get_values(a, metric, state);
    const std::vector<double> of_b = get_values(b, metric, state);
    if (of_a.empty() || of_a.size() != of_b.size()) {
        throw InputError("reproduce", "frames of " + a.label + " and " + b.label + " differ",
                         metric);
    }
    std::vector<double> differences;
    for (std::size_t i = 0; i < of_a.size(); ++i) {
        differences.push_back(of_a[i] - of_b[i]);
    }
    return estimate_across_repeats(differences);
}

std::string Evidence::find_image_hash(const CellAddress& address, int frame) const {
    const RoundRecord& round = get_round(address.part, address.round);
    const CellRecord& cell = get_cell(address);
    for (const MetricRow& row : get_part(address.part).metrics) {
        if (row.round == round.id && row.cell == cell.id && row.frame == frame) {
            return row.image_hash;
        }
    }
    throw InputError("reproduce", "no metric of frame " + std::to_string(frame), address.label);
}

Estimate Evidence::estimate_metric(const CellAddress& address, const std::string& metric,
                                   SampleState state) const {
    const std::vector<double> values = get_values(address, metric, state);
    if (values.empty()) {
        throw InputError("reproduce", "no value of " + metric, address.label);
    }
    return estimate_across_repeats(values);
}

} // namespace alcove
