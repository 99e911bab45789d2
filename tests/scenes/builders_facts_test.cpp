// What each of the built scenes is for: the figure that it serves depends on these facts.
#include "scenes/foliage_and_vehicle/elements.hpp"
#include "scenes/molecule/fold.hpp"
#include "scenes/registry.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <gtest/gtest.h>

namespace alcove {
namespace {

std::unique_ptr<Scene> open(const std::string& name,
                            const std::vector<ParameterOverride>& overrides = {}) {
    const Registry<SceneUnit> registry = scenes_registry();
    const SceneUnit& unit = registry.find(name);
    return unit.open(unit.parameters.resolve(overrides, {}));
}

std::unique_ptr<Scene> open_finest(const std::string& name) {
    const Registry<SceneUnit> registry = scenes_registry();
    const ParameterInfo& detail = registry.find(name).parameters.find("detail");
    return open(name, {{"detail", get_extreme(detail, true)}});
}

std::size_t find_object(const Scene& scene, const std::string& name) {
    const auto objects = scene.get_objects();
    const auto found = std::find_if(objects.begin(), objects.end(),
                                    [&](const Object& object) { return object.name == name; });
    EXPECT_NE(found, objects.end()) << name;
    return static_cast<std::size_t>(found - objects.begin());
}

glm::dvec3 transform(const glm::dmat4& matrix, const glm::vec3& point) {
    return glm::dvec3(matrix * glm::dvec4(glm::dvec3(point), 1.0));
}

std::vector<glm::dvec3> list_points(const Scene& scene, std::size_t object, double time_s) {
    const glm::dmat4 matrix = scene.compute_pose(time_s).object_to_world[object];
    std::vector<glm::dvec3> points;
    for (const glm::vec3& position :
         scene.get_meshes()[scene.get_objects()[object].mesh].positions) {
        points.push_back(transform(matrix, position));
    }
    return points;
}

std::pair<double, double> find_heights(const std::vector<glm::dvec3>& points) {
    const auto [low, high] =
        std::minmax_element(points.begin(), points.end(),
                            [](const glm::dvec3& a, const glm::dvec3& b) { return a.y < b.y; });
    return {low->y, high->y};
}

TEST(PillarsInARow, KeepTheirNumberSpacingAndDiameter) {
    const auto scene =
        open("pillars_in_a_row", {{"count", "5"}, {"spacing", "0.7"}, {"diameter", "0.3"}});
    const Pose pose = scene->compute_pose(0.0);
    std::vector<double> places;
    for (std::size_t i = 0; i < scene->get_objects().size(); ++i) {
        if (scene->get_objects()[i].name.rfind("pillar#", 0) == 0) {
            places.push_back(pose.object_to_world[i][3].x);
            double widest = 0.0; // of the shaft at 1 m
            for (const glm::dvec3& point : list_points(*scene, i, 0.0)) {
                if (std::abs(point.y - 1.0) < 0.01) {
                    widest = std::max(widest, std::abs(point.z));
                }
            }
            EXPECT_NEAR(2.0 * widest, 0.3, 1e-6);
        }
    }
    ASSERT_EQ(places.size(), 5u);
    for (std::size_t i = 1; i < places.size(); ++i) {
        EXPECT_NEAR(places[i] - places[i - 1], 1.0, 1e-5);
    }
}

TEST(EdgeOnSlabs, EverySlabIsThinAndEveryKindIsSeenEdgeOn) {
    const auto scene = open("edge_on_slabs", {{"thickness", "0.004"}});
    const std::vector<Camera>& cameras = scene->get_walkthrough().cameras;
    int level = 0;
    int upright = 0;
    for (std::size_t i = 0; i < scene->get_objects().size(); ++i) {
        const std::string& name = scene->get_objects()[i].name;
        const bool is_level = name.rfind("shelf", 0) == 0;
        if (!is_level && name.rfind("fin", 0) != 0) {
            continue;
        }
        const int axis = is_level ? 1 : 0;
        double low = 1e30;
        double high = -1e30;
        for (const glm::dvec3& point : list_points(*scene, i, 0.0)) {
            low = std::min(low, point[axis]);
            high = std::max(high, point[axis]);
        }
        EXPECT_NEAR(high - low, 0.004, 1e-6) << name;
        for (std::size_t frame = 1; frame < cameras.size(); ++frame) {
            const double before = cameras[frame - 1].position[axis] - low;
            const double after = cameras[frame].position[axis] - low;
            if (before * after < 0.0) {
                (is_level ? level : upright) += 1;
            }
        }
    }
    EXPECT_GE(level, 2);
    EXPECT_GE(upright, 5);
}

/// Area of the yellow side as the camera sees it: square metres times cosine over square distance.
double measure_yellow(const Scene& scene, std::size_t object, std::size_t frame) {
    const Mesh& mesh = scene.get_meshes()[scene.get_objects()[object].mesh];
    const Walkthrough& walkthrough = scene.get_walkthrough();
    const auto points = list_points(scene, object, static_cast<double>(frame) * walkthrough.step_s);
    double sum = 0.0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::vec3& colour = mesh.colors[mesh.indices[i]];
        if (colour.z > 0.2f * colour.x) {
            continue;
        }
        const glm::dvec3& a = points[mesh.indices[i]];
        const glm::dvec3& b = points[mesh.indices[i + 1]];
        const glm::dvec3& c = points[mesh.indices[i + 2]];
        const glm::dvec3 to_eye = walkthrough.cameras[frame].position - (a + b + c) / 3.0;
        sum += std::max(0.0, 0.5 * glm::dot(glm::cross(b - a, c - a), glm::normalize(to_eye))) /
               glm::dot(to_eye, to_eye);
    }
    return sum;
}

TEST(ColourBlocks, TheYellowSideTurnsAwayMonotonically) {
    const auto scene = open("colour_blocks", {{"walkthrough", "turning"}});
    const std::size_t yellow = find_object(*scene, "yellow");
    const double first = measure_yellow(*scene, yellow, 10);
    EXPECT_GT(first, 0.05);
    double before = first;
    for (std::size_t frame = 11; frame <= 110; ++frame) {
        const double now = measure_yellow(*scene, yellow, frame);
        EXPECT_TRUE(now < before || now == 0.0) << frame;
        EXPECT_LT(before - now, 0.03 * first) << frame << ": a jump";
        before = now;
    }
    EXPECT_EQ(before, 0.0);
}

TEST(Molecule, EveryAtomIsBondedAndNoTwoAreTheSamePlace) {
    const std::vector<molecule::Atom> atoms = molecule::fold(400, 1);
    ASSERT_EQ(atoms.size(), 400u);
    for (std::size_t i = 1; i < atoms.size(); ++i) {
        double nearest = 1e30;
        for (std::size_t k = 0; k < i; ++k) {
            nearest = std::min(nearest, glm::distance(atoms[i].position, atoms[k].position));
        }
        EXPECT_NEAR(nearest, 1.5, 1e-9) << i; // bonds are shorter than all other distances
    }
}

TEST(Molecule, KeepsItsExtentWithManyAtoms) {
    for (const char* atoms : {"100", "1000"}) {
        const auto scene = open("molecule", {{"atoms", atoms}});
        double reach = 0.0;
        for (std::size_t i = 0; i < scene->get_objects().size(); ++i) {
            const glm::dmat4& place = scene->compute_pose(0.0).object_to_world[i];
            reach = std::max(reach,
                             glm::length(glm::dvec3(place[3])) + glm::length(glm::dvec3(place[0])));
        }
        EXPECT_NEAR(reach, 1.0, 1e-5) << atoms;
    }
}

/// Moller and Trumbore's test, either side.
bool hits(const glm::dvec3& from, const glm::dvec3& way, const glm::dvec3& a, const glm::dvec3& b,
          const glm::dvec3& c) {
    const glm::dvec3 p = glm::cross(way, c - a);
    const double determinant = glm::dot(b - a, p);
    if (std::abs(determinant) < 1e-12) {
        return false;
    }
    const glm::dvec3 t = from - a;
    const double u = glm::dot(t, p) / determinant;
    const glm::dvec3 q = glm::cross(t, b - a);
    const double v = glm::dot(way, q) / determinant;
    return u >= -1e-9 && v >= -1e-9 && u + v <= 1.0 + 1e-9 &&
           glm::dot(c - a, q) / determinant > 0.0;
}

TEST(ClosedRoom, NoRayLeavesIt) {
    const auto scene = open("closed_room");
    const std::size_t room = find_object(*scene, "room");
    const std::vector<glm::dvec3> points = list_points(*scene, room, 0.0);
    const Mesh& mesh = scene->get_meshes()[scene->get_objects()[room].mesh];
    const glm::dvec3 eye = scene->get_walkthrough().cameras.front().position;
    for (int i = 0; i < 500; ++i) { // a Fibonacci sphere
        const double y = 1.0 - 2.0 * (i + 0.5) / 500.0;
        const double angle = 2.4 * i;
        const double r = std::sqrt(1.0 - y * y);
        const glm::dvec3 way(r * std::cos(angle), y, r * std::sin(angle));
        bool is_hit = false;
        for (std::size_t k = 0; k < mesh.indices.size() && !is_hit; k += 3) {
            is_hit = hits(eye, way, points[mesh.indices[k]], points[mesh.indices[k + 1]],
                          points[mesh.indices[k + 2]]);
        }
        EXPECT_TRUE(is_hit) << i;
    }
}

TEST(Pebbles, AreAsHighAsTheParameterSaysAndTouchThePlane) {
    for (const double height : {0.002, 0.05}) {
        const auto scene = open("pebbles", {{"height", std::to_string(height)}, {"count", "60"}});
        for (std::size_t i = 0; i < scene->get_objects().size(); ++i) {
            if (scene->get_objects()[i].name.rfind("pebble", 0) != 0) {
                continue;
            }
            const auto [low, high] = find_heights(list_points(*scene, i, 0.0));
            EXPECT_LT(low, 0.0);
            EXPECT_GT(high, 0.45 * height); // dents take up to 0.15
            EXPECT_LT(high, 1.8 * height);
        }
    }
}

TEST(Toes, StandInTheFloorByTwoMillimetres) {
    const auto scene = open("toes");
    for (const char* foot : {"left foot", "right foot"}) {
        const auto points = list_points(*scene, find_object(*scene, foot), 0.0);
        EXPECT_NEAR(find_heights(points).first, -0.002, 2e-4) << foot;
        int touching = 0; // of heel, ball and toes; a foot that stood on one of them would have few
        for (const glm::dvec3& point : points) {
            touching += point.y < 0.0 ? 1 : 0;
        }
        EXPECT_GE(touching, 30) << foot;
    }
}

TEST(TwistedColumns, ThePinkOneIsHiddenUntilTheCameraGoesAside) {
    const auto scene = open("twisted_columns");
    const std::size_t object = find_object(*scene, "white");
    const Mesh& mesh = scene->get_meshes()[scene->get_objects()[object].mesh];
    const auto white = list_points(*scene, object, 0.0);
    const auto pink = list_points(*scene, find_object(*scene, "pink"), 0.0);
    const auto count_seen = [&](std::size_t frame) {
        const glm::dvec3& eye = scene->get_walkthrough().cameras[frame].position;
        int seen = 0;
        for (std::size_t i = 0; i < pink.size(); i += 20) {
            bool is_hit = false;
            for (std::size_t k = 0; k < mesh.indices.size() && !is_hit; k += 3) {
                is_hit = hits(eye, pink[i] - eye, white[mesh.indices[k]],
                              white[mesh.indices[k + 1]], white[mesh.indices[k + 2]]);
            }
            seen += is_hit ? 0 : 1;
        }
        return seen;
    };
    EXPECT_EQ(count_seen(0), 0);
    EXPECT_EQ(count_seen(40), 0);
    EXPECT_GT(count_seen(119), 100);
}

TEST(Rigs, OnlyTheTiltedPlaneKnowsItsTilt) {
    const auto hash = [](const char* rig, const char* tilt) {
        return hash_geometry(*open("rigs", {{"rig", rig}, {"tilt", tilt}}), 0.0);
    };
    EXPECT_NE(hash("tilt", "30"), hash("tilt", "60"));
    EXPECT_EQ(hash("tilt", "0"), hash("plane", "60"));
    EXPECT_EQ(hash("corner", "30"), hash("corner", "60"));
}

TEST(Rigs, OnlyThePlanesKnowTheirDistance) {
    const auto hash = [](const char* rig, const char* distance) {
        return hash_geometry(*open("rigs", {{"rig", rig}, {"distance", distance}}), 0.0);
    };
    EXPECT_NE(hash("tilt", "5"), hash("tilt", "20"));
    EXPECT_NE(hash("plane", "5"), hash("plane", "20"));
    EXPECT_EQ(hash("corner", "5"), hash("corner", "20"));
    EXPECT_EQ(hash("corner", "5"), hash("grazed_corner", "5"));
}

TEST(Rigs, EveryRigIsInViewOnItsFirstAndLastFrame) {
    for (const char* rig :
         {"plane", "corner", "tilt", "silhouettes", "foreground_pole", "grazed_corner"}) {
        const auto scene = open("rigs", {{"rig", rig}});
        for (const Camera* camera : {&scene->get_walkthrough().cameras.front(),
                                     &scene->get_walkthrough().cameras.back()}) {
            // The view's axis meets something, or comes within 1.5 m of a corner of it.
            const glm::dvec3 forward = -camera->world_from_view[2];
            bool is_in_view = false;
            for (std::size_t i = 0; i < scene->get_objects().size(); ++i) {
                const Mesh& mesh = scene->get_meshes()[scene->get_objects()[i].mesh];
                const std::vector<glm::dvec3> points = list_points(*scene, i, 0.0);
                for (std::size_t k = 0; k < mesh.indices.size(); k += 3) {
                    is_in_view = is_in_view ||
                                 hits(camera->position, forward, points[mesh.indices[k]],
                                      points[mesh.indices[k + 1]], points[mesh.indices[k + 2]]);
                }
                for (const glm::dvec3& point : points) {
                    is_in_view = is_in_view ||
                                 (glm::dot(point - camera->position, forward) > 0.0 &&
                                  glm::length(glm::cross(point - camera->position, forward)) < 1.5);
                }
            }
            EXPECT_TRUE(is_in_view) << rig;
        }
    }
}

TEST(Factory, HasThePublishedSizeAtItsHighestDetail) {
    const auto scene = open_finest("factory");
    constexpr double kRitschel = 537'000.0; // SSDO, table 1
    EXPECT_NEAR(static_cast<double>(count_size(*scene).triangles), kRitschel, 0.03 * kRitschel);
}

TEST(FoliageAndVehicle, HasThePublishedSizeAtItsHighestDetail) {
    const auto scene = open_finest("foliage_and_vehicle");
    constexpr double kShanmugam = 1'000'000.0; // SA07, figure 1c
    EXPECT_NEAR(static_cast<double>(count_size(*scene).triangles), kShanmugam, 0.03 * kShanmugam);
}

TEST(FoliageAndVehicle, WheelsRollWithoutSliding) {
    const auto scene = open("foliage_and_vehicle");
    for (const ObjectTrack& track : scene->get_walkthrough().tracks) {
        if (track.object.rfind("tyre#", 0) == 0) {
            const TrackKey& end = track.keys.back();
            const double turned = end.degrees * std::numbers::pi / 180.0;
            EXPECT_NEAR(-turned * foliage::kWheel, end.translation.x,
                        1e-9); // towards +x: clockwise
        }
    }
}

} // namespace
} // namespace alcove
