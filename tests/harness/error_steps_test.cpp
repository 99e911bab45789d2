// Errors in steps, on images of constant values that can be added up by hand.
#include "harness/run/error_steps.hpp"

#include <gtest/gtest.h>

namespace alcove {
namespace {

constexpr ImageSize kSize{4, 2};

Image make_constant_image(float value) {
    return Image(kSize, 1, value);
}

/// total = d1^2 + d2^2 + d3^2 and twice the cross terms.
double add_up(const StepRecord& steps) {
    return steps.d1 + steps.d2 + steps.d3 + 2.0 * (steps.d1_d2 + steps.d1_d3 + steps.d2_d3);
}

TEST(ErrorSteps, EveryMomentIsThatOfItsDifference) {
    const Image method = make_constant_image(1.0f);
    const Image converged = make_constant_image(0.75f);
    const Image march = make_constant_image(0.875f);
    const Image truth = make_constant_image(0.5f);
    const StepRecord steps = compute_steps({method, &converged, march, truth});
    EXPECT_TRUE(steps.has_converged_form);
    EXPECT_DOUBLE_EQ(steps.total, 0.25);
    EXPECT_DOUBLE_EQ(steps.d1, 0.0625);
    EXPECT_DOUBLE_EQ(steps.d2, 0.015625);
    EXPECT_DOUBLE_EQ(steps.d3, 0.140625);
    EXPECT_DOUBLE_EQ(steps.d1_d2, -0.03125);
    EXPECT_DOUBLE_EQ(steps.d1_d3, 0.09375);
    EXPECT_DOUBLE_EQ(steps.d2_d3, -0.046875);
    EXPECT_DOUBLE_EQ(add_up(steps), steps.total);
}

TEST(ErrorSteps, StepsThatCancelShowInTheCrossTerm) {
    const Image method = make_constant_image(0.5f);
    const Image march = make_constant_image(0.75f);
    const Image truth = make_constant_image(0.5f);
    const StepRecord steps = compute_steps({method, &method, march, truth});
    EXPECT_DOUBLE_EQ(steps.total, 0.0);
    EXPECT_DOUBLE_EQ(steps.d2, 0.0625);
    EXPECT_DOUBLE_EQ(steps.d3, 0.0625);
    EXPECT_DOUBLE_EQ(steps.d2_d3, -0.0625);
}

TEST(ErrorSteps, WithoutAConvergedFormTheSecondStepBeginsAtTheMethod) {
    const Image method = make_constant_image(1.0f);
    const Image march = make_constant_image(0.75f);
    const Image truth = make_constant_image(0.5f);
    const StepRecord steps = compute_steps({method, nullptr, march, truth});
    EXPECT_FALSE(steps.has_converged_form);
    EXPECT_DOUBLE_EQ(steps.d1, 0.0);
    EXPECT_DOUBLE_EQ(steps.d2, 0.0625);
    EXPECT_DOUBLE_EQ(add_up(steps), steps.total);
}

TEST(ErrorSteps, HalvesGiveTheirMeanAndItsNoise) {
    const ImageHalves halves{make_constant_image(0.25f), make_constant_image(0.75f)};
    EXPECT_FLOAT_EQ(halves.compute_mean().at(1, 1), 0.5f);
    // The standard error of a mean of two values 0.5 apart: 0.25.
    EXPECT_DOUBLE_EQ(halves.compute_noise(), 0.0625);
}

} // namespace
} // namespace alcove
