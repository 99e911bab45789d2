// Calibrations: read strictly, evaluated under each target, stronger than mapping and presets.
#include "harness/run/calibration.hpp"

#include "harness/run/plan.hpp"
#include "tests/harness/expect_error.hpp"
#include "tests/harness/temporary_folder.hpp"

#include <algorithm>

namespace alcove {
namespace {

class CalibrationTest : public testing::Test {
  protected:
    MethodSpec load(const std::string& text, const std::string& method = "hemisphere_ssao") {
        const std::filesystem::path path = m_folder.write("preset.toml", text);
        MethodSpec spec = parse_method_spec(method + "@preset.toml");
        load_calibration(spec, m_units.methods, [&](const std::string& name) {
            EXPECT_EQ(name, "preset.toml");
            return path;
        });
        return spec;
    }
    CellRecord make_cell(const MethodSpec& spec, double radius_m) {
        Target target;
        target.radius_m = radius_m;
        return make_cell_record(m_units.methods.find(spec.method), spec, target, 7.0);
    }
    static std::string get(const CellRecord& cell, const std::string& name) {
        const auto found = std::find_if(cell.parameters.begin(), cell.parameters.end(),
                                        [&](const ParameterRecord& p) { return p.name == name; });
        return found == cell.parameters.end() ? "none" : found->value;
    }

    TemporaryFolder m_folder;
    const Units m_units = get_units();
};

TEST_F(CalibrationTest, ARelativeRadiusFollowsTheTarget) {
    const MethodSpec spec = load("method = \"hemisphere_ssao\"\n[parameters]\n"
                                 "radius = \"0.5 * scene_radius\"\nsamples = 24.6\n");
    EXPECT_EQ(spec.settings, SettingsKind::calibrated);
    EXPECT_EQ(spec.preset, "default");
    EXPECT_EQ(get(make_cell(spec, 2.0), "radius"), "1");
    EXPECT_EQ(get(make_cell(spec, 0.5), "radius"), "0.25");
    EXPECT_EQ(get(make_cell(spec, 2.0), "samples"), "25");
    EXPECT_EQ(make_cell(spec, 2.0).settings, "calibrated");
}

TEST_F(CalibrationTest, OverridesItsPresetAndGivesWayToTheCommandLine) {
    MethodSpec spec = load("method = \"hemisphere_ssao\"\npreset = \"paper_weak_blur\"\n"
                           "[parameters]\nsamples = 8\n");
    EXPECT_EQ(get(make_cell(spec, 1.0), "samples"), "8");
    EXPECT_EQ(get(make_cell(spec, 1.0), "bias"), "0") << "the rest is the preset's";
    spec.overrides.push_back({"samples", "5", Provenance::command_line});
    EXPECT_EQ(get(make_cell(spec, 1.0), "samples"), "5");
}

TEST_F(CalibrationTest, WhatIsWrittenIsRead) {
    const std::string text = make_calibration_text(
        "tssao", "paper_stills", {{"radius", "1.25 * scene_radius"}, {"strength", "0.9"}});
    const MethodSpec spec =
        load(text + "\n[origin]\ncommand = 'alcove tune tssao'\nanything = [1, 2]\n", "tssao");
    EXPECT_EQ(spec.preset, "paper_stills");
    EXPECT_EQ(get(make_cell(spec, 2.0), "radius"), "2.5");
    EXPECT_EQ(get(make_cell(spec, 2.0), "strength"), "0.9");
}

TEST_F(CalibrationTest, RefusesWhatItCannotMean) {
    const std::string head = "method = \"hemisphere_ssao\"\n";
    expect_error([&] { load("method = \"tssao\"\n[parameters]\nradius = 1\n"); }, 2,
                 {"another method", "tssao", "hemisphere_ssao"});
    expect_error([&] { load(head); }, 2, {"no parameters"});
    expect_error([&] { load(head + "[parameters]\nradus = 1\n"); }, 2, {"preset.toml:3", "radius"});
    expect_error([&] { load(head + "[parameters]\nstrength = 99\n"); }, 2,
                 {"preset.toml:3", "out of range", "0.1 to 10"});
    expect_error([&] { load(head + "[parameters]\nstrength = \"scene_size\"\n"); }, 2,
                 {"unknown name", "scene_radius"});
    expect_error([&] { load(head + "presett = \"x\"\n[parameters]\nstrength = 1\n"); }, 2,
                 {"presett", "preset"});
    expect_error([&] { load(head + "preset = \"defalt\"\n[parameters]\nstrength = 1\n"); }, 2,
                 {"default"});
}

TEST(Settings, NativeCellsKnowTheSceneAndNotTheTarget) {
    const Units units = get_units();
    Experiment experiment;
    experiment.scenes = {{"template_scene", std::nullopt}};
    experiment.methods = {parse_method_spec("hemisphere_ssao"), parse_method_spec("none")};
    experiment.targets = {"radius=2,falloff=none"};
    experiment.settings = parse_settings({"common", "native"});
    const PlanRecord plan = make_plan(experiment, units).record;
    const std::vector<CellRecord>& cells = plan.rounds.at(0).cells;
    // `none` has no settings: it runs once.
    ASSERT_EQ(cells.size(), 5u);
    const auto radius = [](const CellRecord& cell) { return cell.parameters.at(0).value; };
    EXPECT_EQ(cells[2].settings, "common");
    EXPECT_EQ(radius(cells[2]), "2");
    EXPECT_NE(cells[2].target_note.find("falloff none asked for"), std::string::npos);
    EXPECT_EQ(cells[4].settings, "native");
    EXPECT_EQ(cells[4].label, "hemisphere_ssao (native)");
    EXPECT_EQ(radius(cells[4]), "0.5");
    EXPECT_EQ(plan.rounds[0].ao_radius_m, 0.5);
}

TEST(Settings, KindsAreNamedOnceEach) {
    expect_error([] { static_cast<void>(parse_settings({"comon"})); }, 2, {"comon", "common"});
    expect_error([] { static_cast<void>(parse_settings({"native", "native"})); }, 2, {"twice"});
    expect_error([] { static_cast<void>(parse_settings({})); }, 2, {"common, native or both"});
}

} // namespace
} // namespace alcove
