#include "harness/app/experiment_flags.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "harness/run/calibration.hpp"
#include "harness/run/experiment_file.hpp"
#include "harness/run/grid.hpp"
#include "harness/run/metric_spec.hpp"

#include <random>

#include <CLI/CLI.hpp>

namespace alcove {
namespace {

void replace_frames(const ExperimentFlags& flags, Experiment& experiment) {
    if (flags.warm && !flags.frames) {
        throw InputError("--warm", "holds the pose of A before [A,B)", "no --frames",
                         "--frames A:B");
    }
    if (!flags.quick && !flags.frames) {
        return;
    }
    FrameChoice frames;
    if (flags.frames) {
        frames = {FrameChoice::Kind::ranges, {*flags.frames}, flags.warm};
    } else {
        frames.kind = FrameChoice::Kind::quick;
    }
    experiment.frames = frames;
    for (SceneChoice& scene : experiment.scenes) {
        scene.frames.reset();
    }
}

void replace_repeat_rule(const ExperimentFlags& flags, Experiment& experiment) {
    if (flags.until_width) {
        experiment.until_width = flags.until_width;
    }
    if (flags.time_limit_s) {
        experiment.time_limit_s = flags.time_limit_s;
    }
    if (flags.most_repeats) {
        experiment.most_repeats = flags.most_repeats;
    }
    check_repeats(experiment, {"--until-width", "--time-limit", "--most-repeats"});
}

} // namespace

void ExperimentFlags::add_to(CLI::App& app) {
    app.add_option("experiment", experiment,
                   "name of a shipped experiment (list experiments) or a TOML file");
    app.add_flag("--quick", quick, "one scene, 24 frames");
    app.add_option("--scene", scenes, "NAME[:key=value,...], or a .gltf or .glb file (repeatable)")
        ->expected(1)
        ->take_all();
    app.add_option("--method", methods, "M[@PRESET][:key=value,...][#label] (repeatable)")
        ->expected(1)
        ->take_all();
    app.add_option("--sweep", sweeps,
                   "METHOD.PARAM=v1,v2,...: every value in a cell of its own (repeatable: sweeps "
                   "of one method cross)")
        ->expected(1)
        ->take_all();
    app.add_option("--metric", metrics,
                   "NAME[@values|view|linear|codes][:key=value,...]: only this metric "
                   "(repeatable); default "
                   "those of the experiment")
        ->expected(1)
        ->take_all();
    app.add_option("--size", size, "WxH in pixels; default 384x288");
    app.add_option("--frames", frames, "A:B, half-open, in place of the default segments");
    app.add_option("--repeat", repeats,
                   "timing replays a round, default 6; 5 or more give intervals");
    app.add_option("--until-width", until_width,
                   "repeat until the 95 % interval of every ratio to the anchor has this relative "
                   "half-width (0.01 is 1 %); looks after 12, 24, 48, ... repeats");
    app.add_option("--time-limit", time_limit_s,
                   "with --until-width: seconds of timing replays a round, whatever the width");
    app.add_option("--most-repeats", most_repeats,
                   "with --until-width: repeats a round, whatever the width; default 192");
    app.add_option("--target", target,
                   "radius=R,falloff=none|linear|quadratic,weighting=cosine|uniform,"
                   "output=visibility|radiance,reach=near|full");
    app.add_option("--reference", reference,
                   "what errors are measured against: M[@PRESET][:key=value,...][#label]; default "
                   "reference_ray_traced, of radiance reference_path_traced. tssao@reference_480 "
                   "is what its estimator can do at most");
    app.add_flag("--warm", warm,
                 "with --frames A:B: hold the pose of A until histories have converged");
    app.add_option("--precision", precision,
                   "raster_depth=32F|24|16[,reversed],eye_depth=32F|16F|raster,motion=16F|32F");
    app.add_option("--audit", audit,
                   "share of what caches give that is made again and must agree; default 0.01");
    app.add_option("--settings", settings,
                   "common (mapped to the target, default), native (as methods come), or both: "
                   "common,native. Calibrated ones: --method M@FILE.toml, as tune writes it");
    app.add_flag("--explain-errors", explain_errors,
                 "errors of single frames taken apart (method, estimator, screen space), and the "
                 "best monotone curve of each method");
    app.add_flag("--count-fetches", count_fetches,
                 "texture fetches of every pass, counted in a replay of its own: a cost that is "
                 "the same on every device");
    app.add_flag("--strata", strata,
                 "image metrics also over depth edges, creases, three ranges of viewing angle, "
                 "moving objects and dark values");
    app.add_option("--regions", regions,
                   "OBJECT,...: image metrics also over the surface of each of these objects of "
                   "the scene");
    app.add_option("--effects", effects, "all (default), or auto: only what the scene calls for");
}

Experiment make_experiment(const ExperimentFlags& flags, const std::string& fallback,
                           const std::string& command_line, const Units& units) {
    const std::string name = !flags.experiment.empty() ? flags.experiment
                             : flags.quick             ? "quick"
                                                       : fallback;
    Experiment experiment = load_experiment(name, units);
    if (!flags.scenes.empty()) {
        experiment.scenes.clear();
        experiment.first_scene_only = false;
        for (const std::string& spec : flags.scenes) {
            experiment.scenes.push_back({spec, std::nullopt});
        }
    } else if (flags.quick) {
        experiment.first_scene_only = true;
    }
    if (!flags.methods.empty()) {
        experiment.methods.clear();
        experiment.skipped.clear();
        for (const std::string& text : flags.methods) {
            experiment.methods.push_back(parse_method_spec(text));
            load_calibration(experiment.methods.back(), units.methods,
                             [](const std::string& path) { return path; });
        }
    }
    replace_frames(flags, experiment);
    if (flags.size) {
        experiment.sizes = {parse_size(*flags.size)};
    }
    if (flags.repeats) {
        if (*flags.repeats < 1 || *flags.repeats > kMostRepeats) {
            throw InputError("--repeat", "out of range", std::to_string(*flags.repeats),
                             "1 to " + std::to_string(kMostRepeats));
        }
        experiment.repeats = *flags.repeats;
    }
    replace_repeat_rule(flags, experiment);
    if (flags.target) {
        experiment.targets = {*flags.target};
    }
    if (flags.reference) {
        experiment.reference = parse_method_spec(*flags.reference, "--reference");
    }
    if (flags.precision) {
        experiment.precisions = {parse_precision(*flags.precision)};
    }
    if (flags.settings) {
        experiment.settings = parse_settings(split(*flags.settings, ','));
    }
    experiment.explains_errors = experiment.explains_errors || flags.explain_errors;
    experiment.counts_fetches = experiment.counts_fetches || flags.count_fetches;
    experiment.measures_strata = experiment.measures_strata || flags.strata;
    if (flags.regions) {
        experiment.regions = split(*flags.regions, ',');
    }
    if (flags.effects) {
        experiment.effects = parse_effects_choice(*flags.effects);
    }
    if (!flags.metrics.empty()) {
        check_metric_specs(units.metrics, flags.metrics, "--metric");
        experiment.metrics = flags.metrics;
    }
    if (flags.audit) {
        if (!(*flags.audit >= 0.0 && *flags.audit <= 1.0)) {
            throw InputError("--audit", "out of range", format_number(*flags.audit), "0 to 1");
        }
        experiment.audit_share = *flags.audit;
    }
    // Another share of the cache every time, and the plan says which.
    experiment.audit_seed = std::random_device{}();
    std::vector<Sweep> sweeps;
    for (const std::string& text : flags.sweeps) {
        sweeps.push_back(parse_sweep(text));
    }
    apply_sweeps(sweeps, units.methods, experiment);
    const bool is_own = !flags.scenes.empty() || !flags.methods.empty() || !flags.sweeps.empty();
    if (is_own && flags.experiment.empty()) {
        experiment.name = "command-line";
        experiment.title.clear();
    }
    experiment.command_line = command_line;
    return experiment;
}

} // namespace alcove
