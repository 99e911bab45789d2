#pragma once
// The keys of the run folder's JSON files: one list a struct, read and written through the same
// function. For record_json.cpp alone.

#include "reports/record/record.hpp"

namespace alcove::record_fields {

/// RoundDone is the one file without a version of its own in its struct.
struct DoneFile {
    int schema_version = kRunSchemaVersion;
    RoundDone done;
};

template <class V>
void visit(V& v, SegmentRecord& r) {
    v("begin", r.begin);
    v("end", r.end);
}

template <class V>
void visit(V& v, ParameterRecord& r) {
    v("name", r.name);
    v("value", r.value);
    v("unit", r.unit);
    v("symbol", r.symbol);
    v("provenance", r.provenance);
}

template <class V>
void visit(V& v, CellRecord& r) {
    v("id", r.id);
    v("label", r.label);
    v("method", r.method);
    v("preset", r.preset);
    v("settings", r.settings);
    v("role", r.role);
    v("has_passes", r.has_passes);
    v("parameters", r.parameters);
    v("target", r.target);
    v("target_note", r.target_note);
    v("warm_frames", r.warm_frames);
    v("effects", r.effects);
    v("sampling_pass", r.sampling_pass);
    v("samples_per_pixel", r.samples_per_pixel);
}

template <class V>
void visit(V& v, EventRecord& r) {
    v("frame", r.frame);
    v("label", r.label);
}

template <class V>
void visit(V& v, EffectRecord& r) {
    v("effect", r.effect);
    v("is_needed", r.is_needed);
    v("evidence", r.evidence);
}

template <class V>
void visit(V& v, SavingRecord& r) {
    v("cell", r.cell);
    v("ratio", r.ratio);
    v("lower", r.lower);
    v("upper", r.upper);
    v("n", r.n);
    v("largest_difference", r.largest_difference);
}

template <class V>
void visit(V& v, RoundRecord& r) {
    v("id", r.id);
    v("scene", r.scene);
    v("walkthrough", r.walkthrough);
    v("target", r.target);
    v("width", r.width);
    v("height", r.height);
    v("precision", r.precision);
    v("segments", r.segments);
    v("warm", r.warm);
    v("image_frames", r.image_frames);
    v("film", r.film);
    v("events", r.events);
    v("effects", r.effects);
    v("reference", r.reference);
    v("cells", r.cells);
    v("scene_vertices", r.scene_vertices);
    v("scene_triangles", r.scene_triangles);
    v("ao_radius_m", r.ao_radius_m);
}

template <class V>
void visit(V& v, MetricDescription& r) {
    v("name", r.name);
    v("title", r.title);
    v("unit", r.unit);
    v("definition", r.definition);
    v("blind_to", r.blind_to);
    v("domain", r.domain);
    v("kind", r.kind);
    v("lower_is_better", r.lower_is_better);
}

template <class V>
void visit(V& v, MethodDescription& r) {
    v("name", r.name);
    v("title", r.title);
    v("citation", r.citation);
    v("content_hash", r.content_hash);
}

template <class V>
void visit(V& v, SceneDescription& r) {
    v("name", r.name);
    v("title", r.title);
    v("stresses", r.stresses);
    v("license", r.license);
    v("content_hash", r.content_hash);
}

template <class V>
void visit(V& v, SkippedRecord& r) {
    v("what", r.what);
    v("reason", r.reason);
}

template <class V>
void visit(V& v, PlanRecord& r) {
    v("schema_version", r.schema_version);
    v("experiment", r.experiment);
    v("title", r.title);
    v("command_line", r.command_line);
    v("repeats", r.repeats);
    v("until_width", r.until_width);
    v("time_limit_s", r.time_limit_s);
    v("most_repeats", r.most_repeats);
    v("shuffle_seed", r.shuffle_seed);
    v("reference_rays_per_half", r.reference_rays_per_half);
    v("explains_errors", r.explains_errors);
    v("counts_fetches", r.counts_fetches);
    v("audit_share", r.audit_share);
    v("audit_seed", r.audit_seed);
    v("rounds", r.rounds);
    v("skipped", r.skipped);
    v("methods", r.methods);
    v("metrics", r.metrics);
    v("scenes", r.scenes);
}

template <class V>
void visit(V& v, TimerTrialRecord& r) {
    v("mode", r.mode);
    v("sequence", r.sequence);
    v("pass", r.pass);
    v("attempt", r.attempt);
    v("ratio", r.ratio);
    v("accepted", r.accepted);
}

template <class V>
void visit(V& v, ContextRecord& r) {
    v("schema_version", r.schema_version);
    v("started_utc", r.started_utc);
    v("build_id", r.build_id);
    v("build_type", r.build_type);
    v("compiler", r.compiler);
    v("device_class", r.device_class);
    v("gl_vendor", r.gl_vendor);
    v("gl_renderer", r.gl_renderer);
    v("gl_version", r.gl_version);
    v("context_kind", r.context_kind);
    v("cpu", r.cpu);
    v("cpu_features", r.cpu_features);
    v("cpu_threads", r.cpu_threads);
    v("driver_threads", r.driver_threads);
    v("timer_mode", r.timer_mode);
    v("timer_tick_ns", r.timer_tick_ns);
    v("timer_trials", r.timer_trials);
    v("anchor_version", r.anchor_version);
}

template <class V>
void visit(V& v, IngredientRecord& r) {
    v("name", r.name);
    v("value", r.value);
}

template <class V>
void visit(V& v, ReuseRecord& r) {
    v("what", r.what);
    v("outcome", r.outcome);
    v("reason", r.reason);
    v("names", r.names);
    v("contents", r.contents);
}

template <class V>
void visit(V& v, StepRecord& r) {
    v("cell", r.cell);
    v("segment", r.segment);
    v("frame", r.frame);
    v("thickness", r.thickness);
    v("has_converged_form", r.has_converged_form);
    v("total", r.total);
    v("d1", r.d1);
    v("d2", r.d2);
    v("d3", r.d3);
    v("d1_d2", r.d1_d2);
    v("d1_d3", r.d1_d3);
    v("d2_d3", r.d2_d3);
    v("truth_noise", r.truth_noise);
    v("march_noise", r.march_noise);
}

template <class V>
void visit(V& v, ThicknessRecord& r) {
    v("thickness", r.thickness);
    v("mse", r.mse);
    v("is_best", r.is_best);
}

template <class V>
void visit(V& v, CurveRecord& r) {
    v("cell", r.cell);
    v("frames", r.frames);
    v("mse", r.mse);
    v("mse_fitted", r.mse_fitted);
    v("mse_held_out", r.mse_held_out);
    v("visibility", r.visibility);
    v("curved", r.curved);
}

template <class V>
void visit(V& v, FetchRecord& r) {
    v("cell", r.cell);
    v("pass", r.pass);
    v("fetches_per_pixel", r.fetches_per_pixel);
    v("frames", r.frames);
}

template <class V>
void visit(V& v, MachineRecord& r) {
    v("wall_s", r.wall_s);
    v("load", r.load);
    v("others_share", r.others_share);
    v("steal_share", r.steal_share);
    v("switches_per_s", r.switches_per_s);
    v("clock_mhz", r.clock_mhz);
}

template <class V>
void visit(V& v, RepeatsRecord& r) {
    v("taken", r.taken);
    v("reason", r.reason);
    v("widest", r.widest);
    v("widest_cell", r.widest_cell);
}

template <class V>
void visit(V& v, DoneFile& r) {
    v("schema_version", r.schema_version);
    v("wall_s", r.done.wall_s);
    v("gbuffer_s", r.done.gbuffer_s);
    v("passes_s", r.done.passes_s);
    v("metrics_s", r.done.metrics_s);
    v("temporal_s", r.done.temporal_s);
    v("reference_s", r.done.reference_s);
    v("images_s", r.done.images_s);
    v("reference_cached", r.done.reference_cached);
    v("gbuffers_drawn", r.done.gbuffers_drawn);
    v("gbuffers_loaded", r.done.gbuffers_loaded);
    v("references_made", r.done.references_made);
    v("references_reused", r.done.references_reused);
    v("audited", r.done.audited);
    v("reuse", r.done.reuse);
    v("savings", r.done.savings);
    v("explaining_s", r.done.explaining_s);
    v("thicknesses", r.done.thicknesses);
    v("steps", r.done.steps);
    v("curves", r.done.curves);
    v("counting_s", r.done.counting_s);
    v("fetches", r.done.fetches);
    v("repeats", r.done.repeats);
    v("machine", r.done.machine);
}

} // namespace alcove::record_fields
