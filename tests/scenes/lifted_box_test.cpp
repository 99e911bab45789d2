#include "scenes/lifted_box/lifted_box.hpp"

#include "tests/scenes/solid_check.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace alcove {
namespace {

std::unique_ptr<Scene> open(const std::string& motion, const std::string& speed) {
    const SceneUnit unit = lifted_box_unit();
    const std::vector<ParameterOverride> overrides{{"motion", motion}, {"speed", speed}};
    return unit.open(unit.parameters.resolve(overrides, {}));
}

std::size_t find_object(const Scene& scene, const std::string& name) {
    const auto objects = scene.get_objects();
    const auto found = std::find_if(objects.begin(), objects.end(),
                                    [&](const Object& object) { return object.name == name; });
    EXPECT_NE(found, objects.end()) << name;
    return static_cast<std::size_t>(found - objects.begin());
}

/// Place of the box against its place at rest, in AO radii, on every frame.
std::vector<glm::dvec3> follow_box(const Scene& scene) {
    const std::size_t box = find_object(scene, "box");
    const Walkthrough& walkthrough = scene.get_walkthrough();
    std::vector<glm::dvec3> places;
    const glm::dvec4 rest = scene.compute_pose(0.0).object_to_world[box][3];
    for (std::size_t frame = 0; frame < walkthrough.cameras.size(); ++frame) {
        const double time_s = static_cast<double>(frame) * walkthrough.step_s;
        places.emplace_back((scene.compute_pose(time_s).object_to_world[box][3] - rest) /
                            scene.get_ao_radius_m());
    }
    return places;
}

int find_event(const Scene& scene, const std::string& label) {
    for (const WalkthroughEvent& event : scene.get_walkthrough().events) {
        if (event.label == label) {
            return event.frame;
        }
    }
    return -1;
}

struct Case {
    const char* motion;
    const char* speed;
    double step;      ///< in radii a frame
    double way;       ///< in radii, at the end of the motion or of the clip
    int arrival;      ///< event, -1 for none within the clip
    int back_arrival; ///< likewise
};

class LiftedBox : public testing::TestWithParam<Case> {};
// By hand: 1.6 / 0.2 = 8 frames, 1.6 / 1.5 and 4 / 1.5 rounded up, 4 / 0.2 = 20; the slow ones have
// 61 frames for their 80 and 200.
INSTANTIATE_TEST_SUITE_P(All, LiftedBox,
                         testing::Values(Case{"lift", "slow", 0.02, 1.22, -1, -1},
                                         Case{"lift", "medium", 0.2, 1.6, 66, 106},
                                         Case{"lift", "fast", 1.5, 1.6, 60, 100},
                                         Case{"slide", "slow", 0.02, 1.22, -1, -1},
                                         Case{"slide", "medium", 0.2, 4.0, 78, 118},
                                         Case{"slide", "fast", 1.5, 4.0, 61, 101}),
                         [](const auto& tested) {
                             return std::string(tested.param.motion) + "_" + tested.param.speed;
                         });

TEST_P(LiftedBox, MovesAtItsSpeedInRadiiAFrame) {
    const Case& c = GetParam();
    const std::vector<glm::dvec3> places = follow_box(*open(c.motion, c.speed));
    ASSERT_EQ(places.size(), 120u);
    const glm::dvec3 direction =
        std::string(c.motion) == "lift" ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    for (std::size_t frame = 0; frame < 98; ++frame) {
        const double steps = std::max(0.0, static_cast<double>(frame) - 58.0);
        const double expected = std::min(c.way, steps * c.step);
        EXPECT_LT(glm::distance(places[frame], expected * direction), 1e-9) << frame;
    }
    const double largest = glm::length(*std::max_element(
        places.begin(), places.end(),
        [](const glm::dvec3& a, const glm::dvec3& b) { return glm::length(a) < glm::length(b); }));
    EXPECT_NEAR(largest, c.way, 1e-9);
}

TEST_P(LiftedBox, RestsBeforeAndAfterBitForBit) {
    const Case& c = GetParam();
    const std::unique_ptr<Scene> scene = open(c.motion, c.speed);
    const std::vector<glm::dvec3> places = follow_box(*scene);
    const auto expect_rest = [&places](int first, int last, const glm::dvec3& place) {
        for (int frame = first; frame <= last; ++frame) {
            EXPECT_EQ(places[static_cast<std::size_t>(frame)], place) << frame;
        }
    };
    expect_rest(0, 58, glm::dvec3(0.0));
    EXPECT_EQ(find_event(*scene, "box rests"), c.arrival);
    EXPECT_EQ(find_event(*scene, "box is back"), c.back_arrival);
    if (c.back_arrival > 0) {
        EXPECT_EQ(find_event(*scene, "box comes back"), 98);
        expect_rest(c.arrival, 98, places[static_cast<std::size_t>(c.arrival)]);
        expect_rest(c.back_arrival, 119, glm::dvec3(0.0));
    } else {
        EXPECT_EQ(find_event(*scene, "box comes back"), -1);
        if (c.arrival > 0) {
            expect_rest(c.arrival, 119, places[119]);
        }
        EXPECT_GT(glm::length(places[119]), 1.0);
    }
    EXPECT_FALSE(scene->is_static());
    EXPECT_NO_THROW(check_scene(*scene, "lifted_box"));
}

TEST_P(LiftedBox, StaysOverTheFloor) {
    const std::unique_ptr<Scene> scene = open(GetParam().motion, GetParam().speed);
    for (const glm::dvec3& place : follow_box(*scene)) {
        EXPECT_LT(std::abs(place.x * scene->get_ao_radius_m()), 2.5);
    }
}

TEST(LiftedBoxScene, TheBoxTouchesTheFloorAtRestAndIsFreeOnceItMoves) {
    const std::unique_ptr<Scene> scene = open("lift", "slow");
    const auto find_y = [&](const std::string& name, double frame, bool top) {
        const std::size_t object = find_object(*scene, name);
        const Mesh& mesh = scene->get_meshes()[scene->get_objects()[object].mesh];
        const glm::dmat4 matrix =
            scene->compute_pose(frame * scene->get_walkthrough().step_s).object_to_world[object];
        double best = top ? -1e9 : 1e9;
        for (const glm::vec3& position : mesh.positions) {
            const double y = (matrix * glm::dvec4(glm::dvec3(position), 1.0)).y;
            best = top ? std::max(best, y) : std::min(best, y);
        }
        return best;
    };
    const double floor_top = find_y("floor", 0, true);
    EXPECT_EQ(floor_top, 0.0);
    // In contact: sunk by some millimetres, so that no two faces share a plane.
    EXPECT_LT(find_y("box", 0, false), floor_top - 0.001);
    EXPECT_GT(find_y("box", 0, false), floor_top - 0.01);
    EXPECT_GT(find_y("box", 59, false), floor_top + 0.001);
    EXPECT_NEAR(find_y("box", 0, true), 1.0, 1e-6);
}

TEST(LiftedBoxScene, TheCameraStandsStill) {
    const std::unique_ptr<Scene> scene = open("slide", "fast");
    const std::vector<Camera>& cameras = scene->get_walkthrough().cameras;
    for (const Camera& camera : cameras) {
        EXPECT_EQ(camera.position, cameras[0].position);
        EXPECT_EQ(camera.world_from_view, cameras[0].world_from_view);
        EXPECT_EQ(camera.fov_y_radians, cameras[0].fov_y_radians);
    }
}

TEST(LiftedBoxScene, IsMadeOfClosedSolids) {
    const std::unique_ptr<Scene> scene = open("lift", "medium");
    for (const Mesh& mesh : scene->get_meshes()) {
        const SolidCheck check = check_solid(mesh);
        EXPECT_EQ(check.open_edges, 0u) << mesh.name;
        EXPECT_GT(check.volume, 0.01) << mesh.name;
    }
}

} // namespace
} // namespace alcove
