#include "harness/app/night_reports.hpp"

#include "core/base/file.hpp"
#include "reports/analysis/history_wording.hpp"
#include "reports/google_benchmark/google_benchmark.hpp"
#include "reports/html/dashboard_page.hpp"
#include "reports/junit/junit.hpp"
#include "reports/markdown/night_markdown.hpp"

#include <cstdio>

#include <fmt/format.h>

namespace alcove {
namespace {

std::filesystem::path get_page(const std::filesystem::path& store_folder) {
    return store_folder / "dashboard" / "index.html";
}

} // namespace

void write_night_reports(const Night& night, const RunFolder& run, const StoredHistory& history,
                         const std::filesystem::path& out,
                         const std::filesystem::path& store_folder) {
    write_file_atomically(out / "junit.xml", make_junit_xml(night));
    write_file_atomically(out / "benchmark.json", make_google_benchmark_json(run));
    write_file_atomically(out / "summary.md", make_night_markdown(night));
    write_file_atomically(get_page(store_folder), make_dashboard_page(history));
}

void print_night(const Night& night, const std::filesystem::path& out,
                 const std::filesystem::path& store_folder) {
    fmt::print("\nnight {} of {}: {}\n", night.past_nights + 1, night.run.suite,
               summarize_night(night));
    for (const NightLine& line : list_findings(night)) {
        const SeriesName& name = line.judged->point.name;
        fmt::print("  {:<13} {} in {} {}: {} {}\n", to_text(line.judged->verdict), name.method,
                   name.scene, name.size, line.what, line.tonight);
        if (!line.baseline.empty()) {
            fmt::print("  {:<13} against {}: {}, fence {}\n", "", line.baseline, line.change,
                       line.fence);
        }
        if (!line.note.empty()) {
            fmt::print("  {:<13} {}\n", "", line.note);
        }
    }
    fmt::print("summary: {}\ndashboard: {}\n", (out / "summary.md").string(),
               get_page(store_folder).string());
    std::fflush(stdout);
    if (const std::size_t young = night.count(NightVerdict::too_little_history); young > 0) {
        fmt::print(stderr,
                   "alcove: note: {} of {} series have too little history for a verdict: {} "
                   "differences are needed\n",
                   young, night.points.size(), kFewestDifferences);
    }
}

} // namespace alcove
