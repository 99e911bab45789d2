#include "reports/csv/strata_csv.hpp"

#include "core/base/file.hpp"
#include "reports/analysis/strata.hpp"
#include "reports/csv/csv_table.hpp"

namespace alcove {
namespace {

void add_line(CsvTable& table, const RoundAnalysis& round, const StratumAnalysis& part) {
    const StratumAnalysis* pixels =
        find_stratum(round, part.cell, part.state, std::string(kPixelCount), part.stratum);
    std::optional<double> counted;
    std::optional<double> ignored;
    if (pixels != nullptr && pixels->value.frames > 0) {
        counted = pixels->value.value;
        ignored = static_cast<double>(round.round.width) * round.round.height - *counted;
    }
    const bool has_value = part.value.frames > 0;
    table.begin_line();
    table.add_count("schema", kRunSchemaVersion);
    table.add("round", round.round.id);
    table.add("scene", round.round.scene);
    table.add("target", round.round.target);
    table.add("cell", part.cell);
    table.add("state", std::string(to_text(part.state)));
    table.add("metric", part.metric);
    table.add("stratum", part.stratum);
    table.add("value", has_value ? std::optional(part.value.value) : std::nullopt);
    table.add("debiased", part.value.debiased);
    table.add("floor", part.value.floor);
    table.add_count("frames", part.value.frames);
    table.add_count("undefined", part.value.undefined);
    table.add("counted_pixels", counted);
    table.add("ignored_pixels", ignored);
    table.add("note", part.value.note);
}

} // namespace

std::string make_strata_csv(const RunAnalysis& analysis) {
    CsvTable table;
    add_line(table, {}, {});
    table.clear_lines();
    for (const RoundAnalysis& round : analysis.rounds) {
        for (const StratumAnalysis& part : round.strata) {
            if (part.metric != kPixelCount) {
                add_line(table, round, part);
            }
        }
    }
    return table.make_text();
}

void write_strata_csv(const RunFolder& run, const RunAnalysis& analysis) {
    write_file_atomically(run.path() / "strata.csv", make_strata_csv(analysis));
}

} // namespace alcove
