#include "harness/run/plan.hpp"

#include "core/base/hash.hpp"
#include "harness/run/calibration.hpp"
#include "harness/run/effects_planner.hpp"
#include "harness/run/history_record.hpp"
#include "harness/run/metric_spec.hpp"
#include "harness/run/repeat_rule.hpp"
#include "harness/run/scene_source.hpp"
#include "harness/run/segments.hpp"
#include "harness/run/strata.hpp"
#include <algorithm>
#include <filesystem>
#include <set>

namespace alcove {
namespace {

/// Lower-case letters, digits, '_', '.', '-': what may be part of a folder's name.
std::string make_id(std::string_view text) {
    std::string id;
    for (const char c : text) {
        const bool keep = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
        const bool upper = c >= 'A' && c <= 'Z';
        id += keep ? c : upper ? static_cast<char>(c - 'A' + 'a') : '-';
    }
    constexpr std::size_t kLongest = 40;
    return id.substr(0, kLongest);
}

CellRecord make_anchor(const MethodUnit& unit, const Target& target, CellRole role) {
    MethodSpec spec;
    spec.method = unit.name;
    spec.label = role == CellRole::anchor ? "anchor" : "anchor (again)";
    CellRecord cell = make_cell_record(unit, spec, target, target.radius_m);
    cell.role = role;
    cell.id = role == CellRole::anchor ? "anchor-a" : "anchor-b";
    return cell;
}

std::vector<SegmentRecord> choose_segments(const FrameChoice& frames, int frame_count) {
    std::vector<SegmentRecord> segments;
    switch (frames.kind) {
    case FrameChoice::Kind::standard:
        return make_default_segments(frame_count);
    case FrameChoice::Kind::quick:
        return make_quick_segments(frame_count);
    case FrameChoice::Kind::ranges:
        for (const std::string& range : frames.ranges) {
            segments.push_back(parse_frames(range, frame_count));
        }
        break;
    }
    return segments;
}

/// The walkthrough's own events and its cuts, in order.
std::vector<EventRecord> list_events(const Walkthrough& walkthrough) {
    std::vector<EventRecord> events;
    for (const WalkthroughEvent& event : walkthrough.events) {
        events.push_back({event.frame, event.label});
    }
    for (const int cut : walkthrough.cuts) {
        if (cut > 0) {
            events.push_back({cut, "cut"});
        }
    }
    std::stable_sort(events.begin(), events.end(),
                     [](const EventRecord& a, const EventRecord& b) { return a.frame < b.frame; });
    return events;
}

/// Under its specification, with what differs from the unit in the definition.
MetricDescription describe_metric(const Units& units, const std::string& text) {
    const ResolvedMetric metric = resolve_metric(units.metrics, parse_metric_spec(text, "metrics"));
    const MetricUnit& unit = *metric.unit;
    const bool is_plain = text == unit.name;
    const std::string parameters = metric.parameters.to_text();
    return {text,
            is_plain ? unit.title : unit.title + " (" + text + ")",
            unit.unit,
            parameters.empty() ? unit.definition : unit.definition + " Here: " + parameters + ".",
            unit.blind_to,
            std::string(to_text(metric.domain)),
            unit.is_temporal() ? "temporal" : "image",
            unit.direction == Direction::lower_is_better};
}

/// Strata and regions that the experiment asks for.
std::vector<StratumInfo> choose_strata(const Experiment& experiment) {
    std::vector<StratumInfo> strata;
    if (experiment.measures_strata) {
        strata = list_strata();
    }
    for (const std::string& object : experiment.regions) {
        strata.push_back(describe_region(object));
    }
    return strata;
}

/// Every image metric of the plan over every stratum, and how many pixels that has.
void describe_strata(const std::vector<StratumInfo>& strata, PlanRecord& record) {
    const std::vector<MetricDescription> metrics = record.metrics;
    for (const StratumInfo& stratum : strata) {
        record.metrics.push_back({make_pixels_column(stratum.name), "Pixels: " + stratum.title,
                                  "px", "Pixels of the stratum: " + stratum.definition + ".",
                                  "what is measured there", "values", std::string(kStratumKind),
                                  true});
        for (const MetricDescription& metric : metrics) {
            if (metric.kind == "image") {
                MetricDescription part = metric;
                part.name = make_stratum_column(metric.name, stratum.name);
                part.title += ", " + stratum.title;
                part.definition += " Pooled over " + stratum.definition + ".";
                part.kind = kStratumKind;
                record.metrics.push_back(std::move(part));
            }
        }
    }
}

void describe_units(const Experiment& experiment, const Units& units, PlanRecord& record) {
    std::set<std::string> methods;
    for (const RoundRecord& round : record.rounds) {
        methods.insert(round.reference.method);
        for (const CellRecord& cell : round.cells) {
            methods.insert(cell.method);
        }
    }
    for (const std::string& name : methods) {
        const MethodUnit& unit = units.methods.find(name);
        record.methods.push_back({unit.name, unit.title, unit.citation, unit.content_hash});
    }
    const bool has_pictures =
        std::any_of(record.rounds.begin(), record.rounds.end(), measures_pictures);
    const std::vector<std::string> metrics = experiment.metrics.empty()
                                                 ? list_default_metrics(units.metrics, has_pictures)
                                                 : experiment.metrics;
    check_metric_specs(units.metrics, metrics, "metrics");
    for (const std::string& text : metrics) {
        record.metrics.push_back(describe_metric(units, text));
    }
    for (const HistoryNumberInfo& number : list_history_numbers()) {
        record.metrics.push_back({number.name, number.title, number.unit, number.definition,
                                  "whether the history was right", "values", "history", true});
    }
    describe_strata(choose_strata(experiment), record);
}

/// Every method with every kind of settings that it can have.
std::vector<MethodSpec> list_specs(const Experiment& experiment, const Units& units) {
    std::vector<MethodSpec> specs;
    for (const SettingsKind kind : experiment.settings) {
        for (MethodSpec spec : experiment.methods) {
            const bool is_first = kind == experiment.settings.front();
            const bool has_parameters =
                !units.methods.find(spec.method).parameters.entries().empty();
            if (spec.settings == SettingsKind::calibrated || !has_parameters) {
                if (is_first) {
                    specs.push_back(std::move(spec));
                }
                continue;
            }
            spec.settings = kind;
            spec.label += kind == SettingsKind::native ? " (native)" : "";
            specs.push_back(std::move(spec));
        }
    }
    return specs;
}

/// The rounds of one scene, in groups of kMethodsPerRound.
class ScenePlanner {
  public:
    ScenePlanner(const Experiment& experiment, const Units& units, PlanRecord& record)
        : m_experiment(experiment), m_units(units), m_record(record) {}

