#include "harness/app/comparing.hpp"

#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/nearest_name.hpp"
#include "core/base/text.hpp"
#include "reports/csv/comparison_csv.hpp"
#include "reports/html/comparison_page.hpp"
#include "reports/markdown/comparison_markdown.hpp"
#include "reports/terminal/comparison_table.hpp"

#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace alcove {
namespace {

constexpr const char* kGate = "worse";
constexpr const char* kStrictGate = "strict";
constexpr int kGateNotMet = 3;

} // namespace

void add_gate_flags(CLI::App& app, GateFlags& flags) {
    // A flag, not an option: its value comes after `=` alone, so that it never takes a run for one.
    app.add_flag(std::string("--gate{") + kGate + "}", flags.gate,
                 "exit 3 if anything is worse; --gate=strict: also if anything is unknown");
    app.add_option("--margin", flags.margin,
                   fmt::format("relative change of a time that counts; default {}, raised to the "
                               "noise of the A/A pairs",
                               kDefaultMargin));
}

ComparisonOptions read_gate_flags(const GateFlags& flags) {
    if (!flags.gate.empty() && flags.gate != kGate && flags.gate != kStrictGate) {
        const std::vector<std::string> choices{kStrictGate};
        throw InputError("--gate", "unknown choice", flags.gate,
                         describe_choices(flags.gate, choices));
    }
    ComparisonOptions options;
    if (!flags.margin.empty()) {
        options.margin = parse_number(flags.margin, "--margin");
        if (!(options.margin >= 0.0 && options.margin < 1.0)) {
            throw InputError("--margin", "out of range", flags.margin, "a share in [0, 1)");
        }
    }
    return options;
}

int report_comparison(const Comparison& comparison, const GateFlags& flags,
                      const std::filesystem::path& out) {
    if (!out.empty()) {
        create_output_folder(out);
        write_file_atomically(out / "comparison.csv", make_comparison_csv(comparison));
        write_file_atomically(out / "comparison.md", make_comparison_markdown(comparison));
        write_file_atomically(out / "comparison.html", make_comparison_page(comparison, out));
    }
    std::fputs(make_comparison_table(comparison).c_str(), stdout);
    if (!out.empty()) {
        fmt::print("comparison: {}\n", (out / "comparison.html").string());
    }
    std::fflush(stdout);
    const std::size_t unknown = comparison.count(Verdict::unknown);
    if (unknown > 0) {
        fmt::print(stderr,
                   "alcove: warning: {} verdicts are unknown: more repeats or frames tell\n",
                   unknown);
    }
    if (!comparison.unpaired.empty()) {
        fmt::print(stderr, "alcove: warning: {} parts have no partner in the other run\n",
                   comparison.unpaired.size());
    }
    const bool is_strict = flags.gate == kStrictGate;
    const bool is_met = comparison.count(Verdict::worse) == 0 && !(is_strict && unknown > 0);
    return flags.gate.empty() || is_met ? 0 : kGateNotMet;
}

} // namespace alcove
