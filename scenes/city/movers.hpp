#pragma once
// What moves: vehicles on straight lanes and pedestrians. Where everything is comes from the time
// alone.

#include "scenes/city/kit.hpp"

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

/// Limbs hang down from their joint at zero; the walker looks towards +x.
enum Limb : std::size_t {
    kTorso, ///< from the hip's height
    kHead,
    kUpperArm, ///< left; the right one follows
    kForearm = kUpperArm + 2,
    kThigh = kForearm + 2,
    kShin = kThigh + 2,
    kFoot = kShin + 2,
    kLimbs = kFoot + 2,
};
/// Of all walkers, metres.
struct Body {
    static constexpr double kHip = 0.905; ///< mean height
    static constexpr double kThighLength = 0.44;
    static constexpr double kShinLength = 0.43;
    static constexpr double kAnkle = 0.08;   ///< height over the sole
    static constexpr double kShoulder = 0.5; ///< over the hip
    static constexpr double kNeck = 0.58;    ///< over the hip
    static constexpr double kUpperArmLength = 0.29;
    static constexpr double kHalfHips = 0.09;
    static constexpr double kHalfShoulders = 0.21;
    static constexpr double kCycle = 1.1; ///< way of two steps
};
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
