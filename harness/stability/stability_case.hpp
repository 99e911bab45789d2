#pragma once
// The contract of a hard case: a tiny scene or a damaged input, a severity that goes from mild to
// harsh, and a score that is held against a bound with a reason. Deterministic: equal subject, size
// and severity give equal scores.

#include "harness/stability/stability_subject.hpp"
#include "reports/record/stability_record.hpp"

#include <functional>
#include <string>

namespace alcove {

/// What a method did at one severity.
struct StabilityScore {
    double score = 0.0; ///< in StabilityCaseRecord::score_unit, lower is better
    double bound = 0.0; ///< the same unit, >= 0; fails above it
    std::string fault;  ///< see StabilityScoreRecord
    Image picture;      ///< a visibility that shows it
};

struct StabilityCase {
    /// Name, trigger, source, axis, severities, invariant, unit and the bound's reason.
    StabilityCaseRecord about;
    /// Why the case does not apply to a method; empty if it does.
    std::function<std::string(const StabilitySubject&)> find_obstacle =
        [](const StabilitySubject&) { return std::string(); };
    /// Renders the method through the trigger, with instances of its own. `size` is a wish: a case
    /// that needs a shape (a square, odd sizes) derives it.
    std::function<StabilityScore(const StabilitySubject&, ImageSize size, double severity)> measure;
};

/// Severities from their values, labelled "VALUE UNIT".
[[nodiscard]] std::vector<StabilitySeverityRecord>
label_severities(std::initializer_list<double> values, const std::string& unit);

} // namespace alcove
