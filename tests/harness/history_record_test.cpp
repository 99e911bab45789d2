// What is counted and carried of a history state, on images of a few pixels.
#include "harness/run/history_record.hpp"

#include <map>

#include <gtest/gtest.h>

namespace alcove {
namespace {

void set(Image& state, int x, int y, HistoryChannel channel, float value) {
    state.at(x, y, static_cast<int>(channel)) = value;
}

/// One pixel of a state image.
struct StatePixel {
    HistoryCause cause = HistoryCause::kept;
    float convergence = 0.5f;
    float samples = 8.0f;
    bool is_surface = true;
};

Image make_row_state(const std::vector<StatePixel>& pixels) {
    Image state({static_cast<int>(pixels.size()), 1}, 4);
    for (int x = 0; x < state.width(); ++x) {
        const StatePixel& pixel = pixels[static_cast<std::size_t>(x)];
        set(state, x, 0, HistoryChannel::cause, static_cast<float>(pixel.cause));
        set(state, x, 0, HistoryChannel::convergence, pixel.convergence);
        set(state, x, 0, HistoryChannel::samples, pixel.samples);
        set(state, x, 0, HistoryChannel::surface, pixel.is_surface ? 1.0f : 0.0f);
    }
    return state;
}

std::map<std::string, double> count(const Image& state, const Image* age) {
    std::map<std::string, double> numbers;
    for (const HistoryNumber& number : count_history(state, age)) {
        EXPECT_TRUE(numbers.emplace(number.name, number.value).second) << number.name;
    }
    return numbers;
}

const StatePixel kBackground{HistoryCause::kept, 1.0f, 1000.0f, false};

TEST(CountHistory, SharesAndMeansAreOverSurfacePixels) {
    const Image state = make_row_state({{HistoryCause::kept, 1.0f, 4.0f},
                                        {HistoryCause::kept, 1.0f, 4.0f},
                                        {HistoryCause::kept, 0.5f, 8.0f},
                                        {HistoryCause::no_history, 0.1f, 32.0f},
                                        {HistoryCause::off_screen, 0.1f, 32.0f},
                                        {HistoryCause::off_screen, 0.1f, 32.0f},
                                        {HistoryCause::disocclusion, 0.1f, 32.0f},
                                        {HistoryCause::disocclusion, 0.1f, 32.0f},
                                        {HistoryCause::disocclusion, 0.2f, 16.0f},
                                        {HistoryCause::neighbourhood, 0.8f, 8.0f},
                                        kBackground,
                                        kBackground});
    Image age(state.size(), 1);
    age.at(0, 0) = 7.0f;
    age.at(1, 0) = 3.0f;
    age.at(11, 0) = 100.0f;
    std::map<std::string, double> numbers = count(state, &age);
    EXPECT_DOUBLE_EQ(numbers["history_invalidated"], 0.7);
    EXPECT_DOUBLE_EQ(numbers["history_no_history"], 0.1);
    EXPECT_DOUBLE_EQ(numbers["history_off_screen"], 0.2);
    EXPECT_DOUBLE_EQ(numbers["history_disocclusion"], 0.3);
    EXPECT_DOUBLE_EQ(numbers["history_neighbourhood"], 0.1);
    EXPECT_DOUBLE_EQ(numbers["history_converged"], 0.2);
    EXPECT_NEAR(numbers["history_convergence"], 0.4, 1e-7);
    EXPECT_DOUBLE_EQ(numbers["history_samples"], 20.0);
    EXPECT_DOUBLE_EQ(numbers["history_age"], 1.0);
}

TEST(CountHistory, EveryNumberIsDescribedAndNoOther) {
    const Image state = make_row_state({{}});
    const Image age(state.size(), 1);
    const std::map<std::string, double> numbers = count(state, &age);
    EXPECT_EQ(numbers.size(), list_history_numbers().size());
    for (const HistoryNumberInfo& info : list_history_numbers()) {
        EXPECT_TRUE(numbers.contains(info.name)) << info.name;
        EXPECT_FALSE(info.title.empty() || info.unit.empty() || info.definition.empty());
    }
    EXPECT_FALSE(count(state, nullptr).contains("history_age")) << "ages need a sequence";
}

TEST(CountHistory, SaysNothingOfABackground) {
    EXPECT_TRUE(count_history(make_row_state({kBackground, kBackground}), nullptr).empty());
}

/// Everything moves 1 pixel to the left; the right column comes into view.
Correspondence make_pan(ImageSize size) {
    Correspondence pan = make_identity_correspondence(size);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            pan.position.at(x, y, 0) += 1.0f;
        }
        pan.valid.at(size.width - 1, y) = 0.0f;
        pan.appeared.at(size.width - 1, y) = 1.0f;
    }
    return pan;
}

void expect_row(const Image& image, const std::vector<float>& expected) {
    for (int x = 0; x < image.width(); ++x) {
        EXPECT_EQ(image.at(x, 0), expected.at(static_cast<std::size_t>(x))) << x;
    }
}

