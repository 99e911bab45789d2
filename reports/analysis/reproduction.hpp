#pragma once
// What a reproduction of a paper says: a verdict a claim, tables and figures with the published
// numbers beside the measured ones. A value; the reports only lay it out.

#include "core/base/statistics.hpp"
#include "reports/record/record.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace alcove {

/// A line of reports/papers/claims.csv.
struct Claim {
    std::string id;    ///< "TSSAO-002"
    std::string paper; ///< "TSSAO"
    std::string location;
    std::string kind; ///< "table", "figure", "text", "parameter"
    std::string scene;
    std::string resolution;
    std::string setting;
    std::string quantity;
    std::string value;
    std::string unit;
    std::string shape; ///< what must hold on any hardware
};

/// Where print or its extraction is ambiguous, and how it is read here.
struct Erratum {
    std::string paper;
    std::string location;
    std::string printed;
    std::string reading;
};

/// inconclusive: the interval holds the bound. not_testable: nothing here could decide it.
enum class Outcome { holds, fails, inconclusive, not_testable };
[[nodiscard]] std::string_view to_text(Outcome outcome);

struct ClaimVerdict {
    Claim claim;
    Outcome outcome = Outcome::not_testable;
    std::string tested;               ///< the hardware-independent form, as it was tested
    std::optional<Estimate> measured; ///< what was compared, with its interval
    std::string why;                  ///< on what, or why it is not testable here
};

struct OutcomeCount {
    Outcome outcome;
    std::size_t claims = 0;
};
/// Every outcome, also those without a claim.
[[nodiscard]] std::vector<OutcomeCount> count_outcomes(const std::vector<ClaimVerdict>& verdicts);

/// A table of the paper, or a figure's data.
struct PaperTable {
    std::string id;    ///< safe as a file's name: "table2"
    std::string title; ///< "Table 2: frame rates"
    std::string note;  ///< on what, and what to read it by
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows; ///< as many fields as columns
};

struct FigurePicture {
    std::string caption;
    std::string path; ///< relative to the reproduction's folder
};

/// A row of pictures of a figure.
struct PaperFigure {
    std::string title;
    std::string note;
    std::vector<FigurePicture> pictures;
};

struct Reproduction {
    std::string paper;    ///< "TSSAO"
    std::string citation; ///< author. title. year.
    std::string scale;    ///< "small"
    ContextRecord context;
    std::vector<ClaimVerdict> verdicts; ///< in the order of claims.csv
    std::vector<PaperTable> tables;
    std::vector<PaperFigure> figures;
    std::vector<Erratum> errata;
};

/// "12 hold, 3 fail, 2 inconclusive, 40 not testable here"
[[nodiscard]] std::string describe_counts(const Reproduction& reproduction);

} // namespace alcove
