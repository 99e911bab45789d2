#include "harness/run/experiment_file.hpp"

#include "harness/run/plan.hpp"
#include "tests/harness/expect_error.hpp"
#include "tests/harness/temporary_folder.hpp"

#include <fstream>

namespace alcove {
namespace {

Experiment parse(const std::string& text) {
    return parse_experiment(text, "e.toml", "/tmp", get_units());
}

void expect_refused(const std::string& text, std::initializer_list<const char*> parts) {
    SCOPED_TRACE(text);
    expect_error([&] { static_cast<void>(parse(text)); }, 2, parts);
}

TEST(ExperimentFile, EveryKeyReachesTheExperiment) {
    const Experiment experiment = parse(R"(
name = "mine"
title = "All of it"
scenes = ["bunny", "lifted_box:motion=slide"]
frames = ["0:16", "20:36"]
warm = true
sizes = ["64x48", "128x96"]
targets = ["", "radius=0.3,falloff=none"]
precisions = "raster_depth=24,reversed"
methods = ["none", "tssao@paper_stills:history_cap=100#short"]
repeats = 7
until_width = 0.01
time_limit_s = 120
most_repeats = 96
effects = "all"
reference = "tssao@reference_480"
reference_rays_per_half = 32
metrics = ["rmse", "ssim"]
regions = ["floor", "small red"]
seed = 9

[[scene]]
use = "moving_objects"
walkthroughs = ["clip", "zoom"]
frames = "quick"

[[method]]
use = "tssao"
label = "cap"
cross.history_cap = { from = 100, to = 10000, steps = 3 }
zip.initial_samples = [32, 64]
zip.converged_samples = [8, 16]
skip = [{ where = { history_cap = 100, initial_samples = 64 }, reason = "too short" }]
)");
    EXPECT_EQ(experiment.name, "mine");
    EXPECT_EQ(experiment.title, "All of it");
    ASSERT_EQ(experiment.scenes.size(), 4u);
    EXPECT_EQ(experiment.scenes[1].spec, "lifted_box:motion=slide");
    EXPECT_FALSE(experiment.scenes[1].frames);
    EXPECT_EQ(experiment.scenes[3].spec, "moving_objects:walkthrough=zoom");
    EXPECT_EQ(experiment.scenes[3].frames->kind, FrameChoice::Kind::quick);
    EXPECT_EQ(experiment.frames.ranges, (std::vector<std::string>{"0:16", "20:36"}));
    EXPECT_TRUE(experiment.frames.warm);
    EXPECT_EQ(experiment.sizes, (std::vector<ImageSize>{{64, 48}, {128, 96}}));
    EXPECT_EQ(experiment.targets[1], "radius=0.3,falloff=none");
    EXPECT_TRUE(experiment.precisions.at(0).reversed);
    EXPECT_EQ(experiment.repeats, 7);
    EXPECT_EQ(experiment.until_width, 0.01);
    EXPECT_EQ(experiment.time_limit_s, 120.0);
    EXPECT_EQ(experiment.most_repeats, 96);
    EXPECT_EQ(experiment.reference.value().preset, "reference_480");
    EXPECT_EQ(experiment.reference_rays_per_half, 32);
    EXPECT_EQ(experiment.metrics, (std::vector<std::string>{"rmse", "ssim"}));
    EXPECT_EQ(experiment.regions, (std::vector<std::string>{"floor", "small red"}));
    EXPECT_EQ(experiment.shuffle_seed, 9u);
    // history_cap is declared on a logarithmic scale, so its range steps by factors.
    std::vector<std::string> labels;
    for (const MethodSpec& spec : experiment.methods) {
        labels.push_back(spec.label);
    }
    EXPECT_EQ(labels,
              (std::vector<std::string>{
                  "none", "short", "cap:history_cap=100,converged_samples=8,initial_samples=32",
                  "cap:history_cap=1000,converged_samples=8,initial_samples=32",
                  "cap:history_cap=1000,converged_samples=16,initial_samples=64",
                  "cap:history_cap=10000,converged_samples=8,initial_samples=32",
                  "cap:history_cap=10000,converged_samples=16,initial_samples=64"}));
    ASSERT_EQ(experiment.skipped.size(), 1u);
    EXPECT_EQ(experiment.skipped[0].reason, "too short");
}

TEST(ExperimentFile, RepeatsThatGoOnHaveAWidthAndRoomForALook) {
    const std::string rest = "methods = [\"none\"]\n";
    expect_refused(rest + "until_width = 0\n", {"e.toml:2", "until_width", "out of range", "0"});
    expect_refused(rest + "until_width = 1.5\n", {"until_width", "1.5", "(0, 1)"});
    expect_refused(rest + "time_limit_s = 60\n", {"time_limit_s", "no until_width"});
    expect_refused(rest + "most_repeats = 60\n", {"most_repeats", "no until_width"});
    expect_refused(rest + "until_width = 0.1\nmost_repeats = 11\n",
                   {"most_repeats", "11", "12 to 10000"});
    expect_refused(rest + "until_width = 0.1\ntime_limit_s = -1\n", {"time_limit_s", "-1"});
    const PlanRecord plan =
        make_plan(parse(rest + "scenes = [\"bunny\"]\nuntil_width = 0.1\n"), get_units()).record;
    EXPECT_EQ(plan.until_width, 0.1);
    EXPECT_EQ(plan.repeats, 6);
    EXPECT_EQ(plan.limit_repeats(), 192);
}

TEST(ExperimentFile, MistakesNameFileLineAndNearestName) {
    expect_refused("methods = [\"none\"]\nrepeets = 3\n",
                   {"e.toml:2", "unknown key", "repeets", "nearest: repeats"});
    expect_refused("methods = [\"none\"]\n\nrepeats = \"six\"\n",
                   {"e.toml:3", "repeats", "a string", "an integer"});
    expect_refused("methods = [\"none\"]\nrepeats = 0\n", {"e.toml:2", "repeats", "1 to 1000"});
    expect_refused("methods = [\"nune\"]\n", {"e.toml:1", "nearest: none"});
    expect_refused("scenes = [\"buny\"]\nmethods = [\"none\"]\n", {"e.toml:1", "nearest: bunny"});
    expect_refused("methods = [\"none\"]\nmetrics = [\"rmsee\"]\n", {"e.toml:2", "nearest: rmse"});
    expect_refused("methods = [\"none\"]\neffects = \"some\"\n", {"e.toml:2", "nearest"});
    expect_refused("methods = [\"none\"]\nsizes = []\n", {"e.toml:2", "without a value"});
    expect_refused("methods = [\"none\"]\nsizes = \"0x3\"\n", {"e.toml:2", "0x3"});
    expect_refused("methods = [\"none\"]\nwarm = true\n", {"e.toml:2", "frames"});
    expect_refused("name = \"../up\"\nmethods = [\"none\"]\n", {"e.toml:1", "../up"});
    expect_refused("name = \"mine\"\n", {"no method"});
    expect_refused("methods = [\"none\"\n", {"e.toml:", "no TOML"});
    expect_refused("methods = [\"none\", 3]\n", {"e.toml:1", "array of strings"});
    expect_refused("[[method]]\nuse = \"tssao\"\ncross.history_cop = [1]\n",
                   {"e.toml:3", "nearest: history_cap"});
    expect_refused("[[method]]\nuse = \"tssao\"\ncross.history_cap = [1, \"a lot\"]\n",
                   {"e.toml:3", "history_cap", "a lot"});
    expect_refused("[[method]]\nuse = \"tssao\"\n\ncross.history_cap = { from = 1, to = 2 }\n",
                   {"e.toml:4", "steps"});
    expect_refused("[[method]]\nuse = \"tssao\"\ncros.history_cap = [1]\n",
                   {"e.toml:3", "nearest: cross"});
    expect_refused("[[method]]\nlabel = \"x\"\n", {"e.toml:1", "use"});
    expect_refused("[[method]]\nuse = \"tssao\"\ncross.history_cap = [1, 2]\n"
                   "skip = [{ where = { history_cap = 3 }, reason = \"r\" }]\n",
                   {"e.toml:2", "no combination meets"});
    expect_refused("[[method]]\nuse = \"tssao\"\nskip = [{ where = { history_cap = 3 } }]\n",
                   {"e.toml:3", "reason"});
}

TEST(ExperimentFile, PathsOfScenesStayBelowItsFolder) {
    expect_refused("scenes = [\"../secret.glb\"]\nmethods = [\"none\"]\n", {"e.toml:1"});
    expect_refused("scenes = [\"/etc/x.gltf\"]\nmethods = [\"none\"]\n", {"e.toml:1"});
}

TEST(ExperimentFile, EveryShippedExperimentCanBePlanned) {
    const Units units = get_units();
    const std::vector<std::string> names = list_experiments();
    for (const char* name : {"default", "quick", "nightly", "sweep_n_max"}) {
        EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
    }
    for (const std::string& name : names) {
        SCOPED_TRACE(name);
        const Experiment experiment = load_experiment(name, units);
        EXPECT_EQ(experiment.name, name);
        EXPECT_FALSE(experiment.title.empty());
        EXPECT_FALSE(make_plan(experiment, units).record.rounds.empty());
    }
    expect_error([&] { static_cast<void>(load_experiment("nightli", units)); }, 2,
                 {"nightli", "nearest: nightly"});
}

TEST(ExperimentFile, AFileIsReadFromItsPath) {
    const TemporaryFolder folder;
    const std::filesystem::path path = folder.path() / "mine.toml";
    std::ofstream(path) << "name = \"mine\"\nmethods = \"none\"\n";
    EXPECT_EQ(load_experiment(path.string(), get_units()).methods.size(), 1u);
    expect_error([&] { static_cast<void>(load_experiment("no_such.toml", get_units())); }, 2,
                 {"no_such.toml"});
}

TEST(Plan, AxesOfAnExperimentMakeRoundsOfTheirOwn) {
    Experiment experiment = parse("scenes = [\"template_scene\"]\nmethods = [\"none\"]\n"
                                  "sizes = [\"64x48\", \"32x24\"]\n"
                                  "targets = [\"\", \"radius=0.25\"]\n"
                                  "precisions = [\"\", \"eye_depth=16F\"]\nmetrics = \"rmse\"\n");
    const PlanRecord plan = make_plan(experiment, get_units()).record;
    ASSERT_EQ(plan.rounds.size(), 8u);
    EXPECT_EQ(plan.rounds[0].precision, "raster_depth=32F,eye_depth=32F");
    EXPECT_EQ(plan.rounds[1].precision, "raster_depth=32F,eye_depth=16F");
    EXPECT_EQ(plan.rounds[2].width, 32);
    EXPECT_EQ(plan.rounds[4].target, "radius=0.25,falloff=linear,weighting=cosine,normals=shading");
    std::size_t measured = 0;
    for (const MetricDescription& metric : plan.metrics) {
        measured += metric.kind == "history" ? 0 : 1;
    }
    EXPECT_EQ(measured, 1u);
}

} // namespace
} // namespace alcove
