#include "harness/app/context_flags.hpp"
#include "harness/app/experiment_flags.hpp"
#include "harness/app/running.hpp"
#include "harness/app/verbs.hpp"
#include "harness/run/effects_saving.hpp"
#include "harness/run/plan.hpp"
#include "harness/run/scene_source.hpp"

#include <algorithm>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace alcove {
namespace {

struct PlanFlags {
    std::vector<std::string> scenes;
    std::vector<std::string> methods;
    std::string frames;
    std::string size = "384x288";
    ContextFlags context;
};

Experiment make_planned_experiment(const PlanFlags& flags, const Units& units) {
    ExperimentFlags experiment;
    experiment.scenes = flags.scenes;
    experiment.methods = flags.methods;
    if (!flags.frames.empty()) {
        experiment.frames = flags.frames;
    }
    experiment.size = flags.size;
    experiment.effects = "auto";
    return make_experiment(experiment, "default", "", units);
}

void print_decisions(const RoundRecord& round) {
    fmt::print("{}, {} frames\n", round.scene, [&] {
        int frames = 0;
        for (const SegmentRecord& segment : round.segments) {
            frames += segment.end - segment.begin;
        }
        return frames;
    }());
    for (const EffectRecord& effect : round.effects) {
        const auto info = std::find_if(kEffects.begin(), kEffects.end(), [&](const EffectInfo& e) {
            return e.name == effect.effect;
        });
        fmt::print("  {:<15}{:<10}{}\n", effect.effect, effect.is_needed ? "kept" : "left out",
                   effect.evidence);
        fmt::print("  {:<25}{}; left out where {}\n", "", info->meaning, info->rule);
    }
}

void print_savings(const RoundRecord& round, const std::vector<SavingRecord>& savings) {
    for (const SavingRecord& saving : savings) {
        const auto cell =
            std::find_if(round.cells.begin(), round.cells.end(),
                         [&saving](const CellRecord& record) { return record.id == saving.cell; });
        fmt::print("  {:<42}{:.3f} [{:.3f}, {:.3f}] (n={}) of the time with all effects, images "
                   "within {:.2f}/255\n",
                   cell->label, saving.ratio, saving.lower, saving.upper, saving.n,
                   255.0 * saving.largest_difference);
    }
}

int print_plan(const PlanFlags& flags) {
    const Units units = get_units();
    const ContextChoice choice = flags.context.parse();
    const MadePlan plan = make_plan(make_planned_experiment(flags, units), units);
    const std::unique_ptr<gl::Context> context = open_chosen_context(choice);
    const gl::TimerMode mode = validate_clock(*context).chosen();
    for (const RoundRecord& round : plan.record.rounds) {
        print_decisions(round);
        std::vector<std::string> warnings; // said when the plan was made
        const std::unique_ptr<Scene> scene = open_scene(units.scenes, round.scene, warnings);
        print_savings(round, measure_savings(*context, mode, units, plan.record, round, *scene));
    }
    fmt::print("Times: G-buffer and passes of the first frames, {}; a device of class {}.\n",
               gl::to_text(mode), context->device().device_class);
    return 0;
}

} // namespace

Action add_plan_verb(CLI::App& app) {
    auto flags = std::make_shared<PlanFlags>();
    app.add_option("scene", flags->scenes, "NAME[:key=value,...] or a .gltf or .glb file")
        ->required();
    app.add_option("--method", flags->methods,
                   "M[@PRESET][:key=value,...] (repeatable); default the default suite")
        ->expected(1)
        ->take_all();
    app.add_option("--frames", flags->frames, "A:B, in place of the default segments");
    app.add_option("--size", flags->size, "WxH in pixels")->capture_default_str();
    flags->context.add_to(app);
    return [flags] { return print_plan(*flags); };
}

} // namespace alcove
