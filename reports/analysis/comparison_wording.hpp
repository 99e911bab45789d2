#pragma once
// How a comparison is put for people, the same in the terminal, in Markdown and on the page.

#include "reports/analysis/comparison.hpp"

#include <string>
#include <vector>

namespace alcove {

/// One verdict (or, without one, one piece of information) in words.
struct ComparisonRow {
    std::optional<Verdict> verdict;
    const CellComparison* cell = nullptr; ///< of the comparison, which must outlive the row
    std::string what;                     ///< "time", "rmse cold", "pass tssao/blur"
    std::string base;
    std::string next;
    std::string change;
    std::string margin; ///< "within 2 %"; empty without verdict
    std::string p_holm; ///< "0.012"; empty where there is none, as the next two
    std::string p_bh;
    std::string ranks; ///< "MW 0.0043, KS 0.0043"
    std::string note;
};

/// "p 0.012, MW 0.0043, KS 0.0043, BH 0.02", with the note: for tables without room for columns.
[[nodiscard]] std::string describe_evidence(const ComparisonRow& row);

/// Times and metrics, worst first.
[[nodiscard]] std::vector<ComparisonRow> list_verdicts(const Comparison& comparison);
/// Passes, input costs and converged times in units of the anchor, and numbers of histories.
[[nodiscard]] std::vector<ComparisonRow> list_information(const Comparison& comparison);

/// "3 worse, 1 unknown, 0 better, 20 same".
[[nodiscard]] std::string summarize_verdicts(const Comparison& comparison);
/// "discoveries among 40 comparisons ...: 2 of 8 times, ..."
[[nodiscard]] std::string describe_discoveries(const Comparison& comparison);
/// One line a cell whose images differ, or one that says that all are identical.
[[nodiscard]] std::vector<std::string> describe_images(const Comparison& comparison);
/// "tssao: same label, other settings: samples 16 -> 32".
[[nodiscard]] std::vector<std::string> describe_settings(const Comparison& comparison);
/// "only BASE: tssao in ...: why"
[[nodiscard]] std::vector<std::string> describe_unpaired(const Comparison& comparison);
/// What the words and brackets mean, with the device: a line each.
[[nodiscard]] std::vector<std::string> describe_method(const Comparison& comparison);

} // namespace alcove
