#include "scenes/common/gait.hpp"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace alcove {
namespace {

TEST(Gait, AFootStandsForItsShareOfACycleAndGetsACycleFurther) {
    const WalkerBody body;
    for (const double phase : {0.0, 0.3, 0.61}) {
        EXPECT_DOUBLE_EQ(compute_step(body, 4.0 + phase).x, (4.0 + 0.5 * kStance) * body.cycle);
        EXPECT_EQ(compute_step(body, 4.0 + phase).y, body.ankle);
    }
    EXPECT_GT(compute_step(body, 4.81).y, body.ankle + 0.1);
    EXPECT_NEAR(compute_step(body, 4.999999).x, compute_step(body, 5.0).x, 1e-6);
}

class GaitOnCircle : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Senses, GaitOnCircle, testing::Bool(),
                         [](const auto& tested) { return tested.param ? "Left" : "Right"; });

TEST_P(GaitOnCircle, LimbsHangTogetherAndStandingFeetStay) {
    const WalkerBody body;
    CircleWalk walk;
    walk.radius = 2.0;
    walk.is_leftward = GetParam();
    walk.start = 0.4;
    const auto pose_at = [&](double time_s) {
        return pose_walk(body, count_cycles(walk, body, time_s), place_on_circle(walk, time_s),
                         walk.curvature());
    };
    for (double time_s = 0.0; time_s < 3.0; time_s += 0.02) {
        const WalkPose pose = pose_at(time_s);
        const WalkPose later = pose_at(time_s + 0.004);
        for (std::size_t side = 0; side < 2; ++side) {
            const auto place = [&](std::size_t limb, double below) {
                return glm::dvec3(pose[limb + side] * glm::dvec4(0.0, -below, 0.0, 1.0));
            };
            EXPECT_LT(glm::distance(place(kThigh, body.thigh_length), place(kShin, 0.0)), 1e-9);
            // At the end of the stance the leg is stretched to its limit.
            EXPECT_LT(glm::distance(place(kShin, body.shin_length), place(kFoot, 0.0)), 0.01);
            EXPECT_LT(glm::distance(place(kUpperArm, body.upper_arm_length), place(kForearm, 0.0)),
                      1e-9);
            const double cycles =
                count_cycles(walk, body, time_s) + 0.5 * static_cast<double>(side);
            if (cycles - std::floor(cycles) < kStance - 0.01) {
                for (int column = 0; column < 4; ++column) {
                    EXPECT_LT(
                        glm::distance(pose[kFoot + side][column], later[kFoot + side][column]),
                        1e-12);
                }
            }
        }
    }
}

TEST_P(GaitOnCircle, TurnsTheWayItSays) {
    CircleWalk walk;
    walk.radius = 2.0;
    walk.is_leftward = GetParam();
    const glm::dmat4 now = place_on_circle(walk, 0.0);
    const glm::dmat4 next = place_on_circle(walk, 0.01);
    const glm::dvec3 way(next[3] - now[3]);
    EXPECT_NEAR(glm::length(way), 0.01, 1e-6);
    EXPECT_NEAR(glm::dot(way, glm::dvec3(now[0])), 0.01, 1e-6);
    EXPECT_EQ(glm::dot(glm::dvec3(next[0]), glm::dvec3(now[2])) < 0.0, GetParam());
}

} // namespace
} // namespace alcove
