#pragma once
// How a metric is named: NAME[@values|@view|@linear|@codes][:key=value,...], for example
// `flip@codes` or `ms_ssim:low_pass=mean`. The text is also the metric's column.

#include "core/base/registry.hpp"
#include "core/contract/temporal_metric.hpp"

namespace alcove {

struct MetricSpec {
    std::string text; ///< as it was given
    std::string name;
    std::optional<MetricDomain> domain; ///< nothing: the unit's
    std::vector<ParameterOverride> overrides;
};

/// Throws InputError naming `where`. Names and values are checked by resolve_metric.
[[nodiscard]] MetricSpec parse_metric_spec(std::string_view text, std::string_view where);

/// A unit of a registry with its parameters and the domain it runs on.
struct ResolvedMetric {
    const MetricUnit* unit = nullptr;
    MetricDomain domain = MetricDomain::values;
    ResolvedParameters parameters;
    [[nodiscard]] std::unique_ptr<Metric> create() const { return unit->create(parameters); }
    [[nodiscard]] std::unique_ptr<TemporalMetric> create_temporal() const {
        return unit->create_temporal(parameters);
    }
};

/// Throws InputError on an unknown metric or parameter, a value out of range, or a domain for a
/// metric over time, which has none to choose. `metrics` must outlive the result.
[[nodiscard]] ResolvedMetric resolve_metric(const Registry<MetricUnit>& metrics,
                                            const MetricSpec& spec);

/// Parses and resolves each text to see that it can be, and that none stands twice. Throws
/// InputError naming `where`.
void check_metric_specs(const Registry<MetricUnit>& metrics, const std::vector<std::string>& texts,
                        std::string_view where);

/// What runs measure where nothing is named: all that are reported and not on demand, and those of
/// pictures where a target of the run is radiance.
[[nodiscard]] std::vector<std::string> list_default_metrics(const Registry<MetricUnit>& metrics,
                                                            bool has_pictures);

} // namespace alcove
