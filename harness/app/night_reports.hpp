#pragma once
// What `nightly` leaves behind and says.

#include "reports/analysis/history_night.hpp"
#include "reports/record/record.hpp"

#include <filesystem>

namespace alcove {

/// junit.xml, benchmark.json and summary.md into `out`, and the page into
/// <store_folder>/dashboard/index.html. `history` holds tonight already.
void write_night_reports(const Night& night, const RunFolder& run, const StoredHistory& history,
                         const std::filesystem::path& out,
                         const std::filesystem::path& store_folder);

/// The findings and where the pages are, on standard output; what cannot be judged yet on standard
/// error.
void print_night(const Night& night, const std::filesystem::path& out,
                 const std::filesystem::path& store_folder);

} // namespace alcove
