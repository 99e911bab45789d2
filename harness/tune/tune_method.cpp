#include "harness/tune/tune_method.hpp"

#include "core/base/error.hpp"
#include "core/base/statistics.hpp"
#include "core/base/text.hpp"
#include "harness/run/calibration.hpp"
#include "harness/run/metric_spec.hpp"
#include "harness/tune/free_parameter.hpp"
#include "harness/tune/minimiser.hpp"
#include "harness/tune/tune_scene.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>

namespace alcove {
namespace {

/// A tenth of a parameter's range: what its sensitivity is measured over.
constexpr double kSensitivityStep = 0.1;
constexpr int kAttempts = 2;

/// A frame of a scene.
struct FrameOf {
    TuneScene* scene = nullptr;
    std::size_t frame = 0;
};

TuneMetric make_metric(const Units& units, const std::string& name, std::string_view option) {
    const ResolvedMetric resolved = resolve_metric(units.metrics, parse_metric_spec(name, option));
    if (resolved.unit->is_temporal()) {
        throw InputError(option, "is over time", name, "a metric of images");
    }
    return {name, resolved.unit, resolved.domain, resolved.create()};
}

std::string make_id(const std::string& label, std::set<std::string>& taken) {
    std::string id;
    for (const char c : label) {
        const bool keep = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
        id += keep ? c : '-';
    }
    constexpr std::size_t kLongest = 40;
    id = id.substr(0, kLongest);
    std::string unique = id;
    for (int i = 2; !taken.insert(unique).second; ++i) {
        unique = id + "-" + std::to_string(i);
    }
    return unique;
}

/// One method's way through its attempts.
class MethodTuner {
  public:
    MethodTuner(const TunePlan& plan, const MethodUnit& unit, const MethodSpec& spec,
                std::vector<FrameOf> training, const TuneMetric& objective,
                std::function<void(double)> progress)
        : m_plan(plan), m_unit(unit), m_spec(spec), m_training(std::move(training)),
          m_objective(objective), m_progress(std::move(progress)),
          m_free(choose_free_parameters(unit, plan.free)) {
        m_record.label = spec.label;
        m_record.method = spec.method;
        m_record.preset = spec.preset;
        m_record.evaluations = plan.evaluations_per_parameter * static_cast<int>(m_free.size());
    }

    /// Both attempts and the sensitivities.
    TunedMethodRecord tune() {
        std::optional<CostEvaluation> best;
        for (int attempt = 0; attempt < kAttempts; ++attempt) {
            const Minimum minimum = search(attempt);
            const CostEvaluation& least = minimum.history[minimum.best];
            m_record.least_costs.push_back(least.cost);
            if (!best || least.cost < best->cost) {
                best = least;
            }
        }
        m_record.is_converged = agree(m_record.least_costs);
        for (std::size_t i = 0; i < m_free.size(); ++i) {
            add_parameter(i, *best);
        }
        return std::move(m_record);
    }

    /// The specification with the tuned values over its preset.
    [[nodiscard]] static MethodSpec calibrate(MethodSpec spec, const TunedMethodRecord& record) {
        spec.settings = SettingsKind::calibrated;
        spec.calibrated = list_values(record);
        return spec;
    }

    [[nodiscard]] static std::vector<ParameterOverride>
    list_values(const TunedMethodRecord& record) {
        std::vector<ParameterOverride> values;
        for (const TuneParameterRecord& parameter : record.parameters) {
            values.push_back({parameter.name, parameter.tuned, Provenance::file});
        }
        return values;
    }

  private:
    Minimum search(int attempt) {
        MinimiserSettings settings;
        settings.evaluations = m_record.evaluations;
        settings.seed = m_plan.seed + static_cast<std::uint64_t>(attempt);
        int done = 0;
        const Minimum minimum = minimise(m_free.size(), settings, [&](const auto& point) {
            m_progress((attempt + static_cast<double>(done) / settings.evaluations) / kAttempts);
            ++done;
            return compute_cost(point);
        });
        for (const CostEvaluation& evaluation : minimum.history) {
            m_record.history.push_back({attempt, evaluation.is_grid ? "grid" : "search",
                                        describe(evaluation.point), evaluation.cost});
        }
        return minimum;
    }

    [[nodiscard]] std::vector<std::string> describe(const std::vector<double>& point) const {
        std::vector<std::string> values;
        for (std::size_t i = 0; i < m_free.size(); ++i) {
            values.push_back(m_free[i].describe(point[i]));
        }
        return values;
    }

