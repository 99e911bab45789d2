#include "core/base/error.hpp"
#include "harness/app/reports.hpp"
#include "harness/app/verbs.hpp"

#include <memory>

#include <CLI/CLI.hpp>

namespace alcove {
namespace {

struct ReportFlags {
    std::vector<std::string> runs;
    std::string out;
};

int write_all(const ReportFlags& flags) {
    namespace fs = std::filesystem;
    for (const std::string& path : flags.runs) {
        const RunFolder run = RunFolder::open(path);
        fs::path out;
        if (!flags.out.empty()) {
            // Several runs share a folder by their own names.
            out = flags.runs.size() == 1
                      ? fs::path(flags.out)
                      : fs::path(flags.out) / fs::weakly_canonical(run.path()).filename();
        }
        run.rebuild_tables();
        write_reports(run, !run.is_complete(), {}, out);
        print_table(run, out);
    }
    return 0;
}

} // namespace

Action add_report_verb(CLI::App& app) {
    auto flags = std::make_shared<ReportFlags>();
    app.add_option("runs", flags->runs, "run folders")->required();
    app.add_option("--out", flags->out, "folder of the page; default <run>/report");
    return [flags] { return write_all(*flags); };
}

} // namespace alcove
