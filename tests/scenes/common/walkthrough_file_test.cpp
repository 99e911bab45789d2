#include "scenes/common/walkthrough_file.hpp"

#include "core/base/error.hpp"

#include <algorithm>
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
    return R"({"version":2,"name":"w","step_seconds":0.04,"frames":)" + frames +
           R"(,"near":0.1,"far":100,"cuts":)" + cuts + R"(,"interpolation":"keyed","keys":[)" +
           keys + "]}";
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
    expect_error(replace(kGood, R"("version":2)", R"("version":1)"), "version: unknown version");
    expect_error(replace(kGood, R"("version":2)", R"("version":3)"), "version: unknown version");
    expect_error(replace(kGood, R"("version":2)", R"("version":"2")"), "version");
    expect_error(replace(kGood, R"("version":2)", R"("version":2.0)"), "version");
    // What else a file of an older version lacks comes second.
    const std::string old = replace(kGood, R"("interpolation":"keyed",)", "");
    expect_error(replace(old, R"("version":2)", R"("version":1)"), "version: unknown version");
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

TEST(WalkthroughFile, HoldsTheCameraBetweenEqualKeys) {
    const std::string text =
        make_text(make_key(0, "[0.1,0,0]") + "," + make_key(7, "[0.3,0.7,0]", "33") + "," +
                  make_key(14, "[0.3,0.7,0]", "33") + "," + make_key(20, "[0.1,0,0]"));
    const Walkthrough walkthrough = parse_walkthrough(text, "path.json");
    for (std::size_t frame = 7; frame < 14; ++frame) {
        EXPECT_EQ(walkthrough.cameras[frame].position, walkthrough.cameras[14].position) << frame;
        EXPECT_EQ(walkthrough.cameras[frame].world_from_view,
                  walkthrough.cameras[14].world_from_view);
        EXPECT_EQ(walkthrough.cameras[frame].fov_y_radians, walkthrough.cameras[14].fov_y_radians);
    }
    EXPECT_NE(walkthrough.cameras[6].position, walkthrough.cameras[7].position);
    EXPECT_NE(walkthrough.cameras[15].position, walkthrough.cameras[14].position);
}

/// `frame` empty for an inner key.
std::string make_place(const std::string& frame, const std::string& position,
                       const std::string& fov = "60") {
    const std::string start = frame.empty() ? "{" : R"({"frame":)" + frame + ",";
    return start + R"("position":)" + position +
           R"(,"target":[0,0,-10],"up":[0,1,0],"fov_y_degrees":)" + fov + "}";
}

std::string make_constant_speed(const std::string& keys, const std::string& cuts = "[]") {
    return replace(make_text(keys, cuts, "101"), "keyed", "constant_speed");
}

/// Keys 0.5, 4.1 and 1.3 m apart, and a corner.
const std::string kUneven = make_place("0", "[0,0,0]") + "," + make_place("", "[0.5,0,0]") + "," +
                            make_place("", "[4,2,0.7]", "30") + "," +
                            make_place("100", "[4,3,1.5]", "30");

TEST(WalkthroughFile, MovesAtConstantSpeedThroughUnevenKeys) {
    const Walkthrough walkthrough = parse_walkthrough(make_constant_speed(kUneven), "path.json");
    const std::vector<Camera>& cameras = walkthrough.cameras;
    ASSERT_EQ(cameras.size(), 101u);
    EXPECT_EQ(cameras.front().position, glm::dvec3(0.0));
    EXPECT_EQ(cameras.back().position, glm::dvec3(4.0, 3.0, 1.5));
    const double first = glm::distance(cameras[1].position, cameras[0].position);
    for (std::size_t i = 1; i < cameras.size(); ++i) {
        const double step = glm::distance(cameras[i].position, cameras[i - 1].position);
        EXPECT_NEAR(step / first, 1.0, 1e-3) << "frame " << i;
    }
    // It passes its inner keys, between two frames.
    for (const glm::dvec3& key : {glm::dvec3(0.5, 0.0, 0.0), glm::dvec3(4.0, 2.0, 0.7)}) {
        double nearest = 1e9;
        for (const Camera& camera : cameras) {
            nearest = std::min(nearest, glm::distance(camera.position, key));
        }
        EXPECT_LT(nearest, 0.51 * first);
    }
    // The field of view follows the way.
    EXPECT_EQ(cameras.back().fov_y_radians, 30.0 * (std::numbers::pi / 180.0));
    EXPECT_LT(cameras[60].fov_y_radians, cameras[20].fov_y_radians);
}

