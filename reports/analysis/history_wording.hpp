#pragma once
// How a night is put for people, the same in the terminal, in Markdown, in JUnit's XML and on the
// dashboard.

#include "reports/analysis/history_night.hpp"

#include <string>
#include <vector>

namespace alcove {

/// "time cold", "pass tssao/blur", "rmse converged", "images".
[[nodiscard]] std::string describe_series(SeriesKind kind, const SeriesName& name);
/// "bunny 128x96, frames 0:16, radius=...": where it was measured.
[[nodiscard]] std::string describe_place(const SeriesName& name);

/// "2.61 x anchor", "0.0452", "27 images".
[[nodiscard]] std::string describe_value(SeriesKind kind, double value);
/// "+5.1 %" of a time, "+0.0012" of a metric; `change` as in StoredVerdict.
[[nodiscard]] std::string describe_change(SeriesKind kind, double change);

/// One point of a night in words.
struct NightLine {
    const JudgedPoint* judged = nullptr; ///< of the night, which must outlive the line
    std::string what;
    std::string tonight;
    std::string baseline; ///< empty where there is none, as what follows
    std::string change;
    std::string fence; ///< "2.3 %"
    std::string note;
};

/// Everything that left its fence, failures first.
[[nodiscard]] std::vector<NightLine> list_findings(const Night& night);
[[nodiscard]] NightLine describe_point(const Night& night, const JudgedPoint& judged);

/// "2 slower, 1 image changed, 0 worse; 240 the same".
[[nodiscard]] std::string summarize_night(const Night& night);
/// What the words mean: a line each.
[[nodiscard]] std::vector<std::string> describe_rules();
/// "software: llvmpipe, ..., clock timestamp_finish".
[[nodiscard]] std::string describe_device(const StoredRun& run);

} // namespace alcove
