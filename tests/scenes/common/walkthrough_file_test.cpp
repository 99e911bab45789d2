#include "scenes/common/walkthrough_file.hpp"

#include "core/base/error.hpp"

#include <numbers>
#include <string>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace alcove {
namespace {

std::string make_key(int frame, const std::string& position, const std::string& fov = "60") {
    return R"({"frame":)" + std::to_string(frame) + R"(,"position":)" + position +
           R"(,"target":[0,0,-10],"up":[0,1,0],"fov_y_degrees":)" + fov + "}";
}

std::string make_text(const std::string& keys, const std::string& cuts = "[]",
                      const std::string& frames = "21") {
    return R"({"version":1,"name":"w","step_seconds":0.04,"frames":)" + frames +
           R"(,"near":0.1,"far":100,"cuts":)" + cuts + R"(,"keys":[)" + keys + "]}";
}

const std::string kGood = make_text(make_key(0, "[0,0,0]") + "," + make_key(10, "[1,2,0]", "30") +
                                    "," + make_key(20, "[4,2,0]", "30"));

std::string replace(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

void expect_error(const std::string& text, const std::string& part) {
    try {
        static_cast<void>(parse_walkthrough(text, "path.json"));
        FAIL() << "accepted: " << text;
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("path.json"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
}

TEST(WalkthroughFile, GivesOneCameraAFrameExactAtKeys) {
    const Walkthrough walkthrough = parse_walkthrough(kGood, "path.json");
    EXPECT_EQ(walkthrough.name, "w");
    EXPECT_EQ(walkthrough.step_s, 0.04);
    ASSERT_EQ(walkthrough.cameras.size(), 21u);
    EXPECT_EQ(walkthrough.cuts, std::vector<int>{0});
    EXPECT_EQ(walkthrough.cameras[0].position, glm::dvec3(0.0));
    EXPECT_EQ(walkthrough.cameras[10].position, glm::dvec3(1.0, 2.0, 0.0));
    EXPECT_EQ(walkthrough.cameras[20].position, glm::dvec3(4.0, 2.0, 0.0));
    EXPECT_EQ(walkthrough.cameras[10].fov_y_radians, 30.0 * (std::numbers::pi / 180.0));
    EXPECT_EQ(walkthrough.cameras[7].near_m, 0.1);
    EXPECT_EQ(walkthrough.cameras[7].far_m, 100.0);
}

TEST(WalkthroughFile, FollowsAParabolaBetweenItsKeys) {
    // x = t^2 / 100 through (0, 0), (10, 1), (20, 4): the slope at the middle key is 0.2, at the
    // first end 0.1 (the chord). Hermite by hand at s = 0.5: x = 0.5 * 1 + 10 * (0.1 - 0.2) / 8.
    const Walkthrough walkthrough = parse_walkthrough(kGood, "path.json");
    EXPECT_NEAR(walkthrough.cameras[5].position.x, 0.375, 1e-12);
    // No jump in velocity at the middle key.
    const double before = walkthrough.cameras[10].position.x - walkthrough.cameras[9].position.x;
    const double after = walkthrough.cameras[11].position.x - walkthrough.cameras[10].position.x;
    EXPECT_NEAR(before, after, 0.05); // straight lines would give 0.1 and 0.3
    EXPECT_NEAR(0.5 * (before + after), 0.2, 0.01);
}

TEST(WalkthroughFile, KeepsTheFieldOfViewBetweenItsKeys) {
    const Walkthrough walkthrough = parse_walkthrough(kGood, "path.json");
    for (const Camera& camera : walkthrough.cameras) {
        EXPECT_GE(camera.fov_y_radians * 180.0 / std::numbers::pi, 30.0 - 1e-9);
        EXPECT_LE(camera.fov_y_radians * 180.0 / std::numbers::pi, 60.0 + 1e-9);
    }
}

TEST(WalkthroughFile, BreaksTheCurveAtACut) {
    const std::string text =
        make_text(make_key(0, "[0,0,0]") + "," + make_key(9, "[9,0,0]") + "," +
                      make_key(10, "[100,0,0]") + "," + make_key(20, "[110,0,0]"),
                  "[10]");
    const Walkthrough walkthrough = parse_walkthrough(text, "path.json");
    EXPECT_EQ(walkthrough.cuts, (std::vector<int>{0, 10}));
    for (int frame = 0; frame < 21; ++frame) {
        const double x = walkthrough.cameras[static_cast<std::size_t>(frame)].position.x;
        EXPECT_NEAR(x, frame < 10 ? frame : 90 + frame, 1e-9) << frame;
    }
}

TEST(WalkthroughFile, AcceptsASingleFrame) {
    const Walkthrough walkthrough =
        parse_walkthrough(make_text(make_key(0, "[0,0,0]"), "[]", "1"), "path.json");
    EXPECT_EQ(walkthrough.cameras.size(), 1u);
}

TEST(WalkthroughFile, RejectsUnknownMissingAndRepeatedKeys) {
    expect_error(replace(kGood, R"("near")", R"("nearer":1,"near")"), "nearer");
    expect_error(replace(kGood, R"("near":0.1,)", ""), "near");
    expect_error(replace(kGood, R"("cuts":[],)", ""), "cuts");
    expect_error(replace(kGood, R"("up":[0,1,0],)", ""), "keys[0]");
    expect_error(replace(kGood, R"("frame":10,)", R"("frame":10,"roll":0,)"), "keys[1]");
    expect_error(replace(kGood, R"("near":0.1)", R"("near":0.1,"near":0.2)"), "twice");
}

TEST(WalkthroughFile, RejectsOtherVersions) {
    expect_error(replace(kGood, R"("version":1)", R"("version":2)"), "version");
    expect_error(replace(kGood, R"("version":1)", R"("version":"1")"), "version");
    expect_error(replace(kGood, R"("version":1)", R"("version":1.0)"), "version");
}

TEST(WalkthroughFile, RejectsWrongTypes) {
    expect_error("[]", "object");
    expect_error(replace(kGood, "[1,2,0]", "[1,2]"), "keys[1].position");
    expect_error(replace(kGood, "[1,2,0]", "[1,null,0]"), "keys[1].position[1]");
    expect_error(replace(kGood, R"("frames":21)", R"("frames":21.5)"), "frames");
    expect_error(replace(kGood, R"("name":"w")", R"("name":7)"), "name");
    expect_error(replace(kGood, R"("name":"w")", R"("name":"")"), "name");
    expect_error(replace(kGood, R"("cuts":[])", R"("cuts":3)"), "cuts");
    expect_error(replace(kGood, R"("keys":[)", R"("keys":[7,)"), "keys[0]");
}

TEST(WalkthroughFile, RejectsNumbersOutOfRange) {
    expect_error(replace(kGood, "[4,2,0]", "[4,2e12,0]"), "keys[2].position[1]");
    expect_error(replace(kGood, "[4,2,0]", "[4,NaN,0]"), "JSON");
    expect_error(replace(kGood, "[4,2,0]", "[4,1e400,0]"), "JSON");
    expect_error(replace(kGood, R"("frames":21)", R"("frames":100001)"), "frames");
    expect_error(replace(kGood, R"("frames":21)", R"("frames":0)"), "frames");
    expect_error(replace(kGood, R"("frames":21)", R"("frames":18446744073709551615)"), "frames");
    expect_error(replace(kGood, "0.04", "0"), "step_seconds");
    expect_error(replace(kGood, R"("near":0.1)", R"("near":0)"), "near");
    expect_error(replace(kGood, R"("far":100)", R"("far":0.1)"), "far");
    expect_error(replace(kGood, R"("fov_y_degrees":30)", R"("fov_y_degrees":180)"),
                 "keys[1].fov_y_degrees");
    expect_error(replace(kGood, "[0,1,0]", "[0,0,0]"), "keys[0].up");
}

TEST(WalkthroughFile, RejectsKeysOutOfOrder) {
    expect_error(replace(kGood, R"("frame":0)", R"("frame":1)"), "keys[0].frame");
    expect_error(replace(kGood, R"("frame":10)", R"("frame":0)"), "keys[1].frame");
    expect_error(replace(kGood, R"("frame":20)", R"("frame":19)"), "keys[2].frame");
    expect_error(replace(kGood, R"("frame":20)", R"("frame":21)"), "keys[2].frame");
    expect_error(make_text(""), "keys");
}

TEST(WalkthroughFile, RejectsCutsWithoutKeysOrOutOfOrder) {
    expect_error(replace(kGood, R"("cuts":[])", R"("cuts":[10])"), "cuts[0]");
    expect_error(replace(kGood, R"("cuts":[])", R"("cuts":[0])"), "cuts[0]");
    expect_error(replace(kGood, R"("cuts":[])", R"("cuts":[21])"), "cuts[0]");
    const std::string text = make_text(make_key(0, "[0,0,0]") + "," + make_key(9, "[9,0,0]") + "," +
                                           make_key(10, "[1,0,0]") + "," + make_key(20, "[2,0,0]"),
                                       "[10,10]");
    expect_error(text, "cuts[1]");
}

TEST(WalkthroughFile, RejectsACameraThatSeesNothing) {
    expect_error(replace(kGood, "[1,2,0]", "[0,0,-10]"), "frame 10");
}

TEST(WalkthroughFile, RejectsTruncatedAndDeeplyNestedText) {
    expect_error(kGood.substr(0, kGood.size() - 5), "JSON");
    expect_error(std::string(100'000, '['), "nested");
}

} // namespace
} // namespace alcove