TEST(WalkthroughFile, EveryRunBetweenCutsHasASpeedOfItsOwn) {
    const std::string text = make_constant_speed(
        make_place("0", "[0,0,0]") + "," + make_place("", "[1,0,0]") + "," +
            make_place("40", "[4,0,0]") + "," + make_place("41", "[0,9,0]") + "," +
            make_place("42", "[0,0,0]") + "," + make_place("100", "[0,0,5.8]"),
        "[41,42]");
    const std::vector<Camera> cameras = parse_walkthrough(text, "path.json").cameras;
    EXPECT_NEAR(cameras[10].position.x, 1.0, 1e-9);
    EXPECT_NEAR(cameras[25].position.x, 2.5, 1e-9);
    EXPECT_EQ(cameras[41].position, glm::dvec3(0.0, 9.0, 0.0));
    EXPECT_NEAR(cameras[50].position.z, 0.8, 1e-9);
}

TEST(WalkthroughFile, RejectsConstantSpeedWithoutAWay) {
    const std::string text = make_constant_speed(kUneven);
    expect_error(
        make_constant_speed(make_place("0", "[1,2,3]") + "," + make_place("100", "[1,2,3]")),
        "keys[1].position: does not move");
    expect_error(replace(text, "[0.5,0,0]", "[0,0,0]"), "keys[1].position: does not move");
    // A step that is lost in a way of 1e9 m.
    expect_error(make_constant_speed(make_place("0", "[0,0,0]") + "," +
                                     make_place("", "[1e9,0,0]") + "," +
                                     make_place("100", "[1e9,1e-5,0]")),
                 "keys[2].position: does not move");
    expect_error(make_constant_speed(make_place("0", "[0,0,0]")), "keys: too few keys");
    expect_error(replace(text, R"({"frame":0,)", "{"), "keys[0]: missing key");
    expect_error(replace(text, R"({"frame":100,)", "{"), "keys: too few keys");
    expect_error(replace(text, R"("frame":100)", R"("frame":99)"), "keys[3].frame");
    expect_error(make_constant_speed(make_place("0", "[0,0,0]") + "," +
                                     make_place("50", "[1,0,0]") + "," +
                                     make_place("100", "[2,0,0]")),
                 "keys[1].frame: only the ends");
    expect_error(make_constant_speed(kUneven + "," + make_place("", "[9,9,9]")),
                 "keys[4]: stands after");
    expect_error(make_constant_speed(kUneven, "[50]"), "keys[3].frame");
}

std::string make_poses(int count) {
    std::string poses;
    for (int i = 0; i < count; ++i) {
        poses += (i > 0 ? "," : "") + make_place("", "[" + std::to_string(i * i) + ",0,0]");
    }
    return R"({"version":2,"name":"w","step_seconds":0.04,"frames":4,"near":0.1,"far":100,)"
           R"("cuts":[2],"poses":[)" +
           poses + "]}";
}

TEST(WalkthroughFile, TakesPosesAsTheyAre) {
    const Walkthrough walkthrough = parse_walkthrough(make_poses(4), "path.json");
    ASSERT_EQ(walkthrough.cameras.size(), 4u);
    EXPECT_EQ(walkthrough.cuts, (std::vector<int>{0, 2}));
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(walkthrough.cameras[i].position.x, static_cast<double>(i * i));
    }
}

TEST(WalkthroughFile, TakesEitherKeysOrPoses) {
    const std::string good = make_poses(4);
    expect_error(make_poses(3), "poses: wrong number of poses");
    expect_error(make_poses(5), "poses: wrong number of poses");
    expect_error(replace(good, R"("poses")", R"("keys":[],"poses")"), "keys or poses");
    expect_error(replace(kGood, R"("keys")", R"("kees")"), "kees");
    expect_error(replace(good, R"("poses")", R"("interpolation":"keyed","poses")"),
                 "interpolation");
    expect_error(replace(kGood, R"("interpolation":"keyed",)", ""), "interpolation");
    expect_error(replace(kGood, "keyed", "kyed"), "nearest: keyed");
    expect_error(replace(good, R"({"position":[1,)", R"({"frame":1,"position":[1,)"), "poses[1]");
}

