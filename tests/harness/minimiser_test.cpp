// The search on functions whose minimum is known.
#include "harness/tune/minimiser.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace alcove {
namespace {

double bowl(const std::vector<double>& p) {
    return 1.0 + (p[0] - 0.3) * (p[0] - 0.3) + 4.0 * (p[1] - 0.8) * (p[1] - 0.8);
}

TEST(Minimiser, FindsTheBottomOfABowl) {
    const Minimum found = minimise(2, {60, 1}, bowl);
    const CostEvaluation& best = found.history[found.best];
    EXPECT_NEAR(best.point[0], 0.3, 0.02);
    EXPECT_NEAR(best.point[1], 0.8, 0.01);
    EXPECT_LE(found.history.size(), 60u);
}

TEST(Minimiser, TheBestOfTheHistoryIsWhatItSays) {
    const Minimum found = minimise(2, {30, 3}, bowl);
    for (const CostEvaluation& evaluation : found.history) {
        EXPECT_GE(evaluation.cost, found.history[found.best].cost);
        EXPECT_DOUBLE_EQ(evaluation.cost, bowl(evaluation.point));
    }
}

TEST(Minimiser, TheGridFindsTheDeeperOfTwoValleys) {
    // A search alone, begun in the middle, would end in the shallow valley at 0.4.
    const auto valleys = [](const std::vector<double>& p) {
        return std::min(0.5 + 10.0 * std::abs(p[0] - 0.4), 20.0 * std::abs(p[0] - 0.93));
    };
    const Minimum found = minimise(1, {40, 1}, valleys);
    EXPECT_NEAR(found.history[found.best].point[0], 0.93, 0.005);
}

TEST(Minimiser, AMinimumOnTheBorderIsReached) {
    const Minimum found =
        minimise(2, {60, 2}, [](const std::vector<double>& p) { return p[0] - p[1]; });
    EXPECT_NEAR(found.history[found.best].cost, -1.0, 0.01);
    for (const CostEvaluation& evaluation : found.history) {
        for (const double place : evaluation.point) {
            EXPECT_TRUE(place >= 0.0 && place <= 1.0);
        }
    }
}

TEST(Minimiser, SeedsMoveTheGridAndNothingElse) {
    const Minimum a = minimise(2, {20, 1}, bowl);
    const Minimum again = minimise(2, {20, 1}, bowl);
    const Minimum b = minimise(2, {20, 2}, bowl);
    ASSERT_EQ(a.history.size(), again.history.size());
    for (std::size_t i = 0; i < a.history.size(); ++i) {
        EXPECT_EQ(a.history[i].point, again.history[i].point);
    }
    EXPECT_NE(a.history[0].point, b.history[0].point);
}

TEST(Minimiser, GridsTakeAtMostHalfOfTheEvaluations) {
    EXPECT_EQ(count_grid_points(1, 24), 12);
    EXPECT_EQ(count_grid_points(2, 48), 4);
    EXPECT_EQ(count_grid_points(3, 72), 3);
    EXPECT_EQ(count_grid_points(4, 96), 2);
    // Two points along each axis as long as they fit at all.
    EXPECT_EQ(count_grid_points(4, 16), 2);
    EXPECT_EQ(count_grid_points(4, 8), 1);
}

TEST(Minimiser, ErrorsOfTheCostComeThroughTheLibrary) {
    int calls = 0;
    const auto failing = [&](const std::vector<double>& p) -> double {
        if (++calls > 10) {
            throw InputError("planted");
        }
        return bowl(p);
    };
    EXPECT_THROW(static_cast<void>(minimise(2, {16, 1}, failing)), InputError);
}

} // namespace
} // namespace alcove
