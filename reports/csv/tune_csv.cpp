#include "reports/csv/tune_csv.hpp"

#include "reports/csv/csv_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alcove {
namespace {

std::string join_values(const TunedMethodRecord& method, const TuneEvaluationRecord& evaluation) {
    std::string text;
    for (std::size_t i = 0; i < method.parameters.size(); ++i) {
        text += (i == 0 ? "" : ",") + method.parameters[i].name + "=" + evaluation.values[i];
    }
    return text;
}

} // namespace

std::string make_tune_csv(const TuneRecord& record) {
    CsvTable table;
    const auto add = [&](const TunedMethodRecord& method, const TuneEvaluationRecord& evaluation,
                         std::size_t index, double best) {
        table.begin_line();
        table.add_count("schema", kTuneSchemaVersion);
        table.add("label", method.label);
        table.add("method", method.method);
        table.add("objective", record.objective);
        table.add("attempt", std::to_string(evaluation.attempt));
        table.add_count("evaluation", index);
        table.add("phase", evaluation.phase);
        table.add("values", join_values(method, evaluation));
        table.add("cost", std::optional(evaluation.cost));
        table.add("least_cost", std::optional(best));
    };
    add({}, {}, 0, 0.0);
    table.clear_lines();
    for (const TunedMethodRecord& method : record.methods) {
        std::size_t index = 0;
        double best = std::numeric_limits<double>::infinity();
        int attempt = 0;
        for (const TuneEvaluationRecord& evaluation : method.history) {
            if (evaluation.attempt != attempt) {
                attempt = evaluation.attempt;
                index = 0;
                best = std::numeric_limits<double>::infinity();
            }
            best = std::min(best, evaluation.cost);
            add(method, evaluation, ++index, best);
        }
    }
    return table.make_text();
}

std::string make_judgements_csv(const TuneRecord& record) {
    CsvTable table;
    const auto add = [&](const TunedMethodRecord& method, const TuneJudgementRecord& judgement,
                         std::optional<double> gap) {
        table.begin_line();
        table.add_count("schema", kTuneSchemaVersion);
        table.add("label", method.label);
        table.add("method", method.method);
        table.add_flag("is_converged", method.is_converged);
        table.add("set", judgement.set);
        table.add("metric", judgement.metric);
        table.add_flag("is_objective", judgement.is_objective);
        table.add("frames", std::to_string(judgement.frames));
        table.add("before", std::optional(judgement.before));
        table.add("after", std::optional(judgement.after));
        table.add("change", std::optional(judgement.change));
        table.add("change_lower95", std::optional(judgement.lower));
        table.add("change_upper95", std::optional(judgement.upper));
        table.add("generalisation_gap", gap);
    };
    add({}, {}, std::nullopt);
    table.clear_lines();
    for (const TunedMethodRecord& method : record.methods) {
        for (const TuneJudgementRecord& judgement : method.judgements) {
            add(method, judgement, find_generalisation_gap(method, judgement));
        }
    }
    return table.make_text();
}

} // namespace alcove
