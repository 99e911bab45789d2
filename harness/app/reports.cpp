#include "harness/app/reports.hpp"

#include "reports/csv/explanation_csv.hpp"
#include "reports/csv/passes_csv.hpp"
#include "reports/csv/strata_csv.hpp"
#include "reports/csv/summary_csv.hpp"
#include "reports/csv/target_csv.hpp"
#include "reports/csv/tradeoff_csv.hpp"
#include "reports/html/html_report.hpp"
#include "reports/terminal/terminal_report.hpp"

#include <cstdio>

namespace alcove {
namespace {

std::filesystem::path get_page_folder(const RunFolder& run, const std::filesystem::path& out) {
    return out.empty() ? run.path() / "report" : out;
}

} // namespace

void write_reports(const RunFolder& run, bool in_progress, std::vector<ProvisionalRow> provisional,
                   const std::filesystem::path& out) {
    const RunAnalysis analysis = analyze_run(run);
    write_summary_csv(run, analysis);
    write_passes_csv(run, analysis);
    write_tradeoff_csv(run, analysis);
    write_target_csv(run, analysis);
    write_explanation_csv(run, analysis);
    write_strata_csv(run, analysis);
    write_html_report(run, {in_progress, std::move(provisional), get_page_folder(run, out)});
}

void print_table(const RunFolder& run, const std::filesystem::path& out) {
    const std::string text =
        make_terminal_report(analyze_run(run), get_page_folder(run, out) / "index.html");
    std::fputs(text.c_str(), stdout);
    std::fflush(stdout);
}

} // namespace alcove
