#include "scenes/common/gait.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

/// Turned in the walker's (x, y) plane: a limb that hangs down swings forward.
glm::dmat4 make_joint(const glm::dvec3& place, double radians) {
    glm::dmat4 joint(1.0);
    joint[0] = {std::cos(radians), std::sin(radians), 0.0, 0.0};
    joint[1] = {-std::sin(radians), std::cos(radians), 0.0, 0.0};
    joint[3] = glm::dvec4(place, 1.0);
    return joint;
}

/// Around +y, from x towards -z.
glm::dmat4 make_turn(double radians) {
    glm::dmat4 turn(1.0);
    turn[0] = {std::cos(radians), 0.0, -std::sin(radians), 0.0};
    turn[2] = {std::sin(radians), 0.0, std::cos(radians), 0.0};
    return turn;
}

glm::dmat4 make_shift(const glm::dvec3& offset) {
    glm::dmat4 shift(1.0);
    shift[3] = glm::dvec4(offset, 1.0);
    return shift;
}

/// Thigh and shin of one side from hip to ankle: two links and the law of cosines, in the plane
/// through both and the walker's x axis.
void pose_leg(const WalkerBody& body, std::size_t side, const glm::dmat4& frame,
              const glm::dvec3& hip, const glm::dvec3& ankle, WalkPose& pose) {
    const glm::dvec3 reach = ankle - hip;
    const double a = body.thigh_length;
    const double b = body.shin_length;
    // The plane leans sideways around x; it stands upright where hip and ankle have equal z.
    const double down = std::hypot(reach.y, reach.z);
    const double length = std::min(std::hypot(reach.x, down), (a + b) * 0.9999);
    const double straight = std::atan2(reach.x, down);
    const double at_hip = std::acos((a * a + length * length - b * b) / (2.0 * a * length));
    const double thigh = straight + at_hip; // the knee points forward
    glm::dmat4 plane(1.0);
    plane[1] = {0.0, -reach.y / down, -reach.z / down, 0.0};
    plane[2] = {0.0, reach.z / down, -reach.y / down, 0.0};
    const glm::dvec3 up(plane[1]);
    const glm::dvec3 knee =
        hip + a * (glm::dvec3(std::sin(thigh), 0.0, 0.0) - std::cos(thigh) * up);
    const double shin = std::atan2(ankle.x - knee.x, glm::dot(knee - ankle, up));
    const auto place_joint = [&](const glm::dvec3& place, double radians) {
        glm::dmat4 joint = plane * make_joint(glm::dvec3(0.0), radians);
        joint[3] = glm::dvec4(place, 1.0);
        return frame * joint;
    };
    pose[kThigh + side] = place_joint(hip, thigh);
    pose[kShin + side] = place_joint(knee, shin);
}

/// The foot of one side in the walker's frame, `ahead` metres along the way.
glm::dmat4 place_foot(const Step& step, double ahead, double z, double curvature) {
    if (curvature == 0.0) {
        return make_joint({ahead, step.y, z}, -step.pitch);
    }
    const double radius = 1.0 / curvature;
    return make_shift({0.0, 0.0, -radius}) * make_turn(ahead * curvature) *
           make_joint({0.0, step.y, radius + z}, -step.pitch);
}

} // namespace

Step compute_step(const WalkerBody& body, double cycles) {
    const double number = std::floor(cycles);
    const double phase = cycles - number;
    // The body is over the foot in the middle of the stance.
    const double stand = (number + 0.5 * kStance) * body.cycle;
    Step step{stand, body.ankle, 0.0};
    if (phase > kStance) {
        const double t = (phase - kStance) / (1.0 - kStance);
        const double smooth = t * t * (3.0 - 2.0 * t);
        step.x += smooth * body.cycle;
        step.y += 0.11 * std::sin(std::numbers::pi * t) * std::sin(std::numbers::pi * t);
        step.pitch = 0.5 * std::sin(std::numbers::pi * t) * (1.0 - 1.6 * t);
    }
    return step;
}

