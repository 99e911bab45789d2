#include "reports/csv/passes_csv.hpp"

#include "core/base/file.hpp"
#include "reports/csv/csv_table.hpp"

namespace alcove {
namespace {

void add_line(CsvTable& table, const RunAnalysis& analysis, const RoundRecord& round,
              const CellRecord& cell, const PassAnalysis& pass) {
    table.begin_line();
    table.add_count("schema", kRunSchemaVersion);
    table.add("round", round.id);
    table.add("scene", round.scene);
    table.add_count("width", static_cast<std::size_t>(round.width));
    table.add_count("height", static_cast<std::size_t>(round.height));
    table.add("device_class", analysis.context.device_class);
    table.add("cell", cell.id);
    table.add("label", cell.label);
    table.add("method", cell.method);
    table.add("pass", pass.pass);
    table.add_estimate("time_ms", pass.time_ms);
    table.add("ns_per_pixel", pass.ns_per_pixel);
    table.add("ns_per_sample", pass.ns_per_sample);
    table.add("fetches_per_pixel", pass.fetches_per_pixel);
    table.add_flag("cached", pass.is_cached);
    table.add_flag("under_resolution", pass.is_under_resolution);
}

} // namespace

std::string make_passes_csv(const RunAnalysis& analysis) {
    CsvTable table;
    add_line(table, analysis, {}, {}, {});
    table.clear_lines();
    for (const RoundAnalysis& round : analysis.rounds) {
        for (const CellAnalysis& cell : round.cells) {
            for (const PassAnalysis& pass : cell.passes) {
                add_line(table, analysis, round.round, cell.cell, pass);
            }
        }
    }
    return table.make_text();
}

void write_passes_csv(const RunFolder& run, const RunAnalysis& analysis) {
    write_file_atomically(run.path() / "passes.csv", make_passes_csv(analysis));
}

} // namespace alcove
