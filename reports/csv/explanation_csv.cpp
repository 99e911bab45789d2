#include "reports/csv/explanation_csv.hpp"

#include "core/base/file.hpp"
#include "reports/csv/csv_table.hpp"

namespace alcove {
namespace {

void add_line(CsvTable& table, const RoundAnalysis& round, const StepRecord& steps,
              const CurveRecord* curve) {
    table.begin_line();
    table.add_count("schema", kRunSchemaVersion);
    table.add("round", round.round.id);
    table.add("scene", round.round.scene);
    table.add("target", round.round.target);
    table.add("cell", steps.cell);
    table.add("segment", std::to_string(steps.segment));
    table.add("frame", std::to_string(steps.frame));
    table.add("thickness_r", std::optional(steps.thickness));
    table.add_flag("has_converged_form", steps.has_converged_form);
    table.add("mse_total", std::optional(steps.total));
    table.add("mse_d1", std::optional(steps.d1));
    table.add("mse_d2", std::optional(steps.d2));
    table.add("mse_d3", std::optional(steps.d3));
    table.add("mean_d1_d2", std::optional(steps.d1_d2));
    table.add("mean_d1_d3", std::optional(steps.d1_d3));
    table.add("mean_d2_d3", std::optional(steps.d2_d3));
    table.add("truth_noise", std::optional(steps.truth_noise));
    table.add("march_noise", std::optional(steps.march_noise));
    const auto get = [curve](double CurveRecord::*field) {
        return curve != nullptr ? std::optional(curve->*field) : std::nullopt;
    };
    table.add("cell_mse", get(&CurveRecord::mse));
    table.add("cell_mse_curve", get(&CurveRecord::mse_fitted));
    table.add("cell_mse_curve_held_out", get(&CurveRecord::mse_held_out));
}

} // namespace

std::string make_explanation_csv(const RunAnalysis& analysis) {
    CsvTable table;
    add_line(table, {}, {}, nullptr);
    table.clear_lines();
    for (const RoundAnalysis& round : analysis.rounds) {
        for (const StepRecord& steps : round.done.steps) {
            const CurveRecord* curve = nullptr;
            for (const CurveRecord& candidate : round.done.curves) {
                curve = candidate.cell == steps.cell ? &candidate : curve;
            }
            add_line(table, round, steps, curve);
        }
    }
    return table.make_text();
}

void write_explanation_csv(const RunFolder& run, const RunAnalysis& analysis) {
    write_file_atomically(run.path() / "explanation.csv", make_explanation_csv(analysis));
}

} // namespace alcove
