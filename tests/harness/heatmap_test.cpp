// What colours say: the ends of scales, their order, and that no two meanings share one.
#include "core/base/history_state.hpp"
#include "harness/run/heatmap.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace alcove {
namespace {

using Color = std::array<float, 3>;

Color get_color(const Image& map, int x = 0) {
    return {map.at(x, 0, 0), map.at(x, 0, 1), map.at(x, 0, 2)};
}

constexpr Color kBlack{0.0f, 0.0f, 0.0f};
constexpr Color kWhite{1.0f, 1.0f, 1.0f};

/// CIE L* of sRGB codes.
double compute_lightness(const Color& codes) {
    constexpr std::array kLuminance{0.2126, 0.7152, 0.0722};
    double luminance = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
        const auto code = static_cast<double>(codes.at(c));
        luminance += kLuminance.at(c) *
                     (code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4));
    }
    return luminance > 0.008856 ? 116.0 * std::cbrt(luminance) - 16.0 : 903.3 * luminance;
}

Image make_row(const std::vector<float>& values) {
    Image row({static_cast<int>(values.size()), 1}, 1);
    for (std::size_t i = 0; i < values.size(); ++i) {
        row.values()[i] = values[i];
    }
    return row;
}

TEST(ScaleMap, RunsFromBlackToWhiteAndStaysThere) {
    const Image map = make_scale_map(make_row({-1.0f, 0.0f, 0.25f, 5.0f}), 0.25f);
    EXPECT_EQ(get_color(map, 0), kBlack);
    EXPECT_EQ(get_color(map, 1), kBlack);
    EXPECT_EQ(get_color(map, 2), kWhite);
    EXPECT_EQ(get_color(map, 3), kWhite);
}

TEST(ScaleMap, LightnessRisesAllAlongAndAboutEvenly) {
    constexpr int kSteps = 256;
    std::vector<float> values;
    for (int i = 0; i <= kSteps; ++i) {
        values.push_back(static_cast<float>(i) / kSteps);
    }
    const Image map = make_scale_map(make_row(values), 1.0f);
    for (int i = 1; i <= kSteps; ++i) {
        EXPECT_GT(compute_lightness(get_color(map, i)), compute_lightness(get_color(map, i - 1)))
            << i;
        // Off an even scale by less than a tenth of its length.
        EXPECT_NEAR(compute_lightness(get_color(map, i)), 100.0 * i / kSteps, 10.0) << i;
    }
}

/// One pixel's colour on the age map.
Color color_age(float age, float convergence, bool is_surface) {
    Image state({1, 1}, 4);
    state.at(0, 0, static_cast<int>(HistoryChannel::convergence)) = convergence;
    state.at(0, 0, static_cast<int>(HistoryChannel::surface)) = is_surface ? 1.0f : 0.0f;
    return get_color(make_age_map(make_row({age}), state));
}

TEST(AgeMap, IsRedWhereHistoryWasJustLostAndDarkensToBlack) {
    const Color red = color_age(0.0f, 0.1f, true);
    EXPECT_EQ(red[0], 1.0f);
    EXPECT_LT(red[1], 0.2f);
    EXPECT_LT(red[2], 0.2f);
    for (int age = 1; age <= static_cast<int>(kAgeOfBlack); ++age) {
        EXPECT_LT(compute_lightness(color_age(static_cast<float>(age), 0.5f, true)),
                  compute_lightness(color_age(static_cast<float>(age - 1), 0.5f, true)))
            << age;
    }
    EXPECT_EQ(color_age(kAgeOfBlack, 0.9f, true), kBlack);
    EXPECT_EQ(color_age(10.0f * kAgeOfBlack, 0.9f, true), kBlack);
}

TEST(AgeMap, IsWhereConvergedWhiteAndGreyOnTheBackground) {
    EXPECT_EQ(color_age(0.0f, 1.0f, true), kWhite);
    EXPECT_EQ(color_age(kAgeOfBlack, 1.0f, true), kWhite);
    const Color grey = color_age(3.0f, 1.0f, false);
    EXPECT_EQ(grey[0], grey[1]);
    EXPECT_EQ(grey[1], grey[2]);
    EXPECT_NEAR(grey[0], 0.5f, 0.1f);
}

TEST(CauseMap, EveryCauseAndTheBackgroundHaveAColorOfTheirOwn) {
    constexpr int kCauses = static_cast<int>(kHistoryCauseNames.size());
    Image state({kCauses + 1, 1}, 4);
    for (int cause = 0; cause < kCauses; ++cause) {
        state.at(cause, 0, static_cast<int>(HistoryChannel::cause)) = static_cast<float>(cause);
        state.at(cause, 0, static_cast<int>(HistoryChannel::surface)) = 1.0f;
    }
    const Image map = make_cause_map(state);
    std::set<Color> colors;
    for (int x = 0; x <= kCauses; ++x) {
        colors.insert(get_color(map, x));
    }
    EXPECT_EQ(colors.size(), kHistoryCauseNames.size() + 1);
    EXPECT_EQ(get_color(map, static_cast<int>(HistoryCause::kept)), kWhite);
    EXPECT_EQ(get_color(map, kCauses), kBlack);
    const Color lost = get_color(map, static_cast<int>(HistoryCause::disocclusion));
    EXPECT_GT(lost[0], lost[1] + lost[2]) << "red";
    const Color outside = get_color(map, static_cast<int>(HistoryCause::off_screen));
    EXPECT_GT(outside[2], std::max(outside[0], outside[1])) << "blue";
}

} // namespace
} // namespace alcove
