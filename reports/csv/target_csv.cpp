#include "reports/csv/target_csv.hpp"

#include "core/base/file.hpp"
#include "reports/csv/csv_table.hpp"

#include <algorithm>

namespace alcove {
namespace {

void add_line(CsvTable& table, const TargetRanking& ranking, const RankedTarget& target,
              const RankedCell& cell) {
    table.begin_line();
    table.add_count("schema", kRunSchemaVersion);
    table.add("scene", ranking.scene);
    table.add("walkthrough", ranking.walkthrough);
    table.add("width", std::to_string(ranking.width));
    table.add("height", std::to_string(ranking.height));
    table.add("precision", ranking.precision);
    table.add("reference", ranking.reference);
    table.add("target", target.target);
    table.add("round", cell.round);
    table.add("cell", cell.cell);
    table.add("label", cell.label);
    table.add("settings", cell.settings);
    table.add("metric", ranking.metric);
    table.add("state", std::string(to_text(ranking.state)));
    table.add_estimate("error", cell.error);
    table.add("place", cell.place ? std::to_string(*cell.place) : std::string());
    table.add_flag("moves", std::find(ranking.moved.begin(), ranking.moved.end(), cell.label) !=
                                ranking.moved.end());
    table.add("note", cell.note);
}

} // namespace

std::string make_target_csv(const RunAnalysis& analysis) {
    CsvTable table;
    add_line(table, {}, {}, {});
    table.clear_lines();
    for (const TargetRanking& ranking : rank_targets(analysis)) {
        for (const RankedTarget& target : ranking.targets) {
            for (const RankedCell& cell : target.cells) {
                add_line(table, ranking, target, cell);
            }
        }
    }
    return table.make_text();
}

void write_target_csv(const RunFolder& run, const RunAnalysis& analysis) {
    write_file_atomically(run.path() / "targets.csv", make_target_csv(analysis));
}

} // namespace alcove
