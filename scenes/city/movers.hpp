#pragma once
// What moves: vehicles on straight lanes and pedestrians. Where everything is comes from the time
// alone.

#include "scenes/city/kit.hpp"
#include "scenes/common/gait.hpp"

#include <array>
#include <cstddef>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace alcove::city {

inline constexpr double kGauge = 1.435; ///< of the tram, metres
inline constexpr double kTrackZ = 1.55; ///< axes of both tracks in the street z = 0

/// A straight way at constant speed from time 0 on until it ends; there the mover rests, so that
/// nothing ever jumps.
struct Drive {
    glm::dvec3 start{0.0};
    bool is_eastward = true; ///< towards +x, else towards -x
    double speed = 0.0;      ///< metres a second
    double length = 0.0;     ///< metres
};

/// How far the mover has come at a time, metres.
[[nodiscard]] double measure_way(const Drive& drive, double time_s);

/// Vehicles are drawn with their front towards +x.
struct Wheel {
    std::size_t object = 0;
    glm::dvec3 axle{0.0}; ///< in the vehicle
    double radius = 0.3;
};
struct Vehicle {
    std::vector<std::size_t> bodies; ///< objects
    std::vector<Wheel> wheels;
    Drive drive;
};

/// All walkers are alike.
inline constexpr WalkerBody kBody;
struct Walker {
    std::array<std::size_t, kLimbs> objects{};
    Drive drive;
    double phase = 0.0; ///< of the gait at time 0, in cycles
};

struct Movers {
    std::vector<Vehicle> vehicles;
    std::vector<Walker> walkers;
};

/// Writes the transforms of all movers' objects.
void pose_movers(const Movers& movers, double time_s, std::vector<glm::dmat4>& transforms);

} // namespace alcove::city
