// Bad input: one line that names what was found and what was expected, and the right exit code.

#include "tests/harness/program.hpp"

#include <algorithm>

namespace alcove {
namespace {

class Refusal : public ProgramTest {
  protected:
    static std::string make_camera() {
        return write("camera.json", R"({"position":[2,1.5,4],"target":[0,0.5,0],"up":[0,1,0],)"
                                    R"("fov_y_degrees":60,"near":0.1,"far":100})");
    }
    static std::vector<std::string> reference_with(const std::string& scene,
                                                   const std::string& camera,
                                                   const std::vector<std::string>& more) {
        std::vector<std::string> arguments{"reference", scene, "--camera", camera};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    }
};

TEST_F(Refusal, MistypedNamesGetTheNearest) {
    expect_refused({"rnu"}, 2, {"verb", "rnu", "nearest: run"});
    expect_refused({"run", "--methd", "none"}, 2, {"--methd", "nearest: --method"});
    expect_refused({"metric", "--gat", "x"}, 2, {"--gat", "nearest: --gate"});
    expect_refused({"run", "--method", "hemisphere_sao"}, 2,
                   {"hemisphere_sao", "nearest: hemisphere_ssao"});
    expect_refused({"run", "--method", "hemisphere_ssao@strong_blr"}, 2,
                   {"strong_blr", "nearest: strong_blur"});
    expect_refused({"run", "--method", "hemisphere_ssao:radus=1"}, 2, {"radus", "nearest: radius"});
    expect_refused({"run", "--reference", "nosuch"}, 2, {"nosuch", "nearest: none"});
    expect_refused({"run", "--reference", "tsao@reference_480"}, 2, {"tsao", "nearest: tssao"});
    expect_refused({"run", "--reference", "tssao@nosuch"}, 2,
                   {"tssao", "nosuch", "default", "reference_480", "nearest: "});
    expect_refused({"run", "--reference", "tssao:radus=1"}, 2, {"radus", "nearest: radius"});
    expect_refused({"run", "--scene", "cathedrl"}, 2, {"cathedrl", "nearest: cathedral"});
    expect_refused({"metric", "a.png", "b.png", "--metric", "ssmi"}, 2, {"ssmi", "nearest: ssim"});
    expect_refused({"metric", "a.png", "b.png", "--domain", "sRBG"}, 2, {"sRBG", "nearest: srgb"});
    expect_refused({"reproduce", "sdo"}, 2, {"sdo", "tssao", "all", "nearest: ssdo"});
    expect_refused({"reproduce", "ssdo", "--scale", "smal"}, 2, {"--scale", "nearest: small"});
    expect_refused({"list", "metods"}, 2, {"metods", "nearest: methods"});
    expect_refused({"run", "--context", "osmeas"}, 2, {"osmeas", "nearest: osmesa"});
    expect_refused({"run", "--effects", "al"}, 2, {"--effects", "nearest: all"});
    expect_refused({"run", "--scene", "template_scene", "--target", "falloff=liner"}, 2,
                   {"liner", "nearest: linear"});
    expect_refused({"run", "--scene", "template_scene", "--target", "radus=1"}, 2,
                   {"radus", "nearest: radius"});
    expect_refused({"run", "--scene", "template_scene", "--target", "output=radianc"}, 2,
                   {"radianc", "nearest: radiance"});
    expect_refused({"run", "--scene", "template_scene", "--regions", "floor,bx"}, 2,
                   {"template_scene", "bx", "nearest: box"});
}

TEST_F(Refusal, WhatRadianceAloneHasIsNotAskedOfVisibilityAndTheOtherWayRound) {
    expect_refused({"run", "--scene", "template_scene", "--target", "reach=full"}, 2,
                   {"reach", "full", "output=radiance"});
    expect_refused(
        {"run", "--scene", "template_scene", "--target", "output=radiance", "--explain-errors"}, 2,
        {"explain errors", "output=radiance"});
    EXPECT_FALSE(std::filesystem::exists(folder() / "runs")) << "left behind by what was refused";
}

TEST_F(Refusal, ValuesOutOfRangeNameTheRange) {
    expect_refused({"run", "--method", "hemisphere_ssao:samples=513"}, 2,
                   {"hemisphere_ssao", "samples", "513", "1", "512"});
    expect_refused({"run", "--method", "hemisphere_ssao:samples=many"}, 2, {"samples", "many"});
    expect_refused({"run", "--repeat", "0"}, 2, {"--repeat", "1 to 1000"});
    expect_refused({"run", "--repeat", "x"}, 2, {"--repeat", "x"});
    expect_refused({"run", "--size", "0x0"}, 2, {"--size", "0x0", "1 to 16384"});
    expect_refused({"run", "--size", "16385x1"}, 2, {"--size", "16385x1"});
    expect_refused({"run", "--size", "big"}, 2, {"--size", "big"});
    expect_refused({"run", "--scene", "template_scene", "--frames", "0:61"}, 2,
                   {"--frames", "0:61", "60"});
    expect_refused({"run", "--scene", "template_scene", "--target", "radius=-1"}, 2,
                   {"radius", "-1"});
    expect_refused({"run", "--precision", "eye_depth=17F"}, 2, {"eye_depth", "17F"});
}

TEST_F(Refusal, PlannedVerbsFlagsAndFilesSayThatTheyArePlanned) {
    for (const char* verb : {"view"}) {
        expect_refused({verb, "argument", "--flag"}, 2, {verb, "planned"});
    }
    expect_refused({"scene", "fetch", "bunny"}, 2, {"unknown scene", "nearest: bunny00"});
    expect_refused({"run", "--warm"}, 2, {"--warm", "--frames A:B"});
    expect_refused({"run", "--audit", "3"}, 2, {"--audit", "0 to 1"});
    expect_refused({"run", "--sweep", "hemisphere_ssao.sampels=8"}, 2, {"nearest: samples"});
    expect_refused({"run", "experiment.toml"}, 2, {"experiment.toml"});
    expect_refused({"run", "defualt"}, 2, {"defualt", "nearest: default"});
    expect_refused({"run", "--shard", "1/2"}, 2, {"--shard", "planned"});
    EXPECT_FALSE(std::filesystem::exists(folder() / "runs")) << "left behind by what was refused";
}

TEST_F(Refusal, ScenesAreExportedOnlyAsTheyAreAskedFor) {
    expect_refused({"scene", "exprot", "bunny"}, 2, {"exprot", "nearest: export"});
    expect_refused({"scene", "export", "template_scene"}, 2, {"--out", ".glb"});
    expect_refused({"scene", "export", "template_scene", "--out", "a.obj"}, 2, {"a.obj", ".glb"});
    expect_refused({"scene", "export", "no_such", "--out", "a.glb"}, 2, {"no_such"});
    EXPECT_FALSE(std::filesystem::exists(folder() / "a.glb"));
}

TEST_F(Refusal, PlannedPartsStandInTheHelp) {
    const ChildResult help = run({"--help"});
    EXPECT_EQ(help.exit_code, 0);
    for (const char* verb : {"Planned:", "compare", "ab", "nightly", "tune", "run", "metric"}) {
        EXPECT_NE(help.out.find(verb), std::string::npos) << verb;
    }
    const ChildResult flags = run({"run", "--help"});
    EXPECT_EQ(flags.exit_code, 0);
    for (const char* flag : {"Planned:", "--sweep", "--shard", "--resume"}) {
        EXPECT_NE(flags.out.find(flag), std::string::npos) << flag;
    }
}

TEST_F(Refusal, NoVerbIsAnError) {
    expect_refused({}, 2, {"verb", "--help"});
}

TEST_F(Refusal, BadScenesAreNamed) {
    expect_refused({"run", "--scene", "missing.gltf"}, 2, {"missing.gltf", "no such file"});
    expect_refused({"run", "--scene", folder().string() + "/"}, 2, {"not a regular file"});
    const std::string whole = make_box_gltf();
    expect_refused({"run", "--scene", write("half.gltf", whole.substr(0, whole.size() / 2))}, 2,
                   {"half.gltf"});
    expect_refused({"run", "--scene", write("empty.gltf", "")}, 2, {"empty.gltf"});
    expect_refused({"run", "--scene", write("noise.glb", std::string(64, '\x7f'))}, 2,
                   {"noise.glb"});
    std::string climbing = whole;
    const std::size_t at = climbing.find("data:application");
    climbing.replace(at, climbing.find('"', at) - at, "../outside.bin");
    expect_refused({"run", "--scene", write("climbing.gltf", climbing)}, 2,
                   {"climbing.gltf", "../outside.bin"});
}

TEST_F(Refusal, AnOutputFolderBelowAFileIsRefusedBeforeAnythingRuns) {
    const std::string file = write("file", "text");
    expect_refused({"run", "--scene", "template_scene", "--out", file + "/run"}, 2,
                   {"file/run", "output folder"});
}

TEST_F(Refusal, AReferenceThatCannotBeWrittenIsAFailure) {
    const std::string file = write("file", "text");
    expect_refused(
        reference_with(write("box.gltf", make_box_gltf()), make_camera(),
                       {"--radius", "1", "--spp", "2", "--size", "8x8", "--out", file + "/v.exr"}),
        1, {file.c_str(), "cannot create the folder"});
}

TEST_F(Refusal, BadReferenceRequestsAreNamed) {
    const std::string box = write("box.gltf", make_box_gltf());
    const std::string camera = make_camera();
    const std::string out = (folder() / "v.exr").string();
    expect_refused(reference_with(box, camera, {"--radius", "1", "--spp", "3", "--out", out}), 2,
                   {"--spp", "3", "even"});
    expect_refused(reference_with(box, camera, {"--radius", "1", "--spp", "0", "--out", out}), 2,
                   {"--spp"});
    expect_refused(reference_with(box, camera, {"--radius", "0", "--spp", "2", "--out", out}), 2,
                   {"--radius", "positive"});
    expect_refused(reference_with(box, camera, {"--radius", "nan", "--spp", "2", "--out", out}), 2,
                   {"--radius"});
    expect_refused(reference_with(box, camera, {"--radius", "1", "--spp", "2", "--out", "v.png"}),
                   2, {"--out", ".exr"});
    expect_refused(
        reference_with(box, camera, {"--radius", "1", "--spp", "2", "--size", "0x0", "--out", out}),
        2, {"--size", "0x0"});
    expect_refused(
        reference_with(box, camera,
                       {"--radius", "1", "--spp", "2", "--falloff", "cubic", "--out", out}),
        2, {"cubic"});
    expect_refused(
        reference_with(box, "missing.json", {"--radius", "1", "--spp", "2", "--out", out}), 2,
        {"missing.json"});
    const std::string keyless = write("keyless.json", R"({"position":[0,0,0]})");
    expect_refused(reference_with(box, keyless, {"--radius", "1", "--spp", "2", "--out", out}), 2,
                   {"keyless.json"});
    expect_refused(reference_with(box, camera, {"--radius", "1", "--out", out}), 2, {"--spp"});
    EXPECT_FALSE(std::filesystem::exists(out));
}

TEST_F(Refusal, FoldersThatHoldNoRunAreNamed) {
    expect_refused({"report", "missing"}, 2, {"missing", "not a run folder"});
    expect_refused({"report"}, 2, {"runs"});
    expect_refused({"run", "--resume", folder().string()}, 2, {"not a run folder"});
}

TEST_F(Refusal, ScenesWithoutTheirPackageSayHowToGetIt) {
    ChildOptions options;
    options.environment["ALCOVE_NODE_MODULES"] = (folder() / "empty").string();
    const ChildResult result = run({"run", "--scene", "bunny"}, options);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.err.find("npm ci"), std::string::npos) << result.err;
}

} // namespace
} // namespace alcove
