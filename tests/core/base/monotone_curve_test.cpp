// Monotone regression on numbers that one can check by hand.
#include "core/base/monotone_curve.hpp"

#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

namespace alcove {
namespace {

TEST(MonotoneCurve, NeighboursThatViolateTheOrderArePooled) {
    const std::vector<double> weights{1.0, 1.0, 1.0, 1.0, 1.0};
    const std::vector<double> values{1.0, 3.0, 2.0, 4.0, 0.0};
    // 4 and 0 make 2; with 3 and 2 that makes (3 + 2 + 4 + 0) / 4 = 2.25.
    EXPECT_EQ(fit_isotonic(values, weights), (std::vector<double>{1.0, 2.25, 2.25, 2.25, 2.25}));
}

TEST(MonotoneCurve, WeightsCountInTheMeanOfAPool) {
    const std::vector<double> values{3.0, 0.0};
    const std::vector<double> weights{1.0, 2.0};
    EXPECT_EQ(fit_isotonic(values, weights), (std::vector<double>{1.0, 1.0}));
}

TEST(MonotoneCurve, ASequenceInOrderStaysAsItIs) {
    const std::vector<double> values{0.1, 0.2, 0.4};
    const std::vector<double> weights{1.0, 5.0, 1.0};
    EXPECT_EQ(fit_isotonic(values, weights), values);
}

TEST(MonotoneCurve, IsLinearBetweenItsPointsAndConstantBeyondThem) {
    const MonotoneCurve curve{{0.25, 0.75}, {0.0, 1.0}};
    EXPECT_DOUBLE_EQ(curve.evaluate(0.5), 0.5);
    EXPECT_DOUBLE_EQ(curve.evaluate(0.0), 0.0);
    EXPECT_DOUBLE_EQ(curve.evaluate(1.0), 1.0);
}

/// x at every bin's centre.
std::vector<float> make_ramp() {
    std::vector<float> ramp;
    for (int i = 0; i < CurveMoments::kBins; ++i) {
        ramp.push_back((static_cast<float>(i) + 0.5f) / CurveMoments::kBins);
    }
    return ramp;
}

template <class Function>
std::vector<float> map(const std::vector<float>& x, Function function) {
    std::vector<float> y;
    for (const float value : x) {
        y.push_back(function(value));
    }
    return y;
}

TEST(MonotoneCurve, MendsAnyMonotoneErrorWhole) {
    const std::vector<float> x = make_ramp();
    const std::vector<float> y = map(x, [](float v) { return v * v; });
    CurveMoments moments;
    moments.add(x, y);
    // The integral of (x - x^2)^2 over [0,1].
    EXPECT_NEAR(moments.compute_mse(), 1.0 / 30.0, 1e-4);
    EXPECT_NEAR(moments.compute_mse(moments.fit()), 0.0, 1e-12);
}

TEST(MonotoneCurve, CanDoNothingForAnErrorOfShape) {
    // Truth falls where the image rises: the best that never falls is constant, and leaves the
    // variance of a ramp.
    const std::vector<float> x = make_ramp();
    const std::vector<float> y = map(x, [](float v) { return 1.0f - v; });
    CurveMoments moments;
    moments.add(x, y);
    EXPECT_NEAR(moments.compute_mse(moments.fit()), 1.0 / 12.0, 1e-4);
}

TEST(MonotoneCurve, MomentsOfPartsAreThoseOfTheWhole) {
    const std::vector<float> x = make_ramp();
    const std::vector<float> y = map(x, [](float v) { return 0.5f + 0.5f * v; });
    const std::vector<float> z = map(x, [](float v) { return 0.25f * v; });
    CurveMoments whole;
    whole.add(x, y);
    whole.add(x, z);
    CurveMoments first;
    first.add(x, y);
    CurveMoments second;
    second.add(x, z);
    first.add(second);
    EXPECT_DOUBLE_EQ(first.compute_mse(), whole.compute_mse());
    EXPECT_DOUBLE_EQ(first.compute_mse(first.fit()), whole.compute_mse(whole.fit()));
    EXPECT_DOUBLE_EQ(first.count(), 2.0 * CurveMoments::kBins);
}

} // namespace
} // namespace alcove
