#include "harness/run/plan.hpp"

#include "scenes/registry.hpp"
#include "tests/harness/expect_error.hpp"
#include "tests/harness/temporary_folder.hpp"

#include <algorithm>
#include <set>

namespace alcove {
namespace {

Experiment make_experiment(std::vector<std::string> methods) {
    Experiment experiment;
    experiment.scenes = {{"template_scene", std::nullopt}};
    experiment.sizes = {{96, 72}};
    for (const std::string& text : methods) {
        experiment.methods.push_back(parse_method_spec(text));
    }
    return experiment;
}

PlanRecord plan_methods(std::vector<std::string> methods) {
    return make_plan(make_experiment(std::move(methods)), get_units()).record;
}

const ParameterRecord& find_parameter(const CellRecord& cell, const std::string& name) {
    const auto found = std::find_if(cell.parameters.begin(), cell.parameters.end(),
                                    [&](const ParameterRecord& p) { return p.name == name; });
    if (found == cell.parameters.end()) {
        throw std::runtime_error("no parameter " + name + " in " + cell.id);
    }
    return *found;
}

TEST(Plan, ARoundHoldsTheAnchorTwiceAndTheMethodsInOrder) {
    const PlanRecord plan = plan_methods({"none", "template_method"});
    ASSERT_EQ(plan.rounds.size(), 1u);
    const std::vector<CellRecord>& cells = plan.rounds[0].cells;
    ASSERT_EQ(cells.size(), 4u);
    EXPECT_EQ(cells[0].role, CellRole::anchor);
    EXPECT_EQ(cells[1].role, CellRole::anchor_repeat);
    EXPECT_EQ(cells[0].method, "anchor");
    EXPECT_EQ(cells[1].method, "anchor");
    EXPECT_EQ(cells[2].method, "none");
    EXPECT_FALSE(cells[2].has_passes);
    EXPECT_EQ(cells[3].method, "template_method");
    EXPECT_TRUE(cells[3].has_passes);
}

TEST(Plan, DefaultsOfTheExperimentReachTheRecord) {
    Experiment experiment = make_experiment({"none"});
    experiment.repeats = 7;
    experiment.shuffle_seed = 99;
    experiment.frames = {FrameChoice::Kind::ranges, {"2:5"}};
    const PlanRecord plan = make_plan(experiment, get_units()).record;
    EXPECT_EQ(plan.repeats, 7);
    EXPECT_EQ(plan.shuffle_seed, 99u);
    EXPECT_EQ(plan.reference_rays_per_half, 32);
    const RoundRecord& round = plan.rounds.at(0);
    EXPECT_EQ(round.width, 96);
    EXPECT_EQ(round.height, 72);
    ASSERT_EQ(round.segments.size(), 1u);
    EXPECT_EQ(round.segments[0].begin, 2);
    EXPECT_EQ(round.segments[0].end, 5);
    EXPECT_EQ(round.target, "radius=0.5,falloff=linear,weighting=cosine,normals=shading");
    EXPECT_EQ(round.precision, "raster_depth=32F,eye_depth=32F");
    EXPECT_EQ(round.scene_triangles, 24u);
}

TEST(Plan, EachTargetHasItsOwnReferenceUnlessOneIsNamed) {
    Experiment experiment = make_experiment({"none"});
    experiment.targets = {"", "output=radiance", "output=radiance,reach=full"};
    const PlanRecord plan = make_plan(experiment, get_units()).record;
    ASSERT_EQ(plan.rounds.size(), 3u);
    EXPECT_EQ(plan.rounds[0].reference.method, "reference_ray_traced");
    EXPECT_EQ(plan.rounds[1].reference.method, "reference_path_traced");
    EXPECT_EQ(find_parameter(plan.rounds[1].reference, "reach").value, "near");
    EXPECT_EQ(find_parameter(plan.rounds[2].reference, "reach").value, "full");
    EXPECT_FALSE(measures_pictures(plan.rounds[0]));
    EXPECT_TRUE(measures_pictures(plan.rounds[1]));
    experiment.reference = parse_method_spec("hemisphere_ssao", "--reference");
    for (const RoundRecord& round : make_plan(experiment, get_units()).record.rounds) {
        EXPECT_EQ(round.reference.method, "hemisphere_ssao");
    }
}

TEST(Plan, RadianceMeasuresColoursAndKeepsTheLight) {
    Experiment experiment = make_experiment({"none"});
    experiment.effects = EffectsChoice::automatic;
    const auto measures = [](const PlanRecord& plan, const char* metric) {
        return std::any_of(plan.metrics.begin(), plan.metrics.end(),
                           [&](const MetricDescription& m) { return m.name == metric; });
    };
    PlanRecord plan = make_plan(experiment, get_units()).record;
    EXPECT_FALSE(measures(plan, "chroma_error"));
    EXPECT_NE(plan.rounds.at(0).cells.at(2).effects.find("light_buffers"), std::string::npos);
    experiment.targets = {"output=radiance"};
    plan = make_plan(experiment, get_units()).record;
    EXPECT_TRUE(measures(plan, "chroma_error"));
    EXPECT_TRUE(measures(plan, "energy_ratio"));
    EXPECT_EQ(plan.rounds.at(0).cells.at(2).effects.find("light_buffers"), std::string::npos);
}

TEST(Plan, RegionsAreColumnsOfTheirOwn) {
    Experiment experiment = make_experiment({"none"});
    experiment.metrics = {"rmse"};
    experiment.regions = {"floor"};
    const PlanRecord plan = make_plan(experiment, get_units()).record;
    std::set<std::string> strata;
    for (const MetricDescription& metric : plan.metrics) {
        if (metric.kind == kStratumKind) {
            strata.insert(metric.name);
        }
    }
    EXPECT_EQ(strata, (std::set<std::string>{"pixels[floor]", "rmse[floor]"}));
    experiment.regions = {"flor"};
    expect_error([&] { static_cast<void>(make_plan(experiment, get_units())); }, 2,
                 {"template_scene", "flor", "nearest: floor"});
}

TEST(Plan, ErrorsOfPicturesAreNotTakenApart) {
    Experiment experiment = make_experiment({"none"});
    experiment.explains_errors = true;
    experiment.targets = {"output=radiance"};
    expect_error([&] { static_cast<void>(make_plan(experiment, get_units())); }, 2,
                 {"explain errors", "output=radiance"});
}

TEST(Plan, ProvenanceSaysWhereEachValueCameFrom) {
    const PlanRecord plan = plan_methods({"hemisphere_ssao@strong_blur:samples=32"});
    const CellRecord& cell = plan.rounds.at(0).cells.at(2);
    EXPECT_EQ(find_parameter(cell, "samples").value, "32");
    EXPECT_EQ(find_parameter(cell, "samples").provenance, "command line");
    EXPECT_EQ(find_parameter(cell, "blur_radius").provenance, "preset");
    EXPECT_EQ(find_parameter(cell, "rotation").provenance, "default");
    EXPECT_EQ(find_parameter(cell, "radius").provenance, "target");
    EXPECT_EQ(find_parameter(cell, "radius").value, "0.5");
    EXPECT_EQ(find_parameter(cell, "radius").unit, "m");
}

TEST(Plan, TheCommandLineWinsOverTheTarget) {
    Experiment experiment = make_experiment({"hemisphere_ssao:radius=0.25", "hemisphere_ssao"});
    experiment.targets = {"radius=2"};
    const PlanRecord plan = make_plan(experiment, get_units()).record;
    const std::vector<CellRecord>& cells = plan.rounds.at(0).cells;
    EXPECT_EQ(find_parameter(cells.at(2), "radius").value, "0.25");
    EXPECT_EQ(find_parameter(cells.at(3), "radius").value, "2");
    // The target is what is asked for, whatever the method was set to.
    EXPECT_EQ(cells.at(2).target, cells.at(3).target);
    EXPECT_EQ(cells.at(2).target.find("radius=2,"), 0u);
}

TEST(Plan, WhatAMethodCannotDoIsSaidInTheCell) {
    Experiment experiment = make_experiment({"hemisphere_ssao"});
    experiment.targets = {"falloff=quadratic"};
    const PlanRecord plan = make_plan(experiment, get_units()).record;
    EXPECT_FALSE(plan.rounds.at(0).cells.at(2).target_note.empty());
}

TEST(Plan, ParametersOfEveryMethodAndPresetRoundTripThroughTheRecord) {
    const Units units = get_units();
    for (const MethodUnit& unit : units.methods.units()) {
        for (const Preset& preset : unit.presets) {
            SCOPED_TRACE(unit.name + "@" + preset.name);
            const PlanRecord plan = plan_methods({unit.name + "@" + preset.name});
            const CellRecord& cell = plan.rounds.at(0).cells.at(2);
            const ResolvedParameters read = read_parameters(unit, cell);
            ASSERT_EQ(read.values().size(), cell.parameters.size());
            for (std::size_t i = 0; i < cell.parameters.size(); ++i) {
                EXPECT_EQ(read.values()[i].name, cell.parameters[i].name);
                EXPECT_EQ(to_text(read.values()[i].value), cell.parameters[i].value);
            }
        }
    }
}

TEST(Plan, NumbersRoundTripToTheLastBit) {
    const PlanRecord plan = plan_methods({"hemisphere_ssao:radius=0.1234567890123456789"});
    const Units units = get_units();
    const ResolvedParameters read =
        read_parameters(units.methods.find("hemisphere_ssao"), plan.rounds.at(0).cells.at(2));
    EXPECT_EQ(std::get<double>(read.get("radius")), 0.1234567890123456789);
}

TEST(Plan, UnknownNamesAreRefusedWithTheNearest) {
    expect_error([] { plan_methods({"hemisphere_sao"}); }, 2,
                 {"methods", "hemisphere_sao", "nearest: hemisphere_ssao"});
    expect_error([] { plan_methods({"hemisphere_ssao@strong_blurr"}); }, 2,
                 {"strong_blurr", "nearest: strong_blur"});
    expect_error([] { plan_methods({"hemisphere_ssao:sample=3"}); }, 2,
                 {"sample", "nearest: samples"});
    Experiment experiment = make_experiment({"none"});
    experiment.scenes = {{"cathedrall", std::nullopt}};
    expect_error([&] { static_cast<void>(make_plan(experiment, get_units())); }, 2,
                 {"scenes", "cathedrall", "nearest: cathedral"});
}

TEST(Plan, ValuesOutOfRangeAreRefusedNeverClamped) {
    expect_error([] { plan_methods({"hemisphere_ssao:samples=513"}); }, 2,
                 {"hemisphere_ssao", "samples", "513", "512"});
    expect_error([] { plan_methods({"hemisphere_ssao:samples=0"}); }, 2, {"samples"});
    expect_error([] { plan_methods({"hemisphere_ssao:samples=nan"}); }, 2, {"samples"});
    expect_error([] { plan_methods({"hemisphere_ssao:directions=cosin"}); }, 2,
                 {"directions", "nearest: cosine"});
}

TEST(Plan, MoreThanEightMethodsMakeTwoRoundsEachWithItsAnchorPair) {
    std::vector<std::string> methods;
    for (int samples = 1; samples <= 9; ++samples) {
        methods.push_back("hemisphere_ssao:samples=" + std::to_string(samples));
    }
    const PlanRecord plan = plan_methods(methods);
    ASSERT_EQ(plan.rounds.size(), 2u);
    EXPECT_EQ(plan.rounds[0].cells.size(), 10u);
    EXPECT_EQ(plan.rounds[1].cells.size(), 3u);
    for (const RoundRecord& round : plan.rounds) {
        EXPECT_EQ(round.cells[0].role, CellRole::anchor);
        EXPECT_EQ(round.cells[1].role, CellRole::anchor_repeat);
    }
    EXPECT_EQ(plan_methods({methods.begin(), methods.begin() + 8}).rounds.size(), 1u);
}

TEST(Plan, IdsAreUniqueAndSafeAsFolders) {
    const PlanRecord plan =
        plan_methods({"none#a/../b", "none#a/../b", "none#\xc3\x84 \"x\"\n,", "none#..", "none#A",
                      "none#a", "none#" + std::string(300, 'l'), "none#harness", "none#reference"});
    std::set<std::string> rounds;
    for (const RoundRecord& round : plan.rounds) {
        EXPECT_TRUE(rounds.insert(round.id).second) << round.id;
        std::set<std::string> cells{"harness", "reference"};
        for (const CellRecord& cell : round.cells) {
            EXPECT_TRUE(cells.insert(cell.id).second) << cell.id;
            EXPECT_EQ(cell.id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_.-"),
                      std::string::npos)
                << cell.id;
            // The longest name of a file in ext4, XFS and NTFS has 255 bytes.
            EXPECT_LT(cell.id.size(), 255u);
            EXPECT_NE(cell.id.front(), '.');
        }
    }
}

TEST(Plan, EveryUnitIsDescribedForReadersWithoutTheProgram) {
    const PlanRecord plan = plan_methods({"none", "template_method"});
    std::set<std::string> methods;
    for (const MethodDescription& method : plan.methods) {
        methods.insert(method.name);
        EXPECT_FALSE(method.title.empty());
        EXPECT_EQ(method.content_hash.size(), 64u) << method.name;
    }
    EXPECT_EQ(methods,
              (std::set<std::string>{"anchor", "none", "reference_ray_traced", "template_method"}));
    ASSERT_FALSE(plan.metrics.empty());
    for (const MetricDescription& metric : plan.metrics) {
        EXPECT_FALSE(metric.definition.empty()) << metric.name;
        EXPECT_NE(metric.name, "template_metric");
    }
    ASSERT_EQ(plan.scenes.size(), 1u);
    EXPECT_EQ(plan.scenes[0].name, "template_scene");
}

TEST(Plan, DefaultScenesAreTheReportedOnes) {
    Experiment experiment = make_experiment({"none"});
    experiment.scenes.clear();
    const MadePlan plan = make_plan(experiment, get_units());
    for (const RoundRecord& round : plan.record.rounds) {
        EXPECT_NE(round.scene, "template_scene");
    }
    const Registry<SceneUnit> scenes = scenes_registry();
    const auto reported = std::count_if(scenes.units().begin(), scenes.units().end(),
                                        [](const SceneUnit& unit) { return unit.reported; });
    EXPECT_EQ(plan.record.rounds.size() + plan.record.skipped.size(),
              static_cast<std::size_t>(reported));
}

TEST(Plan, ASceneWithoutItsPackageIsSkippedWithTheCommandThatMendsIt) {
    const TemporaryFolder empty;
    const ScopedVariable modules("ALCOVE_NODE_MODULES", empty.path().string());
    Experiment experiment = make_experiment({"none"});
    experiment.scenes = {{"bunny", std::nullopt}, {"template_scene", std::nullopt}};
    const PlanRecord plan = make_plan(experiment, get_units()).record;
    ASSERT_EQ(plan.rounds.size(), 1u);
    EXPECT_EQ(plan.rounds[0].scene, "template_scene");
    ASSERT_EQ(plan.skipped.size(), 1u);
    EXPECT_EQ(plan.skipped[0].what, "bunny");
    EXPECT_NE(plan.skipped[0].reason.find("npm ci"), std::string::npos) << plan.skipped[0].reason;
}

TEST(Plan, NoSceneLeftIsAFailure) {
    const TemporaryFolder empty;
    const ScopedVariable modules("ALCOVE_NODE_MODULES", empty.path().string());
    Experiment experiment = make_experiment({"none"});
    experiment.scenes = {{"bunny", std::nullopt}};
    expect_error([&] { static_cast<void>(make_plan(experiment, get_units())); }, 1,
                 {"no scene is left", "bunny", "npm ci"});
}

} // namespace
} // namespace alcove