const std::string kMoving = replace(
    kGood, R"("keys")",
    R"("events":[{"frame":3,"label":"box turns"},{"frame":3,"label":"door opens"},{"frame":9,"label":"box rests"}],)"
    R"("tracks":[{"object":"box","pivot":[1,2,3],"axis":[0,0,2],"keys":[)"
    R"({"frame":3,"translation":[0,0,0],"degrees":0},{"frame":5,"translation":[0,1,0],"degrees":90},)"
    R"({"frame":9,"translation":[0,1,0.5],"degrees":720}]}],"keys")");

TEST(WalkthroughFile, ReadsEventsAndTracks) {
    const Walkthrough still = parse_walkthrough(kGood, "path.json");
    EXPECT_TRUE(still.events.empty());
    EXPECT_TRUE(still.tracks.empty());
    const Walkthrough walkthrough = parse_walkthrough(kMoving, "path.json");
    ASSERT_EQ(walkthrough.events.size(), 3u);
    EXPECT_EQ(walkthrough.events[1].frame, 3);
    EXPECT_EQ(walkthrough.events[1].label, "door opens");
    ASSERT_EQ(walkthrough.tracks.size(), 1u);
    const ObjectTrack& track = walkthrough.tracks[0];
    EXPECT_EQ(track.object, "box");
    EXPECT_EQ(track.pivot, glm::dvec3(1.0, 2.0, 3.0));
    EXPECT_EQ(track.axis, glm::dvec3(0.0, 0.0, 1.0));
    ASSERT_EQ(track.keys.size(), 3u);
    EXPECT_EQ(track.keys[2].frame, 9);
    EXPECT_EQ(track.keys[2].translation, glm::dvec3(0.0, 1.0, 0.5));
    EXPECT_EQ(track.keys[2].degrees, 720.0);
}

TEST(WalkthroughFile, ErrorsInEventsNameTheirPlace) {
    expect_error(replace(kMoving, R"("frame":9,"label")", R"("frame":2,"label")"),
                 "events[2].frame: does not ascend");
    expect_error(replace(kMoving, R"("frame":9,"label")", R"("frame":21,"label")"),
                 "events[2].frame");
    expect_error(replace(kMoving, R"("door opens")", R"("")"), "events[1].label");
    expect_error(replace(kMoving, R"("label":"door opens")", R"("name":"door opens")"),
                 "events[1]");
}

TEST(WalkthroughFile, ErrorsInTracksNameTheirPlace) {
    expect_error(replace(kMoving, R"("frame":9,"translation")", R"("frame":5,"translation")"),
                 "path.json: tracks[0].keys[2].frame: does not ascend");
    expect_error(replace(kMoving, R"("frame":9,"translation")", R"("frame":21,"translation")"),
                 "tracks[0].keys[2].frame");
    expect_error(replace(kMoving, R"("frame":9,"translation")", R"("frame":-1,"translation")"),
                 "tracks[0].keys[2].frame");
    expect_error(replace(kMoving, "[0,0,2]", "[0,0,0]"), "tracks[0].axis");
    expect_error(replace(kMoving, "[1,2,3]", "[1,2]"), "tracks[0].pivot");
    expect_error(replace(kMoving, "[1,2,3]", "[1,2,1e10]"), "tracks[0].pivot[2]");
    expect_error(replace(kMoving, R"("degrees":90)", R"("degrees":null)"),
                 "tracks[0].keys[1].degrees");
    expect_error(replace(kMoving, R"("degrees":90)", R"("degrees":1e999)"), "JSON");
    expect_error(replace(kMoving, R"("degrees":90)", R"("degrees":90,"scale":2)"),
                 "tracks[0].keys[1]: unknown key");
    expect_error(replace(kMoving, R"("pivot")", R"("pivots":0,"pivot")"), "tracks[0]: unknown key");
    expect_error(replace(kMoving, R"(}],"keys")",
                         R"(},{"object":"box","pivot":[0,0,0],"axis":[0,1,0],"keys":[]}],"keys")"),
                 "tracks[1].keys: has no keys");
    expect_error(replace(kMoving, R"(}],"keys")",
                         R"(},{"object":"box","pivot":[0,0,0],"axis":[0,1,0],"keys":[)"
                         R"({"frame":0,"translation":[0,0,0],"degrees":0}]}],"keys")"),
                 "tracks[1].object: has a track already");
}

TEST(WalkthroughFile, RejectsTruncatedAndDeeplyNestedText) {
    expect_error(kGood.substr(0, kGood.size() - 5), "JSON");
    expect_error(std::string(100'000, '['), "nested");
}

} // namespace
} // namespace alcove
