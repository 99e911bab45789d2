#pragma once
// Gates of `metric`: `flip:ppd=30<0.05,ssim>=0.9`.

#include "harness/app/metric_means.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace alcove {

/// METRIC<NUMBER, or with <=, > or >=.
struct GateCondition {
    std::string text;
    std::string metric; ///< a specification, `metric.extra`, or a program's key
    bool is_less = true;
    bool or_equal = false;
    double bound = 0.0;
    [[nodiscard]] bool holds(double value) const;
};

/// Conditions apart by commas. A specification may hold commas of its own: what stands before a
/// comparison belongs to it. Throws InputError on what cannot be read.
[[nodiscard]] std::vector<GateCondition> parse_gate(std::string_view text);

/// The specifications of metrics of ours that conditions speak of and that `chosen` lacks;
/// also a name that is no metric, which choose_metrics refuses, unless `may_be_key`: a program may
/// give it.
[[nodiscard]] std::vector<std::string> list_gated_metrics(const std::vector<GateCondition>& gate,
                                                          const std::vector<std::string>& chosen,
                                                          const Registry<MetricUnit>& registry,
                                                          bool may_be_key);

/// Do all conditions hold? Says on standard error which do not; a value that is undefined holds
/// none. Throws InputError on a name that nothing gave.
[[nodiscard]] bool check_gate(const std::vector<GateCondition>& gate, const MetricMeans& means);

} // namespace alcove
