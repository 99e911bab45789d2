#include "reports/record/stability_record.hpp"

#include "core/base/assert.hpp"
#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/text.hpp"
#include "reports/record/record_json.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace alcove {
namespace {

constexpr const char* kFile = "stability.json";

void check_case(const StabilityCaseRecord& record, const std::string& where) {
    if (!is_safe_id(record.name)) {
        throw InputError(where + ".name", "not a safe folder name", record.name, "[a-z0-9_.-]");
    }
    if (record.severities.empty()) {
        throw InputError(where + ".severities", "empty", "", "one or more");
    }
    const bool rises = record.severities.back().value > record.severities.front().value;
    for (std::size_t i = 1; i < record.severities.size(); ++i) {
        const double before = record.severities[i - 1].value;
        const double here = record.severities[i].value;
        if (rises ? !(here > before) : !(here < before)) {
            throw InputError(where + ".severities[" + std::to_string(i) + "].value",
                             "not from mild to harsh", format_number(here),
                             "strictly rising or falling values");
        }
    }
}

void check_scores(const StabilityCellRecord& cell, const StabilityCaseRecord& described,
                  const std::filesystem::path& folder, const std::string& where) {
    if (cell.outcome == StabilityOutcome::not_applicable) {
        if (!cell.scores.empty() || cell.reason.empty()) {
            throw InputError(where, "not applicable", "scores, or no reason", "a reason alone");
        }
        return;
    }
    if (cell.scores.size() != described.severities.size()) {
        throw InputError(where + ".scores", "wrong length", std::to_string(cell.scores.size()),
                         std::to_string(described.severities.size()) + ", one a severity");
    }
    for (std::size_t i = 0; i < cell.scores.size(); ++i) {
        const std::string place = where + ".scores[" + std::to_string(i) + "]";
        if (!(cell.scores[i].bound >= 0.0)) {
            throw InputError(place + ".bound", "no bound", format_number(cell.scores[i].bound),
                             "0 or more");
        }
        if (!cell.scores[i].picture.empty()) {
            static_cast<void>(resolve_inside(folder, cell.scores[i].picture));
        }
    }
    const StabilityVerdict verdict = judge(cell.scores);
    // Numbers of JSON read back exactly.
    if (verdict.outcome != cell.outcome || verdict.worst_margin != cell.worst_margin) {
        throw InputError(where + ".outcome", "does not follow from the scores",
                         std::string(to_text(cell.outcome)), to_text(verdict.outcome));
    }
}

void check(const StabilityRecord& record, const std::filesystem::path& folder,
           const std::string& file) {
    std::set<std::string> names;
    for (std::size_t i = 0; i < record.cases.size(); ++i) {
        const std::string where = file + ": cases[" + std::to_string(i) + "]";
        check_case(record.cases[i], where);
        if (!names.insert(record.cases[i].name).second) {
            throw InputError(where + ".name", "stands twice", record.cases[i].name, "its own name");
        }
    }
    std::set<std::string> labels;
    for (const StabilityMethodRecord& method : record.methods) {
        if (!labels.insert(method.label).second) {
            throw InputError(file + ": methods", "stands twice", method.label,
                             "labels that differ");
        }
    }
    const std::size_t expected = record.cases.size() * record.methods.size();
    if (record.cells.size() != expected) {
        throw InputError(file + ": cells", "wrong length", std::to_string(record.cells.size()),
                         std::to_string(expected) + ", one a case and method");
    }
    for (std::size_t i = 0; i < record.cells.size(); ++i) {
        const std::string where = file + ": cells[" + std::to_string(i) + "]";
        const StabilityCaseRecord& described = record.cases[i / record.methods.size()];
        const StabilityMethodRecord& method = record.methods[i % record.methods.size()];
        const StabilityCellRecord& cell = record.cells[i];
        if (cell.case_name != described.name || cell.label != method.label) {
            throw InputError(where, "out of order", cell.case_name + ", " + cell.label,
                             described.name + ", " + method.label);
        }
        check_scores(cell, described, folder, where);
    }
}

} // namespace

std::string_view to_text(StabilityOutcome outcome) {
    switch (outcome) {
    case StabilityOutcome::holds:
        return "holds";
    case StabilityOutcome::holds_up_to:
        return "holds_up_to";
    case StabilityOutcome::fails:
        return "fails";
    case StabilityOutcome::not_applicable:
        break;
    }
    return "not_applicable";
}

double compute_margin(const StabilityScoreRecord& score) {
    constexpr double kNone = -std::numeric_limits<double>::infinity();
    if (!score.fault.empty() || !std::isfinite(score.score)) {
        return kNone;
    }
    if (score.bound == 0.0) {
        return score.score <= 0.0 ? 1.0 : kNone;
    }
    return (score.bound - score.score) / score.bound;
}

bool holds(const StabilityScoreRecord& score) {
    return compute_margin(score) >= 0.0;
}

StabilityVerdict judge(std::span<const StabilityScoreRecord> scores) {
    ALCOVE_ASSERT(!scores.empty(), "a case has a severity");
    StabilityVerdict verdict;
    verdict.worst_margin = std::numeric_limits<double>::infinity();
    for (const StabilityScoreRecord& score : scores) {
        verdict.worst_margin = std::min(verdict.worst_margin, compute_margin(score));
    }
    const auto first_failure = std::find_if(
        scores.begin(), scores.end(), [](const StabilityScoreRecord& s) { return !holds(s); });
    verdict.held = static_cast<std::size_t>(first_failure - scores.begin());
    verdict.outcome = first_failure == scores.end() ? StabilityOutcome::holds
                      : verdict.held > 0            ? StabilityOutcome::holds_up_to
                                                    : StabilityOutcome::fails;
    return verdict;
}

const StabilityCellRecord& find_cell(const StabilityRecord& record, std::string_view case_name,
                                     std::string_view label) {
    const auto found =
        std::find_if(record.cells.begin(), record.cells.end(), [&](const StabilityCellRecord& c) {
            return c.case_name == case_name && c.label == label;
        });
    ALCOVE_ASSERT(found != record.cells.end(), "every method has a cell in every case");
    return *found;
}

std::size_t count_failures(const StabilityRecord& record) {
    return static_cast<std::size_t>(
        std::count_if(record.cells.begin(), record.cells.end(), [](const StabilityCellRecord& c) {
            return c.outcome == StabilityOutcome::fails ||
                   c.outcome == StabilityOutcome::holds_up_to;
        }));
}

void write_stability(const std::filesystem::path& folder, const StabilityRecord& record) {
    write_file_atomically(folder / kFile, make_json(record));
}

StabilityRecord read_stability(const std::filesystem::path& folder) {
    const std::filesystem::path path = folder / kFile;
    StabilityRecord record = parse_stability_json(read_file(path), path.string());
    check(record, folder, path.string());
    return record;
}

} // namespace alcove
