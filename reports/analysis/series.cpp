#include "reports/analysis/series.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alcove {

void Series::add(FrameKey frame, int repeat, std::int64_t time_ns) {
    m_times_ns[frame][repeat] += static_cast<double>(time_ns);
}

std::vector<double> Series::get_repeats_ns(FrameKey frame) const {
    const auto found = m_times_ns.find(frame);
    return found == m_times_ns.end() ? std::vector<double>() : get_values(found->second);
}

std::map<int, double> Series::compute_repeat_medians_ms() const {
    std::map<int, std::vector<double>> frames;
    for (const auto& [frame, repeats] : m_times_ns) {
        for (const auto& [repeat, time_ns] : repeats) {
            frames[repeat].push_back(time_ns * 1e-6);
        }
    }
    std::map<int, double> medians;
    for (const auto& [repeat, times] : frames) {
        medians[repeat] = compute_median(times);
    }
    return medians;
}

std::optional<Estimate> estimate_time_ms(const Series& series) {
    if (series.empty()) {
        return std::nullopt;
    }
    return estimate_across_repeats(get_values(series.compute_repeat_medians_ms()));
}

std::vector<double> get_values(const std::map<int, double>& per_repeat) {
    std::vector<double> values;
    for (const auto& [repeat, value] : per_repeat) {
        values.push_back(value);
    }
    return values;
}

namespace {

/// Two series over the frames and repeats of both.
struct PairedTables {
    RepeatsByFrames a;
    RepeatsByFrames b;
};

PairedTables make_tables(const Series& a, const Series& b) {
    std::map<FrameKey, std::size_t> columns;
    std::size_t repeats = 0;
    for (const Series* series : {&a, &b}) {
        for (const auto& [frame, times] : series->times_ns()) {
            columns.emplace(frame, columns.size());
            repeats = std::max(repeats, static_cast<std::size_t>(times.rbegin()->first) + 1);
        }
    }
    const auto spread = [&](const Series& series) {
        RepeatsByFrames table(
            repeats, std::vector<double>(columns.size(), std::numeric_limits<double>::quiet_NaN()));
        for (const auto& [frame, times] : series.times_ns()) {
            for (const auto& [repeat, time_ns] : times) {
                table[static_cast<std::size_t>(repeat)][columns.at(frame)] = time_ns;
            }
        }
        return table;
    };
    return {spread(a), spread(b)};
}

} // namespace

std::optional<Estimate> estimate_ratio(const Series& a, const Series& b) {
    const PairedTables tables = make_tables(a, b);
    return estimate_paired_ratio(tables.a, tables.b);
}

std::map<int, double> compute_log_ratios(const Series& a, const Series& b) {
    const PairedTables tables = make_tables(a, b);
    const std::vector<double> logs = compute_paired_log_ratios(tables.a, tables.b);
    std::map<int, double> per_repeat;
    for (std::size_t repeat = 0; repeat < logs.size(); ++repeat) {
        if (!std::isnan(logs[repeat])) {
            per_repeat[static_cast<int>(repeat)] = logs[repeat];
        }
    }
    return per_repeat;
}

} // namespace alcove
