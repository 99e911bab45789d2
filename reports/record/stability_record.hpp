#pragma once
// What `alcove stability` leaves behind: every method through every hard case, one score a
// severity, held against a bound. The layout is documented in reports/README.md.
//
//   stability.json                          everything but the pictures; written whole or not at
//   all images/<case>/<method>_<severity>.png   what failed, at the mildest and the harshest
//   severity stability.csv, stability.html           made from the record

#include "reports/record/record.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace alcove {

/// Raised whenever the file's layout or a key's meaning changes.
inline constexpr int kStabilitySchemaVersion = 1;

/// What a method did in a case. holds_up_to: the mildest severities hold, a harsher one does not.
enum class StabilityOutcome { holds, holds_up_to, fails, not_applicable };
[[nodiscard]] std::string_view to_text(StabilityOutcome outcome);

/// A method at one severity.
struct StabilityScoreRecord {
    double score = 0.0; ///< in the case's unit, lower is better; infinite if it has none
    double bound = 0.0; ///< the same unit, >= 0
    /// What is wrong whatever the score: NaN or infinity, visibility outside [0,1], a background
    /// that is not exactly 1; empty if nothing is.
    std::string fault;
    std::string picture; ///< path inside the folder; empty if none is kept
};

struct StabilitySeverityRecord {
    double value = 0.0; ///< in the axis's unit
    std::string label;  ///< what people read: "1000 m"
};

/// A hard case, described.
struct StabilityCaseRecord {
    std::string name; ///< safe as a folder name
    std::string title;
    std::string trigger;
    std::string source;
    std::string axis;
    std::string axis_unit;
    std::vector<StabilitySeverityRecord> severities; ///< mild to harsh, strictly monotone
    std::string invariant;
    std::string score;      ///< what the score is
    std::string score_unit; ///< of score and bound
    std::string bound_reason;
};

struct StabilityMethodRecord {
    std::string label; ///< unique
    std::string method;
    std::string preset;
    std::string content_hash;
    std::vector<ParameterRecord> overrides; ///< over the preset, as asked for
};

/// A method in a case.
struct StabilityCellRecord {
    std::string case_name;
    std::string label;
    StabilityOutcome outcome = StabilityOutcome::holds;
    std::string reason;        ///< why it is not applicable; empty otherwise
    double worst_margin = 0.0; ///< smallest margin over the severities; 0 if not applicable
    std::vector<StabilityScoreRecord> scores; ///< one a severity; empty if not applicable
};

struct StabilityRecord {
    int schema_version = kStabilitySchemaVersion;
    std::string command_line;
    int width = 0;
    int height = 0;
    ContextRecord context;
    std::vector<StabilityCaseRecord> cases;
    std::vector<StabilityMethodRecord> methods;
    std::vector<StabilityCellRecord> cells; ///< case by case, methods in their order
};

/// (bound - score) / bound: 1 is perfect, 0 just holds, below 0 fails. Minus infinity where there
/// is a fault, where the score is not finite, and where a bound of 0 is not met; 1 where it is met.
[[nodiscard]] double compute_margin(const StabilityScoreRecord& score);
/// A margin of 0 or more.
[[nodiscard]] bool holds(const StabilityScoreRecord& score);

/// Outcome and worst margin from the scores, which are in the order of the severities. Asserts that
/// there is one.
struct StabilityVerdict {
    StabilityOutcome outcome = StabilityOutcome::holds;
    double worst_margin = 0.0;
    std::size_t held = 0; ///< severities from the mildest on that hold
};
[[nodiscard]] StabilityVerdict judge(std::span<const StabilityScoreRecord> scores);

/// A cell's place in the matrix. Asserts that it is there, as it is in a record that was read.
[[nodiscard]] const StabilityCellRecord&
find_cell(const StabilityRecord& record, std::string_view case_name, std::string_view label);
/// Cells that do not hold at all severities they apply to.
[[nodiscard]] std::size_t count_failures(const StabilityRecord& record);

/// Writes <folder>/stability.json atomically. Throws FailureError.
void write_stability(const std::filesystem::path& folder, const StabilityRecord& record);
/// Reads it strictly: beyond the checks of record_json, every method has one cell in every case,
/// severities are strictly monotone, scores fit them, outcomes and margins follow from the scores,
/// and pictures lie inside the folder. Throws InputError naming file and key.
[[nodiscard]] StabilityRecord read_stability(const std::filesystem::path& folder);

} // namespace alcove
