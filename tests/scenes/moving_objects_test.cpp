#include "scenes/moving_objects/moving_objects.hpp"

#include "tests/scenes/solid_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <gtest/gtest.h>

namespace alcove {
namespace {

constexpr std::size_t kFrames = 120;

std::unique_ptr<Scene> open(const std::string& walkthrough) {
    const SceneUnit unit = moving_objects_unit();
    const std::vector<ParameterOverride> overrides{{"walkthrough", walkthrough}};
    return unit.open(unit.parameters.resolve(overrides, {}));
}

bool is_same(const Camera& a, const Camera& b) {
    return a.position == b.position && a.world_from_view == b.world_from_view &&
           a.fov_y_radians == b.fov_y_radians;
}

Pose pose_at(const Scene& scene, std::size_t frame) {
    return scene.compute_pose(static_cast<double>(frame) * scene.get_walkthrough().step_s);
}

/// Names of the objects that are not at the same place on two frames.
std::set<std::string> list_moved(const Scene& scene, std::size_t a, std::size_t b) {
    const Pose first = pose_at(scene, a);
    const Pose second = pose_at(scene, b);
    std::set<std::string> moved;
    for (std::size_t i = 0; i < first.object_to_world.size(); ++i) {
        if (first.object_to_world[i] != second.object_to_world[i]) {
            moved.insert(scene.get_objects()[i].name);
        }
    }
    return moved;
}

class MovingObjects : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(All, MovingObjects,
                         testing::Values("clip", "shake", "zoom", "aba", "teleport", "cut"),
                         [](const auto& tested) { return std::string(tested.param); });

TEST_P(MovingObjects, HasTheFramesAndTheNameThatWasAskedFor) {
    const std::unique_ptr<Scene> scene = open(GetParam());
    EXPECT_EQ(scene->get_walkthrough().name, GetParam());
    EXPECT_EQ(scene->get_walkthrough().cameras.size(), kFrames);
    EXPECT_FALSE(scene->get_walkthrough().events.empty());
    EXPECT_NO_THROW(check_scene(*scene, "moving_objects"));
    const std::string name = GetParam();
    EXPECT_EQ(scene->is_static(), name != "clip" && name != "teleport");
}

TEST(MovingObjectsClip, EverythingMovesAtOnceAndRestsAtBothEnds) {
    const std::unique_ptr<Scene> scene = open("clip");
    const std::set<std::string> all{"spinner", "bar",        "passing box",
                                    "vase",    "lifted box", "wall box"};
    EXPECT_EQ(list_moved(*scene, 30, 31), all);
    for (std::size_t frame = 0; frame < 15; ++frame) {
        EXPECT_TRUE(list_moved(*scene, frame, frame + 1).empty()) << frame;
    }
    for (std::size_t frame = 105; frame + 1 < kFrames; ++frame) {
        EXPECT_TRUE(list_moved(*scene, frame, frame + 1).empty()) << frame;
    }
    const std::vector<Camera>& cameras = scene->get_walkthrough().cameras;
    for (const Camera& camera : cameras) {
        EXPECT_TRUE(is_same(camera, cameras[0]));
    }
}

TEST(MovingObjectsClip, NoTwoObjectsRunIntoEachOther) {
    const std::unique_ptr<Scene> scene = open("clip");
    for (std::size_t frame = 0; frame < kFrames; ++frame) {
        const Pose pose = pose_at(*scene, frame);
        struct Box {
            glm::dvec3 low{1e9};
            glm::dvec3 high{-1e9};
        };
        std::vector<Box> boxes;
        for (std::size_t i = 0; i < pose.object_to_world.size(); ++i) {
            boxes.emplace_back();
            for (const glm::vec3& p : scene->get_meshes()[scene->get_objects()[i].mesh].positions) {
                const glm::dvec3 place(pose.object_to_world[i] * glm::dvec4(glm::dvec3(p), 1.0));
                boxes[i].low = glm::min(boxes[i].low, place);
                boxes[i].high = glm::max(boxes[i].high, place);
            }
        }
        for (std::size_t i = 2; i < boxes.size(); ++i) { // beside floor and wall
            for (std::size_t k = i + 1; k < boxes.size(); ++k) {
                const bool apart = glm::any(glm::greaterThan(boxes[i].low, boxes[k].high)) ||
                                   glm::any(glm::greaterThan(boxes[k].low, boxes[i].high));
                EXPECT_TRUE(apart) << frame << ": " << scene->get_objects()[i].name << " and "
                                   << scene->get_objects()[k].name;
            }
        }
    }
}

TEST(MovingObjectsShake, FollowsTheDocumentedRule) {
    // README.md: sums of sines with whole cycles in the clip.
    const auto wave = [](double cycles, std::size_t frame, double phase) {
        return std::sin(2.0 * std::numbers::pi * cycles * static_cast<double>(frame) / kFrames +
                        phase);
    };
    const std::unique_ptr<Scene> scene = open("shake");
    const glm::dvec3 stand(0.0, 1.95, 4.3);
    const glm::dvec3 look(0.0, 0.75, -0.8);
    for (std::size_t f = 0; f < kFrames; ++f) {
        const glm::dvec3 position =
            stand + glm::dvec3(0.006 * wave(7, f, 0), 0.006 * wave(11, f, 1), 0.0);
        const glm::dvec3 target =
            look + glm::dvec3(0.05 * wave(9, f, 2) + 0.02 * wave(23, f, 0),
                              0.04 * wave(8, f, 0) + 0.02 * wave(19, f, 3), 0.0);
        const Camera& camera = scene->get_walkthrough().cameras[f];
        EXPECT_LT(glm::distance(camera.position, position), 2e-6) << f;
        EXPECT_LT(glm::distance(-camera.world_from_view[2], glm::normalize(target - position)),
                  2e-6)
            << f;
    }
}

TEST(MovingObjectsShake, MovesThePictureByAFewPixels) {
    const std::unique_ptr<Scene> scene = open("shake");
    const std::vector<Camera>& cameras = scene->get_walkthrough().cameras;
    double largest = 0.0;
    for (std::size_t f = 1; f < kFrames; ++f) {
        const double cosine =
            glm::dot(cameras[f].world_from_view[2], cameras[f - 1].world_from_view[2]);
        const double pixel = cameras[f].fov_y_radians / 288.0; // of the default size
        const double moved = std::acos(std::min(1.0, cosine)) / pixel;
        EXPECT_GT(moved, 0.0) << f;
        largest = std::max(largest, moved);
    }
    EXPECT_GT(largest, 1.0);
    EXPECT_LT(largest, 5.0);
}

TEST(MovingObjectsZoom, GoesFromSixtyToFifteenDegreesInTwelveFrames) {
    const std::unique_ptr<Scene> scene = open("zoom");
    const std::vector<Camera>& cameras = scene->get_walkthrough().cameras;
    const auto degrees = [&](std::size_t frame) {
        return cameras[frame].fov_y_radians * 180.0 / std::numbers::pi;
    };
    for (std::size_t f = 0; f < kFrames; ++f) {
        EXPECT_EQ(cameras[f].position, cameras[0].position);
        EXPECT_EQ(cameras[f].world_from_view, cameras[0].world_from_view);
        if (f <= 39 || f >= 92) {
            EXPECT_NEAR(degrees(f), 60.0, 1e-9) << f;
        } else if (f >= 51 && f <= 80) {
            EXPECT_NEAR(degrees(f), 15.0, 1e-9) << f;
        } else {
            EXPECT_EQ(degrees(f) < degrees(f - 1), f <= 51) << f;
        }
    }
}

TEST(MovingObjectsAba, ComesBackToABitForBit) {
    const std::unique_ptr<Scene> scene = open("aba");
    const std::vector<Camera>& cameras = scene->get_walkthrough().cameras;
    for (std::size_t f = 0; f < kFrames; ++f) {
        const bool at_a = f <= 20 || f >= 100;
        EXPECT_EQ(is_same(cameras[f], cameras[0]), at_a) << f;
        EXPECT_EQ(is_same(cameras[f], cameras[55]), f >= 55 && f <= 65) << f;
    }
    EXPECT_GT(glm::distance(cameras[0].position, cameras[55].position), 2.0);
}

TEST(MovingObjectsTeleport, OneBoxJumpsByTwoMetresAndBack) {
    const std::unique_ptr<Scene> scene = open("teleport");
    for (std::size_t f = 1; f < kFrames; ++f) {
        const std::set<std::string> moved = list_moved(*scene, f - 1, f);
        EXPECT_EQ(moved.size(), f == 40 || f == 80 ? 1u : 0u) << f;
    }
    EXPECT_TRUE(list_moved(*scene, 0, 119).empty());
    const Pose before = pose_at(*scene, 39);
    const Pose after = pose_at(*scene, 40);
    double jump = 0.0;
    for (std::size_t i = 0; i < before.object_to_world.size(); ++i) {
        jump = std::max(jump, glm::distance(glm::dvec3(before.object_to_world[i][3]),
                                            glm::dvec3(after.object_to_world[i][3])));
    }
    EXPECT_NEAR(jump, 2.0, 1e-12);
}

TEST(MovingObjectsCut, StandsAtTwoPlaces) {
    const std::unique_ptr<Scene> scene = open("cut");
    const Walkthrough& walkthrough = scene->get_walkthrough();
    EXPECT_EQ(walkthrough.cuts, (std::vector<int>{0, 60}));
    for (std::size_t f = 0; f < kFrames; ++f) {
        EXPECT_TRUE(is_same(walkthrough.cameras[f], walkthrough.cameras[f < 60 ? 0 : 119])) << f;
    }
    EXPECT_GT(glm::distance(walkthrough.cameras[0].position, walkthrough.cameras[119].position),
              2.0);
}

TEST(MovingObjectsStage, IsMadeOfClosedSolids) {
    const std::unique_ptr<Scene> scene = open("clip");
    for (const Mesh& mesh : scene->get_meshes()) {
        const SolidCheck check = check_solid(mesh);
        EXPECT_EQ(check.open_edges, 0u) << mesh.name;
        EXPECT_GT(check.volume, 0.01) << mesh.name;
    }
}

} // namespace
} // namespace alcove
