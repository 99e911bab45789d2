#include "scenes/common/rigid_scene.hpp"

#include "core/base/error.hpp"

#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace alcove {
namespace {

constexpr double kStep = 1.0 / 30.0;

Mesh make_triangle() {
    Mesh mesh;
    mesh.name = "triangle";
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.normals.assign(3, {0, 0, 1});
    mesh.indices = {0, 1, 2};
    return mesh;
}

/// Turns a quarter about the z axis through (1, 0, 0) in frames 10 to 20, then moves up by 3 m to
/// frame 40.
ObjectTrack make_track() {
    ObjectTrack track;
    track.object = "moved";
    track.pivot = {1.0, 0.0, 0.0};
    track.axis = {0.0, 0.0, 1.0};
    track.keys = {{10, {0, 0, 0}, 0.0}, {20, {0, 0, 0}, 90.0}, {40, {0, 3, 0}, 90.0}};
    return track;
}

RigidSceneContent make_content() {
    RigidSceneContent content;
    content.meshes = {make_triangle()};
    content.objects = {{"still", 0}, {"moved", 0}};
    content.transforms = {glm::dmat4(1.0),
                          glm::translate(glm::dmat4(1.0), glm::dvec3(2.0, 0.0, 5.0))};
    content.walkthrough.step_s = kStep;
    content.walkthrough.cameras.assign(60, Camera{});
    content.walkthrough.tracks = {make_track()};
    return content;
}

/// World position of a point of the moved object at a frame.
glm::dvec3 follow(const Scene& scene, double frame, const glm::dvec3& point = glm::dvec3(0.0)) {
    return {scene.compute_pose(frame * kStep).object_to_world[1] * glm::dvec4(point, 1.0)};
}

void expect_near(const glm::dvec3& found, const glm::dvec3& expected, double tolerance = 1e-12) {
    EXPECT_LE(glm::distance(found, expected), tolerance)
        << found.x << ", " << found.y << ", " << found.z;
}

TEST(RigidScene, MovesAnObjectAlongItsTrack) {
    const RigidScene scene(make_content());
    EXPECT_NO_THROW(check_scene(scene, "test"));
    // By hand: the object's zero rests 1 m to the right of the pivot, 5 m in front.
    expect_near(follow(scene, 0), {2, 0, 5}, 0.0);
    expect_near(follow(scene, 10), {2, 0, 5}, 0.0);
    expect_near(follow(scene, 15), {1 + std::sqrt(0.5), std::sqrt(0.5), 5});
    expect_near(follow(scene, 20), {1, 1, 5});
    expect_near(follow(scene, 20, {1, 0, 0}), {1, 2, 5}); // its x axis points up now
    expect_near(follow(scene, 30), {1, 2.5, 5});
    expect_near(follow(scene, 32.5), {1, 2.875, 5}); // between two frames
    expect_near(follow(scene, 40), {1, 4, 5});
    expect_near(follow(scene, 59), follow(scene, 40), 0.0);
    expect_near(follow(scene, -3), {2, 0, 5}, 0.0);
}

TEST(RigidScene, TurnsFirstAndMovesThen) {
    RigidSceneContent content = make_content();
    content.walkthrough.tracks[0].keys = {{0, {7, 0, 0}, 180.0}};
    // (2,0,5) turned half about x = 1 is (0,0,5); the translation is along the world's axis.
    expect_near(follow(RigidScene(content), 0), {7, 0, 5});
}

TEST(RigidScene, LeavesOtherObjectsAtRest) {
    const RigidScene scene(make_content());
    for (const double frame : {0.0, 15.0, 59.0}) {
        EXPECT_EQ(scene.compute_pose(frame * kStep).object_to_world[0], glm::dmat4(1.0));
    }
}

TEST(RigidScene, IsExactlyAtItsKeysOnTheirFrames) {
    RigidSceneContent content = make_content();
    content.walkthrough.tracks[0].keys = {
        {30, {0.1, 0, 0}, 0.0}, {31, {0.7, 0, 0}, 0.0}, {32, {0.3, 0, 0}, 0.0}};
    ASSERT_NE(31 * kStep / kStep, 31.0); // the quotient misses the frame by a bit
    expect_near(follow(RigidScene(content), 31), {2.7, 0, 5}, 0.0);
}

TEST(RigidScene, RestsBitForBitBetweenEqualKeys) {
    RigidSceneContent content = make_content();
    content.walkthrough.tracks[0].keys = {
        {3, {0.1, 0.2, 0.3}, 33.3}, {50, {0.1, 0.2, 0.3}, 33.3}, {51, {0, 0, 0}, 0.0}};
    const RigidScene scene(content);
    const glm::dmat4 first = scene.compute_pose(3 * kStep).object_to_world[1];
    for (int frame = 4; frame <= 50; ++frame) {
        EXPECT_EQ(scene.compute_pose(frame * kStep).object_to_world[1], first) << frame;
    }
    EXPECT_NE(scene.compute_pose(51 * kStep).object_to_world[1], first);
}

TEST(RigidScene, IsStaticUnlessATrackHasTwoPlaces) {
    RigidSceneContent content = make_content();
    EXPECT_FALSE(RigidScene(content).is_static());
    std::vector<TrackKey>& keys = content.walkthrough.tracks[0].keys;
    keys = {{0, {1, 0, 0}, 5.0}, {50, {1, 0, 0}, 5.0}};
    EXPECT_TRUE(RigidScene(content).is_static());
    keys[1].degrees = 365.0; // the same place in the end, but not on the way
    EXPECT_FALSE(RigidScene(content).is_static());
    keys = {{0, {1, 0, 0}, 5.0}};
    EXPECT_TRUE(RigidScene(content).is_static());
    expect_near(follow(RigidScene(content), 9), follow(RigidScene(content), 0), 0.0);
    content.walkthrough.tracks.clear();
    EXPECT_TRUE(RigidScene(content).is_static());
}

TEST(RigidScene, AFarOriginChangesNothingRelativeToIt) {
    RigidSceneContent content = make_content();
    content.walkthrough.cameras[5].position = {0.0, 1.0, 2.0};
    const RigidScene near_zero(content);
    content.origin = {1e7, -1e7, 1e7};
    const RigidScene far_away(content);
    EXPECT_EQ(far_away.get_walkthrough().cameras[5].position - content.origin,
              glm::dvec3(0.0, 1.0, 2.0));
    for (const double frame : {0.0, 12.0, 15.0, 20.0, 33.0, 59.0}) {
        const glm::dmat4 a = near_zero.compute_pose(frame * kStep).object_to_world[1];
        const glm::dmat4 b = far_away.compute_pose(frame * kStep).object_to_world[1];
        for (int column = 0; column < 3; ++column) {
            EXPECT_EQ(a[column], b[column]) << frame;
        }
        // A double of 1e7 holds steps of 1.9e-9.
        expect_near(glm::dvec3(b[3]) - content.origin, glm::dvec3(a[3]), 2e-9);
    }
    EXPECT_EQ(hash_geometry(near_zero, 0.0), hash_geometry(far_away, 0.0));
}

TEST(RigidScene, ATrackOfAnObjectThatIsNotThereIsRefused) {
    RigidSceneContent content = make_content();
    content.walkthrough.tracks[0].object = "mved";
    const RigidScene scene(content);
    EXPECT_THROW(check_scene(scene, "test"), InputError);
}

} // namespace
} // namespace alcove