    /// Every combination of the axes that make rounds of their own.
    void add(const std::string& name, const Scene& scene, const FrameChoice& frames) {
        Target base;
        base.radius_m = scene.get_ao_radius_m();
        check_regions(m_experiment.regions, scene.get_objects(), "regions of " + name);
        for (const std::string& target : m_experiment.targets) {
            for (const ImageSize size : m_experiment.sizes) {
                for (const Precision& precision : m_experiment.precisions) {
                    add_combination(name, scene, frames,
                                    target.empty() ? base : parse_target(target, base), size,
                                    precision);
                }
            }
        }
    }

  private:
    void add_combination(const std::string& name, const Scene& scene, const FrameChoice& frames,
                         const Target& target, ImageSize size, const Precision& precision) {
        const bool is_radiance = target.output == TargetOutput::radiance;
        if (is_radiance && m_experiment.explains_errors) {
            throw InputError("explain errors", "takes visibility apart", describe(target),
                             "a target without output=radiance");
        }
        RoundRecord round;
        round.scene = name;
        round.walkthrough = scene.get_walkthrough().name;
        round.target = describe(target);
        round.width = size.width;
        round.height = size.height;
        round.precision = describe(precision);
        round.segments =
            choose_segments(frames, static_cast<int>(scene.get_walkthrough().cameras.size()));
        round.warm = frames.warm;
        round.image_frames = choose_image_frames(round.segments);
        round.film = choose_film(round.segments);
        round.events = list_events(scene.get_walkthrough());
        const MethodSpec reference = m_experiment.reference.value_or(get_default_reference(target));
        round.reference = make_cell_record(m_units.methods.find(reference.method), reference,
                                           target, scene.get_ao_radius_m());
        round.reference.id = "reference";
        if (m_experiment.effects == EffectsChoice::automatic) {
            round.effects = plan_effects(scene, round.segments, is_radiance);
        }
        const SceneSize scene_size = count_size(scene);
        round.scene_vertices = scene_size.vertices;
        round.scene_triangles = scene_size.triangles;
        round.ao_radius_m = scene.get_ao_radius_m();
        const std::vector<MethodSpec> specs = list_specs(m_experiment, m_units);
        for (std::size_t first = 0; first < specs.size(); first += kMethodsPerRound) {
            const std::size_t end = std::min(first + kMethodsPerRound, specs.size());
            add_round(round, target,
                      {specs.begin() + static_cast<std::ptrdiff_t>(first),
                       specs.begin() + static_cast<std::ptrdiff_t>(end)});
        }
    }

