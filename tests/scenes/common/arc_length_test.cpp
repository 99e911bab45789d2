#include "scenes/common/arc_length.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace alcove {
namespace {

/// Length of y = x^2 from 0 to x, in closed form.
double measure_parabola(double x) {
    return 0.5 * x * std::sqrt(1.0 + 4.0 * x * x) + 0.25 * std::asinh(2.0 * x);
}

TEST(ArcLength, IsThatOfAParabola) {
    const std::vector<double> knots{0.0, 0.1, 3.0};
    const ArcLength way([](double x) { return std::sqrt(1.0 + 4.0 * x * x); }, knots);
    EXPECT_NEAR(way.total() / measure_parabola(3.0), 1.0, 1e-9);
    for (const double x : {0.0, 0.05, 0.1, 0.7, 1.9, 2.999, 3.0}) {
        const double length = std::min(measure_parabola(x), way.total());
        EXPECT_NEAR(way.find_parameter(length), x, 1e-8) << x;
    }
    EXPECT_EQ(way.find_parameter(0.0), 0.0);
    EXPECT_EQ(way.find_parameter(way.total()), 3.0);
}

TEST(ArcLength, GetsOverACusp) {
    // The speed of (t^2, t^3) is 0 at t = 0 and has a corner there; length in closed form.
    const auto speed = [](double t) { return std::abs(t) * std::sqrt(4.0 + 9.0 * t * t); };
    const auto measure = [](double t) { return (std::pow(4.0 + 9.0 * t * t, 1.5) - 8.0) / 27.0; };
    const std::vector<double> knots{-1.0, 0.7};
    const ArcLength way(speed, knots);
    EXPECT_NEAR(way.total() / (measure(1.0) + measure(0.7)), 1.0, 1e-9);
    EXPECT_NEAR(way.find_parameter(measure(1.0)), 0.0, 1e-4); // length grows as t^2 there
    EXPECT_NEAR(way.find_parameter(measure(1.0) - measure(0.5)), -0.5, 1e-8);
}

} // namespace
} // namespace alcove
