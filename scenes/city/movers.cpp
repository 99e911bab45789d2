#include "scenes/city/movers.hpp"

#include <algorithm>
#include <cmath>

namespace alcove::city {
namespace {

/// From the mover to the city: +x is the way.
glm::dmat4 make_mover_frame(const Drive& drive, double way) {
    const double sign = drive.is_eastward ? 1.0 : -1.0;
    return make_frame(drive.start + glm::dvec3(sign * way, 0.0, 0.0), drive.is_eastward ? 0 : 2);
}

/// Turned in the mover's (x, y) plane: a limb that hangs down swings forward.
glm::dmat4 make_joint(const glm::dvec3& place, double radians) {
    glm::dmat4 joint(1.0);
    joint[0] = {std::cos(radians), std::sin(radians), 0.0, 0.0};
    joint[1] = {-std::sin(radians), std::cos(radians), 0.0, 0.0};
    joint[3] = glm::dvec4(place, 1.0);
    return joint;
}

void pose_vehicle(const Vehicle& vehicle, double time_s, std::vector<glm::dmat4>& transforms) {
    const double way = measure_way(vehicle.drive, time_s);
    const glm::dmat4 frame = make_mover_frame(vehicle.drive, way);
    for (const std::size_t body : vehicle.bodies) {
        transforms[body] = frame;
    }
    for (const Wheel& wheel : vehicle.wheels) {
        transforms[wheel.object] = frame * make_joint(wheel.axle, -way / wheel.radius);
    }
}

void pose_walker(const Walker& walker, double time_s, std::vector<glm::dmat4>& transforms) {
    const double way = measure_way(walker.drive, time_s);
    const WalkPose pose =
        pose_walk(kBody, way / kBody.cycle + walker.phase, make_mover_frame(walker.drive, way));
    for (std::size_t limb = 0; limb < kLimbs; ++limb) {
        transforms[walker.objects[limb]] = pose[limb];
    }
}

} // namespace

double measure_way(const Drive& drive, double time_s) {
    return std::clamp(drive.speed * time_s, 0.0, drive.length);
}

void pose_movers(const Movers& movers, double time_s, std::vector<glm::dmat4>& transforms) {
    for (const Vehicle& vehicle : movers.vehicles) {
        pose_vehicle(vehicle, time_s, transforms);
    }
    for (const Walker& walker : movers.walkers) {
        pose_walker(walker, time_s, transforms);
    }
}

} // namespace alcove::city
