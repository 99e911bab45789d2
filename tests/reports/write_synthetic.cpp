// Writes synthetic runs with their pages for the browser test (tests/web): FOLDER/complete,
// FOLDER/hostile, FOLDER/radiance.

#include "core/base/error.hpp"
#include "reports/csv/summary_csv.hpp"
#include "reports/csv/tradeoff_csv.hpp"
#include "reports/html/html_report.hpp"
#include "tests/reports/synthetic_run.hpp"

#include <iostream>

int main(int argc, char** argv) {
    using namespace alcove;
    if (argc != 2) {
        std::cerr << "usage: alcove_write_synthetic FOLDER\n";
        return 2;
    }
    try {
        const std::filesystem::path folder = argv[1];
        const RunFolder complete = synthetic::write_run(folder / "complete", {.images = true});
        write_summary_csv(complete, analyze_run(complete));
        write_tradeoff_csv(complete, analyze_run(complete));
        write_html_report(complete, {});
        write_html_report(
            synthetic::write_run(folder / "radiance", {.images = true, .radiance = true}), {});
        const RunFolder hostile = synthetic::write_run(
            folder / "hostile", {.finished_rounds = 1, .hostile = true, .images = true});
        const RoundRecord& waiting = hostile.plan().rounds[1];
        write_html_report(hostile,
                          {.in_progress = true,
                           .provisional = {{waiting.id, "tssao", waiting.cells[5].label, 12.5}},
                           .out = {}});
    } catch (const Error& error) {
        std::cerr << error.what() << '\n';
        return error.exit_code();
    }
    return 0;
}
