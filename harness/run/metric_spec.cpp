#include "harness/run/metric_spec.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"

#include <set>

namespace alcove {

MetricSpec parse_metric_spec(std::string_view text, std::string_view where) {
    MetricSpec spec;
    spec.text = text;
    std::string_view rest = text;
    if (const std::size_t colon = rest.find(':'); colon != std::string_view::npos) {
        std::set<std::string> keys;
        for (const KeyValue& entry : parse_key_values(rest.substr(colon + 1), where)) {
            if (!keys.insert(entry.key).second) {
                throw InputError(where, "parameter stands twice", entry.key, "each one once");
            }
            spec.overrides.push_back({entry.key, entry.value, Provenance::command_line});
        }
        rest = rest.substr(0, colon);
    }
    if (const std::size_t at = rest.find('@'); at != std::string_view::npos) {
        spec.domain = parse_metric_domain(rest.substr(at + 1), where);
        rest = rest.substr(0, at);
    }
    spec.name = rest;
    return spec;
}

ResolvedMetric resolve_metric(const Registry<MetricUnit>& metrics, const MetricSpec& spec) {
    const MetricUnit& unit = metrics.find(spec.name);
    if (unit.is_temporal() && spec.domain) {
        throw InputError(spec.text, "a metric over time runs on linear values",
                         "@" + std::string(to_text(*spec.domain)), "no domain");
    }
    ResolvedMetric resolved{&unit, spec.domain.value_or(unit.domain),
                            unit.parameters.resolve(spec.overrides, {})};
    // A unit may refuse what its table cannot express.
    if (unit.is_temporal()) {
        static_cast<void>(resolved.create_temporal());
    } else {
        static_cast<void>(resolved.create());
    }
    return resolved;
}

void check_metric_specs(const Registry<MetricUnit>& metrics, const std::vector<std::string>& texts,
                        std::string_view where) {
    std::set<std::string> seen;
    for (const std::string& text : texts) {
        static_cast<void>(resolve_metric(metrics, parse_metric_spec(text, where)));
        if (!seen.insert(text).second) {
            throw InputError(where, "metric stands twice", text, "each one once");
        }
    }
}

std::vector<std::string> list_default_metrics(const Registry<MetricUnit>& metrics,
                                              bool has_pictures) {
    std::vector<std::string> names;
    for (const MetricUnit& unit : metrics.units()) {
        const bool is_wanted = !unit.on_demand || (has_pictures && unit.is_of_pictures);
        if (unit.reported && is_wanted) {
            names.push_back(unit.name);
        }
    }
    return names;
}

} // namespace alcove