WalkPose pose_walk(const WalkerBody& body, double cycles, const glm::dmat4& frame,
                   double curvature) {
    WalkPose pose;
    // Highest when a leg stands upright, twice a cycle.
    const double hip_y = body.hip - 0.018 * (1.0 - std::cos(2.0 * kTurn * (cycles - 0.31)));
    const glm::dvec3 hips(0.0, hip_y, 0.0);
    pose[kTorso] = frame * make_joint(hips, -0.04);
    pose[kHead] = frame * make_joint(hips + glm::dvec3(0.02, body.neck, 0.0), 0.0);
    for (std::size_t side = 0; side < 2; ++side) {
        const double sign = side == 0 ? -1.0 : 1.0;
        const double leg = cycles + 0.5 * static_cast<double>(side);
        const Step step = compute_step(body, leg);
        // The leg walked leg * cycle; the frame is where the body is.
        const double ahead = step.x - leg * body.cycle;
        const double z = sign * body.half_hips;
        const glm::dmat4 foot = place_foot(step, ahead, z, curvature);
        pose[kFoot + side] = frame * foot;
        pose_leg(body, side, frame, hips + glm::dvec3(0.0, 0.0, z), glm::dvec3(foot[3]), pose);
        // Arms swing against their legs.
        const ArmSwing& arm = body.arms[side];
        const double swing = arm.mean - arm.swing * std::cos(kTurn * leg);
        const glm::dvec3 shoulder =
            hips + glm::dvec3(0.02, body.shoulder, sign * body.half_shoulders);
        const glm::dvec3 elbow =
            shoulder + body.upper_arm_length * glm::dvec3(std::sin(swing), -std::cos(swing), 0.0);
        pose[kUpperArm + side] = frame * make_joint(shoulder, swing);
        pose[kForearm + side] =
            frame *
            make_joint(elbow, swing + arm.elbow + arm.elbow_swing * std::cos(kTurn * leg + 1.0));
    }
    return pose;
}

WalkPose pose_rest(const WalkerBody& body) {
    WalkPose pose;
    const glm::dvec3 hips(0.0, body.thigh_length + body.shin_length + body.ankle, 0.0);
    pose[kTorso] = make_shift(hips);
    pose[kHead] = make_shift(hips + glm::dvec3(0.02, body.neck, 0.0));
    for (std::size_t side = 0; side < 2; ++side) {
        const double sign = side == 0 ? -1.0 : 1.0;
        const glm::dvec3 hip = hips + glm::dvec3(0.0, 0.0, sign * body.half_hips);
        const glm::dvec3 knee = hip - glm::dvec3(0.0, body.thigh_length, 0.0);
        const glm::dvec3 shoulder =
            hips + glm::dvec3(0.02, body.shoulder, sign * body.half_shoulders);
        pose[kThigh + side] = make_shift(hip);
        pose[kShin + side] = make_shift(knee);
        pose[kFoot + side] = make_shift(knee - glm::dvec3(0.0, body.shin_length, 0.0));
        pose[kUpperArm + side] = make_shift(shoulder);
        pose[kForearm + side] = make_shift(shoulder - glm::dvec3(0.0, body.upper_arm_length, 0.0));
    }
    return pose;
}

glm::dmat4 place_on_circle(const CircleWalk& walk, double time_s) {
    const double sign = walk.is_leftward ? 1.0 : -1.0;
    const double angle = walk.start + sign * walk.speed * time_s / walk.radius;
    return make_shift(walk.centre) * make_turn(angle) * make_shift({0.0, 0.0, sign * walk.radius});
}

double count_cycles(const CircleWalk& walk, const WalkerBody& body, double time_s) {
    return walk.phase + walk.speed * time_s / body.cycle;
}

} // namespace alcove
