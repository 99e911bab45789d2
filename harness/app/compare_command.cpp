#include "harness/app/comparing.hpp"
#include "harness/app/verbs.hpp"

#include <memory>

#include <CLI/CLI.hpp>

namespace alcove {
namespace {

struct CompareFlags {
    std::string base;
    std::string next;
    std::string out;
    GateFlags gate;
};

int compare(const CompareFlags& flags) {
    const ComparisonOptions options = read_gate_flags(flags.gate);
    const RunFolder base = RunFolder::open(flags.base);
    const RunFolder next = RunFolder::open(flags.next);
    return report_comparison(compare_runs(base, next, options), flags.gate, flags.out);
}

} // namespace

Action add_compare_verb(CLI::App& app) {
    auto flags = std::make_shared<CompareFlags>();
    app.add_option("base", flags->base, "run folder that NEW is judged by")->required();
    app.add_option("new", flags->next, "run folder")->required();
    add_gate_flags(app, flags->gate);
    app.add_option("--out", flags->out, "folder for comparison.{csv,md,html}");
    return [flags] { return compare(*flags); };
}

} // namespace alcove