    /// Mean over the training frames. Settings that round to the same values are measured once.
    double compute_cost(const std::vector<double>& point) {
        const std::vector<std::string> values = describe(point);
        const auto known = m_costs.find(values);
        if (known != m_costs.end()) {
            return known->second;
        }
        MethodSpec spec = m_spec;
        spec.settings = SettingsKind::calibrated;
        for (std::size_t i = 0; i < m_free.size(); ++i) {
            spec.calibrated.push_back({m_free[i].name(), values[i], Provenance::file});
        }
        double sum = 0.0;
        for (const FrameOf& frame : m_training) {
            const Image image = frame.scene->render(frame.scene->make_cell(spec), frame.frame);
            sum += m_objective.compute_cost(frame.scene->measure(m_objective, image, frame.frame));
        }
        const double cost = sum / static_cast<double>(m_training.size());
        m_costs[values] = cost;
        return cost;
    }

    void add_parameter(std::size_t index, const CostEvaluation& best) {
        TuneParameterRecord parameter;
        parameter.name = m_free[index].name();
        parameter.unit =
            m_free[index].is_relative() ? "r" : m_unit.parameters.find(parameter.name).unit;
        parameter.tuned = m_free[index].describe(best.point[index]);
        const auto measure = [&](double step) {
            std::vector<double> moved = best.point;
            moved[index] = std::clamp(moved[index] + step, 0.0, 1.0);
            return compute_cost(moved) / best.cost;
        };
        parameter.lower_ratio = measure(-kSensitivityStep);
        parameter.upper_ratio = measure(kSensitivityStep);
        m_record.parameters.push_back(std::move(parameter));
    }

    [[nodiscard]] static bool agree(const std::vector<double>& costs) {
        const auto [least, most] = std::minmax_element(costs.begin(), costs.end());
        return std::abs(*most - *least) <= kTuneAgreement * std::abs(*least);
    }

    const TunePlan& m_plan;
    const MethodUnit& m_unit;
    const MethodSpec& m_spec;
    std::vector<FrameOf> m_training;
    const TuneMetric& m_objective;
    std::function<void(double)> m_progress;
    std::vector<FreeParameter> m_free;
    std::map<std::vector<std::string>, double> m_costs;
    TunedMethodRecord m_record;
};

TuneJudgementRecord judge(const std::vector<FrameOf>& frames, const MethodSpec& before,
                          const MethodSpec& after, const TuneMetric& metric) {
    TuneJudgementRecord record;
    record.metric = metric.text;
    record.frames = static_cast<int>(frames.size());
    std::vector<double> old_values;
    std::vector<double> new_values;
    for (const FrameOf& frame : frames) {
        old_values.push_back(frame.scene->measure(
            metric, frame.scene->render(frame.scene->make_cell(before), frame.frame), frame.frame));
    }
    for (const FrameOf& frame : frames) {
        new_values.push_back(frame.scene->measure(
            metric, frame.scene->render(frame.scene->make_cell(after), frame.frame), frame.frame));
    }
    std::vector<double> changes;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        changes.push_back(new_values[i] - old_values[i]);
    }
    const Estimate change = estimate_across_repeats(changes);
    record.before = compute_mean(old_values);
    record.after = compute_mean(new_values);
    record.change = change.value;
    record.lower = change.interval ? change.interval->lower : change.value;
    record.upper = change.interval ? change.interval->upper : change.value;
    return record;
}

/// The frames of all scenes, by what they are for.
struct FrameSets {
    std::vector<FrameOf> training;
    std::vector<FrameOf> held_out;
    std::vector<FrameOf> held_out_scenes;
};

class Tuning {
  public:
    Tuning(const TunePlan& plan, gl::Context& context, const ContextRecord& described,
           const Units& units, const TuneEvents& events)
        : m_plan(plan), m_units(units), m_events(events),
          m_objective(make_metric(units, plan.objective, "--objective")),
          m_judge(make_metric(units, plan.judge, "--judge")) {
        if (plan.objective == plan.judge) {
            throw InputError("--judge", "is the objective itself", plan.judge,
                             "a metric that is not tuned on");
        }
        // Before seconds go into truth.
        for (const MethodSpec& spec : plan.methods) {
            static_cast<void>(choose_free_parameters(units.methods.find(spec.method), plan.free));
        }
        m_record.command_line = plan.command_line;
        m_record.context = described;
        m_record.width = plan.size.width;
        m_record.height = plan.size.height;
        m_record.objective = plan.objective;
        m_record.judge = plan.judge;
        m_record.objective_lower_is_better =
            m_objective.unit->direction == Direction::lower_is_better;
        m_record.judge_lower_is_better = m_judge.unit->direction == Direction::lower_is_better;
        m_record.evaluations_per_parameter = plan.evaluations_per_parameter;
        m_record.seed = plan.seed;
        for (const std::string& scene : plan.scenes) {
            add_scene(context, scene, false);
        }
        for (const std::string& scene : plan.held_out_scenes) {
            add_scene(context, scene, true);
        }
    }

