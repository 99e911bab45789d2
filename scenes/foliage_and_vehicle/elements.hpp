#pragma once
// The elements of the scene and what they share.

#include "scenes/common/scene_kit.hpp"

#include <string>
#include <vector>

namespace alcove::foliage {

// The road runs along x; y = 0 is the ground beside it. Metres.
inline constexpr double kRoadHalf = 2.2;
inline constexpr double kRoad = 0.03; ///< height of its surface
/// Solids that meet reach this deep into each other: no two faces in one plane.
inline constexpr double kSink = 0.04;

/// How fine things are, and what the seed chooses.
struct Settings {
    double detail = 1.0;
    int seed = 1;

    /// Of a curve that has `at_one` segments at detail 1: grows with its root.
    [[nodiscard]] int segments(int at_one) const;
    /// Of leaves and blades: grows with detail.
    [[nodiscard]] int count(int at_one) const;
};

void add_ground(SceneKit& kit, const Settings& settings);
void add_trees(SceneKit& kit, const Settings& settings);

inline constexpr double kWheel = 0.33; ///< radius
/// Where a car is that moves: its wheels turn about their axles, which lie along z.
struct Car {
    std::vector<std::string> bodies; ///< objects that only move on
    struct Wheel {
        std::vector<std::string> parts;
        glm::dvec3 axle{0.0};
    };
    std::vector<Wheel> wheels;
};
/// On the road about `x`, towards +x.
[[nodiscard]] Car add_car(SceneKit& kit, const Settings& settings, double x);

} // namespace alcove::foliage
