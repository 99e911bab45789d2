#pragma once
// How figures walk: feet that stay where they stand, legs of two links, arms that swing against
// them. Where every limb is follows from the way that was walked, i.e. from the time alone.

#include <array>
#include <cstddef>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace alcove {

/// Limbs hang down from their joint at zero; the walker looks towards +x, its right is +z.
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

/// Radians.
struct ArmSwing {
    double mean = 0.0; ///< of the upper arm, forward
    double swing = 0.45;
    double elbow = 0.3; ///< mean
    double elbow_swing = 0.2;
};

/// Proportions of a walker, metres.
struct WalkerBody {
    double hip = 0.905; ///< mean height
    double thigh_length = 0.44;
    double shin_length = 0.43;
    double ankle = 0.08;   ///< height over the sole
    double shoulder = 0.5; ///< over the hip
    double neck = 0.58;    ///< over the hip
    double upper_arm_length = 0.29;
    double half_hips = 0.09;
    double half_shoulders = 0.21;
    double cycle = 1.1;             ///< way of two steps
    std::array<ArmSwing, 2> arms{}; ///< left, right
};

/// Where an ankle is, along the way and above the ground, and how far its foot points down.
struct Step {
    double x = 0.0;     ///< metres
    double y = 0.0;     ///< metres
    double pitch = 0.0; ///< radians
};

/// Of a cycle, each foot stands for this much; then it swings to its next place.
inline constexpr double kStance = 0.62;

/// `cycles` walked, as seen by one leg.
[[nodiscard]] Step compute_step(const WalkerBody& body, double cycles);

using WalkPose = std::array<glm::dmat4, kLimbs>;
/// From each limb to where `frame` leads, which takes the walker to there: +x is the way, y = 0 the
/// ground. The way may be an arc that turns left (towards -z) by `curvature` radians a metre.
/// The frame is where the body is after `cycles`: along its way it must advance by body.cycle a
/// cycle, or feet slide.
[[nodiscard]] WalkPose pose_walk(const WalkerBody& body, double cycles, const glm::dmat4& frame,
                                 double curvature = 0.0);

/// Limbs of a body that stands straight with hanging arms, hips at thigh + shin + ankle.
[[nodiscard]] WalkPose pose_rest(const WalkerBody& body);

/// An endless walk around a circle at constant speed.
struct CircleWalk {
    glm::dvec3 centre{0.0};
    double radius = 1.0;     ///< metres
    bool is_leftward = true; ///< else the walker turns right
    double start = 0.0;      ///< radians around +y from +z at time 0
    double phase = 0.0;      ///< of the gait at time 0, in cycles
    double speed = 1.0;      ///< metres a second

    [[nodiscard]] double curvature() const { return (is_leftward ? 1.0 : -1.0) / radius; }
};
[[nodiscard]] glm::dmat4 place_on_circle(const CircleWalk& walk, double time_s);
/// Cycles walked at a time, the phase included.
[[nodiscard]] double count_cycles(const CircleWalk& walk, const WalkerBody& body, double time_s);

} // namespace alcove