    TuneRecord run() {
        std::set<std::string> ids;
        for (std::size_t i = 0; i < m_plan.methods.size(); ++i) {
            tune(m_plan.methods[i], i, ids);
        }
        return std::move(m_record);
    }

  private:
    void add_scene(gl::Context& context, const std::string& name, bool is_held_out) {
        m_events.progress(0.0, name + ": reference");
        Experiment experiment;
        experiment.name = "tune";
        experiment.scenes = {{name, std::nullopt}};
        experiment.methods = {m_plan.methods.front()};
        experiment.sizes = {m_plan.size};
        experiment.targets = {m_plan.target};
        experiment.reference = m_plan.reference;
        experiment.reference_rays_per_half = m_plan.reference_rays_per_half;
        experiment.audit_share = 0.0;
        experiment.command_line = m_plan.command_line;
        m_scenes.push_back(std::make_unique<TuneScene>(context, m_units, experiment));
        TuneScene& scene = *m_scenes.back();
        TuneSceneRecord record;
        record.scene = name;
        record.target = scene.make_cell(m_plan.methods.front()).target;
        record.is_held_out = is_held_out;
        for (std::size_t i = 0; i < scene.frame_count(); ++i) {
            const bool trains = !is_held_out && i % 2 == 0;
            (trains ? record.training : record.held_out).push_back(scene.frame_index(i));
            (trains        ? m_sets.training
             : is_held_out ? m_sets.held_out_scenes
                           : m_sets.held_out)
                .push_back({&scene, i});
        }
        m_record.scenes.push_back(std::move(record));
    }

    void tune(const MethodSpec& spec, std::size_t index, std::set<std::string>& ids) {
        const MethodUnit& unit = m_units.methods.find(spec.method);
        const auto progress = [&](double share) {
            m_events.progress((static_cast<double>(index) + share) /
                                  static_cast<double>(m_plan.methods.size()),
                              spec.label);
        };
        TunedMethodRecord tuned =
            MethodTuner(m_plan, unit, spec, m_sets.training, m_objective, progress).tune();
        tuned.id = make_id(spec.label, ids);
        tuned.calibration = tuned.id + "/preset.toml";
        const MethodSpec after = MethodTuner::calibrate(spec, tuned);
        const auto add = [&](std::string_view set, const std::vector<FrameOf>& frames) {
            for (const TuneMetric* metric : {&m_objective, &m_judge}) {
                if (!frames.empty()) {
                    TuneJudgementRecord record = judge(frames, spec, after, *metric);
                    record.set = set;
                    record.is_objective = metric == &m_objective;
                    tuned.judgements.push_back(std::move(record));
                }
            }
        };
        add(kTrainingSet, m_sets.training);
        add("held-out frames", m_sets.held_out);
        add("held-out scenes", m_sets.held_out_scenes);
        m_record.methods.push_back(tuned);
        m_events.method_done(
            m_record, tuned,
            make_calibration_text(spec.method, spec.preset, list_preset_values(spec, tuned)));
    }

    /// What the specification itself sets beyond its preset belongs to the calibration.
    [[nodiscard]] static std::vector<ParameterOverride>
    list_preset_values(const MethodSpec& spec, const TunedMethodRecord& tuned) {
        std::vector<ParameterOverride> values = MethodTuner::list_values(tuned);
        for (const ParameterOverride& own : spec.overrides) {
            values.push_back({own.name, own.value, Provenance::file});
        }
        return values;
    }

    const TunePlan& m_plan;
    const Units& m_units;
    const TuneEvents& m_events;
    TuneMetric m_objective;
    TuneMetric m_judge;
    std::vector<std::unique_ptr<TuneScene>> m_scenes;
    FrameSets m_sets;
    TuneRecord m_record;
};

void check(const TunePlan& plan) {
    if (plan.evaluations_per_parameter < kFewestEvaluations ||
        plan.evaluations_per_parameter > kMostEvaluations) {
        throw InputError("--evaluations", "out of range",
                         std::to_string(plan.evaluations_per_parameter),
                         std::to_string(kFewestEvaluations) + " to " +
                             std::to_string(kMostEvaluations) + " a free parameter");
    }
    for (const MethodSpec& spec : plan.methods) {
        for (const ParameterOverride& own : spec.overrides) {
            if (std::find(plan.free.begin(), plan.free.end(), own.name) != plan.free.end() ||
                (plan.free.empty() && (own.name == "radius" || own.name == "strength"))) {
                throw InputError("tune", "a free parameter cannot be set as well",
                                 spec.label + ": " + own.name, "--free without it");
            }
        }
    }
}

} // namespace

TuneRecord run_tune(const TunePlan& plan, gl::Context& context, const ContextRecord& described,
                    const Units& units, const TuneEvents& events) {
    check(plan);
    return Tuning(plan, context, described, units, events).run();
}

} // namespace alcove