class HistoryRecordTest : public testing::Test {
  protected:
    /// Three frames of a pan: the first, one that loses pixels 2 and 5, one that keeps all.
    void follow_pan() {
        const Correspondence pan = make_pan({6, 1});
        m_record.add(make_row_state(std::vector<StatePixel>(6, {HistoryCause::no_history})),
                     nullptr);
        expect_row(m_record.age(), {0, 0, 0, 0, 0, 0});
        std::vector<StatePixel> losses(6);
        losses[2] = {HistoryCause::disocclusion, 0.1f, 32.0f};
        losses[5] = {HistoryCause::off_screen, 0.1f, 32.0f};
        m_record.add(make_row_state(losses), &pan);
        expect_row(m_record.age(), {1, 1, 0, 1, 1, 0});
        m_record.add(make_row_state(std::vector<StatePixel>(6)), &pan);
    }

    HistoryRecord m_record;
};

TEST_F(HistoryRecordTest, AgesMoveWithTheirSurface) {
    follow_pan();
    // What was lost under pixel 2 stands under pixel 1 now. The last pixel was kept although it had
    // just appeared: no age to carry, so one frame.
    expect_row(m_record.age(), {2, 1, 2, 2, 1, 1});
}

TEST_F(HistoryRecordTest, SharesLeaveOutTheFirstFrameAndSamplesDoNot) {
    follow_pan();
    expect_row(m_record.compute_invalidated_share(), {0, 0, 0.5f, 0, 0, 0.5f});
    expect_row(m_record.samples(), {24, 24, 48, 24, 24, 48});
}

TEST_F(HistoryRecordTest, ResetForgetsAll) {
    follow_pan();
    m_record.reset();
    const Correspondence pan = make_pan({6, 1});
    m_record.add(make_row_state(std::vector<StatePixel>(6)), &pan);
    expect_row(m_record.age(), {0, 0, 0, 0, 0, 0});
    expect_row(m_record.samples(), {8, 8, 8, 8, 8, 8});
    expect_row(m_record.compute_invalidated_share(), {0, 0, 0, 0, 0, 0});
}

TEST_F(HistoryRecordTest, TheBackgroundHasNoAgeAndLosesNothing) {
    const std::vector<StatePixel> pixels{{}, {HistoryCause::disocclusion, 0, 0, false}};
    const Correspondence still = make_identity_correspondence({2, 1});
    m_record.add(make_row_state(pixels), nullptr);
    m_record.add(make_row_state(pixels), &still);
    m_record.add(make_row_state(pixels), &still);
    expect_row(m_record.age(), {2, 0});
    expect_row(m_record.compute_invalidated_share(), {0, 0});
}

/// A state whose first channel is 10 x row + column, rows from the top.
Image make_numbered_state(ImageSize size) {
    Image state(size, 4);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            state.at(x, y, 0) = static_cast<float>(10 * y + x);
            state.at(x, y, 3) = 1.0f;
        }
    }
    return state;
}

void expect_fitted(ImageSize state, ImageSize size, const std::vector<std::vector<int>>& rows) {
    const Image fitted = fit_history_state(make_numbered_state(state), size);
    ASSERT_EQ(fitted.size(), size);
    ASSERT_EQ(fitted.channels(), 4);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            EXPECT_EQ(fitted.at(x, y, 0),
                      static_cast<float>(
                          rows.at(static_cast<std::size_t>(y)).at(static_cast<std::size_t>(x))))
                << x << ", " << y;
            EXPECT_EQ(fitted.at(x, y, 3), 1.0f);
        }
    }
}

TEST(FitHistoryState, FullSizeIsTheStateItself) {
    expect_fitted({3, 2}, {3, 2}, {{0, 1, 2}, {10, 11, 12}});
}

TEST(FitHistoryState, ABorderIsCutOffAllRound) {
    expect_fitted({5, 6}, {3, 2}, {{21, 22, 23}, {31, 32, 33}});
}

TEST(FitHistoryState, HalfSizeRepeatsTexelsFromTheBottomLeft) {
    expect_fitted({2, 2}, {4, 4}, {{0, 0, 1, 1}, {0, 0, 1, 1}, {10, 10, 11, 11}, {10, 10, 11, 11}});
    // Textures begin at the bottom left: the texel that covers one row stands at the top, the one
    // that covers one column on the right.
    expect_fitted({3, 3}, {5, 5},
                  {{0, 0, 1, 1, 2},
                   {10, 10, 11, 11, 12},
                   {10, 10, 11, 11, 12},
                   {20, 20, 21, 21, 22},
                   {20, 20, 21, 21, 22}});
}

TEST(FitHistoryState, HalfSizeWithABorder) {
    // 5 x 4 pixels with one more all round are 7 x 6; half of that, rounded up, 4 x 3.
    expect_fitted(
        {4, 3}, {5, 4},
        {{0, 1, 1, 2, 2}, {10, 11, 11, 12, 12}, {10, 11, 11, 12, 12}, {20, 21, 21, 22, 22}});
    // An odd height: 7 rows in 4 texels, the topmost of which is border alone.
    expect_fitted({4, 4}, {5, 5},
                  {{10, 11, 11, 12, 12},
                   {10, 11, 11, 12, 12},
                   {20, 21, 21, 22, 22},
                   {20, 21, 21, 22, 22},
                   {30, 31, 31, 32, 32}});
}

} // namespace
} // namespace alcove
