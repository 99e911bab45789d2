#pragma once
// The keys of tune.json: one list a struct, read and written through the same function. For
// record_json.cpp alone.

#include "reports/record/record_fields.hpp"
#include "reports/record/tune_record.hpp"

namespace alcove::record_fields {

template <class V>
void visit(V& v, TuneEvaluationRecord& r) {
    v("attempt", r.attempt);
    v("phase", r.phase);
    v("values", r.values);
    v("cost", r.cost);
}

template <class V>
void visit(V& v, TuneParameterRecord& r) {
    v("name", r.name);
    v("unit", r.unit);
    v("tuned", r.tuned);
    v("lower_ratio", r.lower_ratio);
    v("upper_ratio", r.upper_ratio);
}

template <class V>
void visit(V& v, TuneJudgementRecord& r) {
    v("set", r.set);
    v("metric", r.metric);
    v("is_objective", r.is_objective);
    v("frames", r.frames);
    v("before", r.before);
    v("after", r.after);
    v("change", r.change);
    v("lower", r.lower);
    v("upper", r.upper);
}

template <class V>
void visit(V& v, TunedMethodRecord& r) {
    v("id", r.id);
    v("label", r.label);
    v("method", r.method);
    v("preset", r.preset);
    v("evaluations", r.evaluations);
    v("parameters", r.parameters);
    v("history", r.history);
    v("least_costs", r.least_costs);
    v("is_converged", r.is_converged);
    v("judgements", r.judgements);
    v("calibration", r.calibration);
}

template <class V>
void visit(V& v, TuneSceneRecord& r) {
    v("scene", r.scene);
    v("target", r.target);
    v("is_held_out", r.is_held_out);
    v("training", r.training);
    v("held_out", r.held_out);
}

template <class V>
void visit(V& v, TuneRecord& r) {
    v("schema_version", r.schema_version);
    v("command_line", r.command_line);
    v("context", r.context);
    v("width", r.width);
    v("height", r.height);
    v("objective", r.objective);
    v("judge", r.judge);
    v("objective_lower_is_better", r.objective_lower_is_better);
    v("judge_lower_is_better", r.judge_lower_is_better);
    v("evaluations_per_parameter", r.evaluations_per_parameter);
    v("seed", r.seed);
    v("scenes", r.scenes);
    v("methods", r.methods);
}

} // namespace alcove::record_fields
