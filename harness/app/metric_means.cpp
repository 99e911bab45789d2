#include "harness/app/metric_means.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace alcove {

std::optional<double> MetricMean::mean() const {
    return values > 0 && values == pairs ? std::optional(sum / static_cast<double>(values))
                                         : std::nullopt;
}

std::string MetricMean::describe_lack() const {
    const std::string why = reason.empty() ? "no value" : reason;
    return pairs > 1 ? fmt::format("{} (and so {} of {} pairs)", why, pairs - values, pairs) : why;
}

void MetricMeans::add(const std::vector<PairScore>& scores, const std::string& pair) {
    ++m_pairs;
    for (const PairScore& score : scores) {
        const std::string reason = pair + ": " + score.result.undefined_reason;
        add_value(score.name, score.unit, false, score.result.value, reason);
        for (const NamedValue& extra : score.result.extras) {
            add_value(score.name + "." + extra.name, "", true, extra.value, "");
        }
    }
}

void MetricMeans::add_value(const std::string& name, const std::string& unit, bool is_extra,
                            std::optional<double> value, const std::string& reason) {
    auto mean = std::find_if(m_means.begin(), m_means.end(),
                             [&name](const MetricMean& known) { return known.name == name; });
    if (mean == m_means.end()) {
        MetricMean fresh;
        fresh.name = name;
        fresh.unit = unit;
        fresh.is_extra = is_extra;
        mean = m_means.insert(m_means.end(), std::move(fresh));
    }
    if (!value) {
        mean->reason = reason;
        return;
    }
    mean->sum += *value;
    mean->smallest = mean->values == 0 ? *value : std::min(mean->smallest, *value);
    mean->largest = mean->values == 0 ? *value : std::max(mean->largest, *value);
    ++mean->values;
}

std::vector<MetricMean> MetricMeans::list() const {
    std::vector<MetricMean> means = m_means;
    for (MetricMean& mean : means) {
        mean.pairs = m_pairs;
    }
    return means;
}

std::optional<MetricMean> MetricMeans::find(const std::string& name) const {
    for (MetricMean& mean : list()) {
        if (mean.name == name) {
            return std::move(mean);
        }
    }
    return std::nullopt;
}

} // namespace alcove
