#include "harness/stability/stability_case.hpp"

#include "core/base/text.hpp"

namespace alcove {

std::vector<StabilitySeverityRecord> label_severities(std::initializer_list<double> values,
                                                      const std::string& unit) {
    std::vector<StabilitySeverityRecord> severities;
    for (const double value : values) {
        severities.push_back({value, format_rounded(value) + (unit.empty() ? "" : " " + unit)});
    }
    return severities;
}

} // namespace alcove
