#include "reports/csv/tradeoff_csv.hpp"

#include "core/base/file.hpp"
#include "reports/csv/csv_table.hpp"

namespace alcove {
namespace {

void add_partner(CsvTable& table, const std::string& name, const Tradeoff& tradeoff,
                 const std::optional<std::size_t>& partner) {
    const TradeoffPoint* point = partner ? &tradeoff.points[*partner] : nullptr;
    const auto get = [&](Estimate TradeoffPoint::*estimate) {
        return point != nullptr ? std::optional((point->*estimate).value) : std::nullopt;
    };
    table.add(name + "_round", point != nullptr ? point->round : "");
    table.add(name + "_cell", point != nullptr ? point->cell : "");
    table.add(name + "_ratio", get(&TradeoffPoint::time));
    table.add(name + "_error", get(&TradeoffPoint::error));
}

void add_quality(CsvTable& table, const std::string& name, const TimeToQuality* entry) {
    table.add(name, entry != nullptr ? std::optional(entry->bound) : std::nullopt);
    table.add(name + "_frames",
              entry != nullptr && entry->frames ? std::to_string(*entry->frames) : "");
    table.add(name + "_time", entry != nullptr ? entry->time : std::nullopt);
}

void add_line(CsvTable& table, const RunAnalysis& analysis, const Tradeoff& tradeoff,
              const TradeoffPoint& point, const std::vector<TimeToQuality>* to_quality) {
    table.begin_line();
    table.add_count("schema", kRunSchemaVersion);
    table.add("scene", tradeoff.scene);
    table.add("walkthrough", tradeoff.walkthrough);
    table.add("target", tradeoff.target);
    table.add("width", std::to_string(tradeoff.width));
    table.add("height", std::to_string(tradeoff.height));
    table.add("precision", tradeoff.precision);
    table.add_flag("warm", tradeoff.warm);
    table.add("reference", tradeoff.reference);
    table.add("device_class", analysis.context.device_class);
    table.add("anchor_version", analysis.context.anchor_version);
    table.add("round", point.round);
    table.add("cell", point.cell);
    table.add("label", point.label);
    table.add("method", point.method);
    table.add_estimate("ratio", point.time);
    table.add("metric", tradeoff.metric);
    table.add("state", std::string(to_text(tradeoff.state)));
    table.add_estimate("error", point.error);
    table.add_flag("on_front", point.is_on_front);
    table.add_flag("surely_beaten", point.is_surely_beaten);
    add_partner(table, "equal_time", tradeoff, point.equal_time);
    add_partner(table, "equal_error", tradeoff, point.equal_error);
    for (std::size_t i = 0; i < kQualitySteps.size(); ++i) {
        add_quality(table, "bound_" + std::to_string(i + 1),
                    to_quality != nullptr ? &to_quality->at(i) : nullptr);
    }
}

} // namespace

std::string make_tradeoff_csv(const RunAnalysis& analysis) {
    CsvTable table;
    add_line(table, analysis, {}, {}, nullptr);
    table.clear_lines();
    for (const Tradeoff& tradeoff : compute_tradeoffs(analysis)) {
        for (std::size_t i = 0; i < tradeoff.points.size(); ++i) {
            add_line(table, analysis, tradeoff, tradeoff.points[i],
                     tradeoff.to_quality.empty() ? nullptr : &tradeoff.to_quality[i]);
        }
    }
    return table.make_text();
}

void write_tradeoff_csv(const RunFolder& run, const RunAnalysis& analysis) {
    write_file_atomically(run.path() / "tradeoff.csv", make_tradeoff_csv(analysis));
}

} // namespace alcove
