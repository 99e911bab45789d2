#pragma once
// The keys of stability.json: one list a struct, read and written through the same function. For
// record_json.cpp alone.

#include "reports/record/record_fields.hpp"
#include "reports/record/stability_record.hpp"

namespace alcove::record_fields {

template <class V>
void visit(V& v, StabilityScoreRecord& r) {
    v("score", r.score);
    v("bound", r.bound);
    v("fault", r.fault);
    v("picture", r.picture);
}

template <class V>
void visit(V& v, StabilitySeverityRecord& r) {
    v("value", r.value);
    v("label", r.label);
}

template <class V>
void visit(V& v, StabilityCaseRecord& r) {
    v("name", r.name);
    v("title", r.title);
    v("trigger", r.trigger);
    v("source", r.source);
    v("axis", r.axis);
    v("axis_unit", r.axis_unit);
    v("severities", r.severities);
    v("invariant", r.invariant);
    v("score", r.score);
    v("score_unit", r.score_unit);
    v("bound_reason", r.bound_reason);
}

template <class V>
void visit(V& v, StabilityMethodRecord& r) {
    v("label", r.label);
    v("method", r.method);
    v("preset", r.preset);
    v("content_hash", r.content_hash);
    v("overrides", r.overrides);
}

template <class V>
void visit(V& v, StabilityCellRecord& r) {
    v("case", r.case_name);
    v("method", r.label);
    v("outcome", r.outcome);
    v("reason", r.reason);
    v("worst_margin", r.worst_margin);
    v("scores", r.scores);
}

template <class V>
void visit(V& v, StabilityRecord& r) {
    v("schema_version", r.schema_version);
    v("command_line", r.command_line);
    v("width", r.width);
    v("height", r.height);
    v("context", r.context);
    v("cases", r.cases);
    v("methods", r.methods);
    v("cells", r.cells);
}

} // namespace alcove::record_fields
