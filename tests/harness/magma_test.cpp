// The published colours at the published entries.

#include "harness/run/magma.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace alcove {
namespace {

std::array<int, 3> look_up(float value) {
    const Image map = make_magma_map(Image({1, 1}, 1, value));
    const auto code = [&map](int c) {
        return static_cast<int>(std::lround(255.0f * map.at(0, 0, c)));
    };
    return {code(0), code(1), code(2)};
}

TEST(Magma, EntriesAreThoseOfThePublishedTable) {
    // Its rows 0, 128 and 255 are (0.001462, 0.000466, 0.013866), (0.716387, 0.214982, 0.475290)
    // and (0.987053, 0.991438, 0.749504).
    EXPECT_EQ(look_up(0.0f), (std::array{0, 0, 4}));
    EXPECT_EQ(look_up(128.0f / 255.0f), (std::array{183, 55, 121}));
    EXPECT_EQ(look_up(1.0f), (std::array{252, 253, 191}));
}

TEST(Magma, TheEntryIsTheNearestAndValuesAreClamped) {
    EXPECT_EQ(look_up(127.6f / 255.0f), look_up(128.0f / 255.0f));
    EXPECT_NE(look_up(127.4f / 255.0f), look_up(128.0f / 255.0f));
    EXPECT_EQ(look_up(-1.0f), look_up(0.0f));
    EXPECT_EQ(look_up(7.0f), look_up(1.0f));
}

TEST(Magma, LuminanceRisesFromEntryToEntry) {
    double last = -1.0;
    for (int i = 0; i < 256; ++i) {
        const std::array<int, 3> code = look_up(static_cast<float>(i) / 255.0f);
        const double luma = 0.2126 * code[0] + 0.7152 * code[1] + 0.0722 * code[2];
        EXPECT_GT(luma, last - 0.8) << i; // rounded to 8 bits
        last = luma;
    }
}

} // namespace
} // namespace alcove