    void add_round(RoundRecord round, const Target& target, const std::vector<MethodSpec>& specs) {
        const std::string number = std::to_string(m_record.rounds.size() + 1);
        const std::string scene =
            is_scene_file(round.scene)
                ? std::filesystem::path(get_scene_file(round.scene)).stem().string()
                : round.scene;
        round.id = "r" + std::string(number.size() < 3 ? 3 - number.size() : 0, '0') + number +
                   "-" + make_id(scene);
        const MethodUnit& anchor = m_units.methods.find("anchor");
        round.cells.push_back(make_anchor(anchor, target, CellRole::anchor));
        round.cells.push_back(make_anchor(anchor, target, CellRole::anchor_repeat));
        for (const MethodSpec& spec : specs) {
            CellRecord cell = make_cell_record(m_units.methods.find(spec.method), spec, target,
                                               round.ao_radius_m);
            cell.effects = describe(choose_effects(round.effects));
            cell.id = "c" + std::to_string(round.cells.size() - 1) + "-" + make_id(spec.label);
            round.cells.push_back(std::move(cell));
        }
        m_record.rounds.push_back(std::move(round));
    }

    const Experiment& m_experiment;
    const Units& m_units;
    PlanRecord& m_record;
};

/// Once, however many specifications of the scene a run has.
void describe_scene(const SceneUnit& unit, PlanRecord& record) {
    const bool is_described =
        std::any_of(record.scenes.begin(), record.scenes.end(),
                    [&unit](const SceneDescription& scene) { return scene.name == unit.name; });
    if (!is_described) {
        record.scenes.push_back(
            {unit.name, unit.title, unit.stresses, unit.license, unit.content_hash});
    }
}

/// Once a file, with the content of all its specifications.
void describe_file(const std::string& spec, PlanRecord& record) {
    const std::string file = get_scene_file(spec);
    const std::string content = hash_scene_file(spec);
    const auto known =
        std::find_if(record.scenes.begin(), record.scenes.end(),
                     [&file](const SceneDescription& scene) { return scene.name == file; });
    if (known == record.scenes.end()) {
        record.scenes.push_back({file, "glTF file of the user", "", "not stated", content});
    } else {
        known->content_hash = Hasher().add(known->content_hash).add(content).finish_hex();
    }
}

/// Of the experiment, or all reported scenes.
std::vector<SceneChoice> choose_scenes(const Experiment& experiment, const Units& units) {
    if (!experiment.scenes.empty()) {
        return experiment.scenes;
    }
    std::vector<SceneChoice> scenes;
    for (const SceneUnit& unit : units.scenes.units()) {
        if (unit.reported) {
            scenes.push_back({unit.name, std::nullopt});
        }
    }
    return scenes;
}

/// What follows from a cell's parameters.
void derive_from_parameters(const MethodUnit& unit, const ResolvedParameters& resolved,
                            CellRecord& cell) {
    cell.warm_frames = unit.warm_frames(resolved);
    const SampleCount samples = unit.count_samples(resolved).value_or(SampleCount{});
    cell.sampling_pass = samples.pass;
    cell.samples_per_pixel = samples.per_pixel;
}

} // namespace

MadePlan make_plan(const Experiment& experiment, const Units& units) {
    MadePlan plan;
    PlanRecord& record = plan.record;
    record.experiment = experiment.name;
    record.title = experiment.title;
    record.command_line = experiment.command_line;
    record.repeats = experiment.repeats;
    if (experiment.until_width) {
        record.until_width = *experiment.until_width;
        record.time_limit_s = experiment.time_limit_s.value_or(0.0);
        record.most_repeats =
            experiment.most_repeats.value_or(std::max(kDefaultMostRepeats, experiment.repeats));
    }
    record.shuffle_seed = experiment.shuffle_seed;
    record.reference_rays_per_half = experiment.reference_rays_per_half;
    record.explains_errors = experiment.explains_errors;
    record.counts_fetches = experiment.counts_fetches;
    record.audit_share = experiment.audit_share;
    record.audit_seed = experiment.audit_seed;
    for (const SkippedCombination& skipped : experiment.skipped) {
        record.skipped.push_back({skipped.label, skipped.reason});
    }
    ScenePlanner planner(experiment, units, record);
    for (const SceneChoice& choice : choose_scenes(experiment, units)) {
        // A run may be continued from another folder.
        const std::string name = resolve_scene_paths(choice.spec, [](const std::string& path) {
            return std::filesystem::absolute(path).lexically_normal();
        });
        if (!is_scene_file(name)) {
            const SceneUnit unit = choose_scene(units.scenes, name).unit;
            if (const std::optional<std::string> obstacle = unit.find_obstacle()) {
                record.skipped.push_back({name, *obstacle});
                continue;
            }
            describe_scene(unit, record);
        } else {
            describe_file(name, record);
        }
        planner.add(name, *open_scene(units.scenes, name, plan.warnings),
                    choice.frames.value_or(experiment.frames));
        if (experiment.first_scene_only) {
            break;
        }
    }
    if (record.rounds.empty()) {
        std::string reasons;
        for (const SkippedRecord& skipped : record.skipped) {
            reasons += "\n  " + skipped.what + ": " + skipped.reason;
        }
        throw FailureError("run", "no scene is left to replay:" + reasons);
    }
    describe_units(experiment, units, record);
    return plan;
}

CellRecord make_cell_record(const MethodUnit& unit, const MethodSpec& spec, const Target& target,
                            double scene_radius_m) {
    std::vector<ParameterOverride> overrides = unit.find_preset(spec.preset).overrides;
    for (ParameterOverride& override_value : overrides) {
        override_value.provenance = Provenance::preset;
    }
    const bool is_native = spec.settings == SettingsKind::native;
    const TargetMapping mapping =
        is_native ? TargetMapping{{}, "native settings: not mapped to the target"}
                  : unit.map_target(target);
    overrides.insert(overrides.end(), mapping.overrides.begin(), mapping.overrides.end());
    const ExpressionVariables variables{
        {"scene_radius", is_native ? scene_radius_m : target.radius_m}};
    for (const ParameterOverride& value : spec.calibrated) {
        overrides.push_back(evaluate_calibrated(unit.parameters, value, variables));
    }
    overrides.insert(overrides.end(), spec.overrides.begin(), spec.overrides.end());
    CellRecord cell;
    cell.label = spec.label;
    cell.method = unit.name;
    cell.preset = spec.preset;
    cell.settings = to_text(spec.settings);
    cell.has_passes = unit.has_passes;
    cell.target = describe(target);
    cell.target_note = mapping.reason;
    const ResolvedParameters resolved = unit.parameters.resolve(overrides, variables);
    derive_from_parameters(unit, resolved, cell);
    for (const ResolvedParameter& parameter : resolved.values()) {
        const ParameterInfo& info = unit.parameters.find(parameter.name);
        cell.parameters.push_back({parameter.name, to_text(parameter.value), info.unit, info.symbol,
                                   std::string(to_text(parameter.provenance))});
    }
    return cell;
}

CellRecord override_cell(const MethodUnit& unit, CellRecord cell,
                         const std::vector<ParameterOverride>& overrides) {
    for (const ParameterOverride& value : overrides) {
        const auto parameter =
            std::find_if(cell.parameters.begin(), cell.parameters.end(),
                         [&](const ParameterRecord& p) { return p.name == value.name; });
        ALCOVE_ASSERT(parameter != cell.parameters.end(), "a parameter of the cell's method");
        parameter->value = value.value;
        parameter->provenance = to_text(value.provenance);
    }
    derive_from_parameters(unit, read_parameters(unit, cell), cell);
    return cell;
}

ResolvedParameters read_parameters(const MethodUnit& unit, const CellRecord& cell) {
    std::vector<ParameterOverride> overrides;
    for (const ParameterRecord& parameter : cell.parameters) {
        overrides.push_back({parameter.name, parameter.value, Provenance::file});
    }
    return unit.parameters.resolve(overrides, {});
}

} // namespace alcove
