#pragma once
// The report's page: one file that opens from a disk without a network. Everything but the charts,
// the picture viewer and the film is readable without JavaScript.

#include "reports/analysis/analysis.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace alcove {

struct HtmlOptions {
    bool in_progress = false;                ///< the run is still working: the page says so
    std::vector<ProvisionalRow> provisional; ///< first times of the round in flight
    std::filesystem::path out;               ///< folder of index.html; empty: <run>/report
};

/// Analyses the run and writes index.html, atomically: fit to be called after every round while
/// somebody reads it. Throws InputError on a malformed run folder, FailureError if the page cannot
/// be written.
void write_html_report(const RunFolder& run, const HtmlOptions& options);

} // namespace alcove
