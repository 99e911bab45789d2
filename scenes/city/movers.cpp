#include "scenes/city/movers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace alcove::city {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

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

/// Where an ankle is, along the way and above the ground, and how far its foot points down.
struct Step {
    double x = 0.0;
    double y = Body::kAnkle;
    double pitch = 0.0; ///< radians
};

/// `cycles` walked, as seen by one leg. For `kStance` of a cycle the foot stands; then it swings to
/// its next place.
Step compute_step(double cycles) {
    constexpr double kStance = 0.62;
    const double number = std::floor(cycles);
    const double phase = cycles - number;
    // The body is over the foot in the middle of the stance.
    const double stand = (number + 0.5 * kStance) * Body::kCycle;
    Step step{stand, Body::kAnkle, 0.0};
    if (phase > kStance) {
        const double t = (phase - kStance) / (1.0 - kStance);
        const double smooth = t * t * (3.0 - 2.0 * t);
        step.x += smooth * Body::kCycle;
        step.y += 0.11 * std::sin(std::numbers::pi * t) * std::sin(std::numbers::pi * t);
        step.pitch = 0.5 * std::sin(std::numbers::pi * t) * (1.0 - 1.6 * t);
    }
    return step;
}

/// Thigh, shin and foot of one side from hip to ankle: two links and the law of cosines.
void pose_leg(const Walker& walker, std::size_t side, const glm::dmat4& frame,
              const glm::dvec3& hip, const glm::dvec3& ankle, double pitch,
              std::vector<glm::dmat4>& transforms) {
    const glm::dvec3 reach = ankle - hip;
    constexpr double a = Body::kThighLength;
    constexpr double b = Body::kShinLength;
    const double length = std::min(std::hypot(reach.x, reach.y), (a + b) * 0.9999);
    const double straight = std::atan2(reach.x, -reach.y);
    const double at_hip = std::acos((a * a + length * length - b * b) / (2.0 * a * length));
    const double thigh = straight + at_hip; // the knee points forward
    const glm::dvec3 knee = hip + a * glm::dvec3(std::sin(thigh), -std::cos(thigh), 0.0);
    const double shin = std::atan2(ankle.x - knee.x, knee.y - ankle.y);
    transforms[walker.objects[kThigh + side]] = frame * make_joint(hip, thigh);
    transforms[walker.objects[kShin + side]] = frame * make_joint(knee, shin);
    transforms[walker.objects[kFoot + side]] = frame * make_joint(ankle, -pitch);
}

void pose_walker(const Walker& walker, double time_s, std::vector<glm::dmat4>& transforms) {
    const double way = measure_way(walker.drive, time_s);
    const glm::dmat4 frame = make_mover_frame(walker.drive, way);
    const double cycles = way / Body::kCycle + walker.phase;
    // Highest when a leg stands upright, twice a cycle.
    const double hip_y = Body::kHip - 0.018 * (1.0 - std::cos(2.0 * kTurn * (cycles - 0.31)));
    const glm::dvec3 hips(0.0, hip_y, 0.0);
    transforms[walker.objects[kTorso]] = frame * make_joint(hips, -0.04);
    transforms[walker.objects[kHead]] =
        frame * make_joint(hips + glm::dvec3(0.02, Body::kNeck, 0.0), 0.0);
    for (std::size_t side = 0; side < 2; ++side) {
        const double sign = side == 0 ? -1.0 : 1.0;
        const double leg = cycles + 0.5 * static_cast<double>(side);
        const Step step = compute_step(leg);
        // The leg walked leg * kCycle; the frame is where the body is.
        const double ahead = step.x - leg * Body::kCycle;
        const double z = sign * Body::kHalfHips;
        pose_leg(walker, side, frame, hips + glm::dvec3(0.0, 0.0, z), {ahead, step.y, z},
                 step.pitch, transforms);
        // Arms swing against their legs.
        const double swing = -0.45 * std::cos(kTurn * leg);
        const glm::dvec3 shoulder =
            hips + glm::dvec3(0.02, Body::kShoulder, sign * Body::kHalfShoulders);
        const glm::dvec3 elbow =
            shoulder + Body::kUpperArmLength * glm::dvec3(std::sin(swing), -std::cos(swing), 0.0);
        transforms[walker.objects[kUpperArm + side]] = frame * make_joint(shoulder, swing);
        transforms[walker.objects[kForearm + side]] =
            frame * make_joint(elbow, swing + 0.3 + 0.2 * std::cos(kTurn * leg + 1.0));
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
