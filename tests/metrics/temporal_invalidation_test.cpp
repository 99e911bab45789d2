// missed_invalidation and false_invalidation where truth and causes are planted column by column.
#include "core/base/history_state.hpp"
#include "tests/metrics/temporal_sequences.hpp"

#include <array>

namespace alcove {
namespace {

/// Whether a point was seen one frame ago.
enum class Past { seen, appeared, edge, background };

struct Column {
    Past past = Past::seen;
    double change = 0.0; ///< of truth
    HistoryCause cause = HistoryCause::kept;
    bool is_missed = false; ///< what the maps must say
    bool is_false = false;
};

constexpr std::array kColumns{
    // Stale: 3 of 7 with a history are kept.
    Column{Past::appeared, 0.0, HistoryCause::kept, true, false},
    Column{Past::appeared, 0.0, HistoryCause::disocclusion, false, false},
    Column{Past::appeared, 0.0, HistoryCause::off_screen, false, false},
    Column{Past::seen, 0.1, HistoryCause::kept, true, false},
    Column{Past::seen, -0.03, HistoryCause::kept, true, false},
    Column{Past::seen, -0.1, HistoryCause::neighbourhood, false, false},
    Column{Past::seen, 0.1, HistoryCause::disocclusion, false, false},
    // Good: 3 of 5 with a history are lost.
    Column{Past::seen, 0.0, HistoryCause::kept, false, false},
    Column{Past::seen, 0.009, HistoryCause::kept, false, false},
    Column{Past::seen, 0.0, HistoryCause::neighbourhood, false, true},
    Column{Past::seen, -0.009, HistoryCause::disocclusion, false, true},
    Column{Past::seen, 0.0, HistoryCause::off_screen, false, true},
    // Left out: nothing to keep, between the thresholds, edges, background.
    Column{Past::appeared, 0.0, HistoryCause::no_history, false, false},
    Column{Past::seen, 0.1, HistoryCause::no_history, false, false},
    Column{Past::seen, 0.0, HistoryCause::no_history, false, false},
    Column{Past::seen, 0.015, HistoryCause::kept, false, false},
    Column{Past::seen, -0.015, HistoryCause::disocclusion, false, false},
    Column{Past::edge, 0.1, HistoryCause::kept, false, false},
    Column{Past::edge, 0.0, HistoryCause::disocclusion, false, false},
    Column{Past::background, 0.0, HistoryCause::kept, false, false},
    Column{Past::background, 0.0, HistoryCause::disocclusion, false, false},
};
/// So high that one row of disagreeing halves is little noise.
constexpr int kRows = 200;
constexpr ImageSize kSize{static_cast<int>(kColumns.size()), kRows};

void set_cause(PlantedFrame& frame, int x, int y, HistoryCause cause) {
    frame.history_state->at(x, y, static_cast<int>(HistoryChannel::cause)) =
        static_cast<float>(cause);
}

/// A frame and, behind it, one with the columns.
std::vector<PlantedFrame> plant_columns() {
    std::vector<PlantedFrame> frames(2, make_planted_frame(kSize, PlantedMotion::still));
    PlantedFrame& last = frames.back();
    for (PlantedFrame& frame : frames) {
        frame.history_state = Image(kSize, 4);
    }
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            const Column& column = kColumns.at(static_cast<std::size_t>(x));
            last.reference.at(x, y) += static_cast<float>(column.change);
            last.to_previous.valid.at(x, y) = column.past == Past::seen ? 1.0f : 0.0f;
            last.to_previous.appeared.at(x, y) = column.past == Past::appeared ? 1.0f : 0.0f;
            last.surface.at(x, y) = column.past == Past::background ? 0.0f : 1.0f;
            set_cause(last, x, y, column.cause);
        }
    }
    return frames;
}

MetricResult get_share(const std::string& name, const std::vector<PlantedFrame>& frames,
                       const std::vector<ParameterOverride>& overrides = {}) {
    return follow_planted(*make_temporal(name, overrides), frames).back().value();
}

TEST(Invalidation, SharesAreThoseCountedByHand) {
    const auto frames = plant_columns();
    const MetricResult missed = get_share("missed_invalidation", frames);
    const MetricResult lost = get_share("false_invalidation", frames);
    EXPECT_DOUBLE_EQ(*missed.value, 3.0 / 7.0);
    EXPECT_DOUBLE_EQ(*lost.value, 3.0 / 5.0);
    for (int x = 0; x < kSize.width; ++x) {
        const Column& column = kColumns.at(static_cast<std::size_t>(x));
        for (int y = 0; y < kSize.height; ++y) {
            EXPECT_EQ(missed.map->at(x, y), column.is_missed ? 1.0f : 0.0f) << x;
            EXPECT_EQ(lost.map->at(x, y), column.is_false ? 1.0f : 0.0f) << x;
        }
    }
}

TEST(Invalidation, ThresholdsMoveWhatCounts) {
    const auto frames = plant_columns();
    // With 0.014 the kept column of 0.015 and the lost one of -0.015 count as changed too.
    EXPECT_DOUBLE_EQ(*get_share("missed_invalidation", frames, {{"change", "0.014"}}).value,
                     4.0 / 9.0);
    // With 0.05 the kept column of -0.03 does not.
    EXPECT_DOUBLE_EQ(*get_share("missed_invalidation", frames, {{"change", "0.05"}}).value,
                     2.0 / 6.0);
    // With 0.02 both columns of 0.015 count as unchanged; with 0.005 those of 0.009 do not.
    EXPECT_DOUBLE_EQ(*get_share("false_invalidation", frames, {{"change", "0.02"}}).value,
                     4.0 / 7.0);
    EXPECT_DOUBLE_EQ(*get_share("false_invalidation", frames, {{"change", "0.005"}}).value,
                     2.0 / 3.0);
}

TEST(Invalidation, ChangeCountsOnlyWhereBothHalvesAgree) {
    auto frames = plant_columns();
    for (PlantedFrame& frame : frames) {
        frame.reference_a = frame.reference;
        frame.reference_b = frame.reference;
    }
    EXPECT_DOUBLE_EQ(*get_share("missed_invalidation", frames).value, 3.0 / 7.0);
    // In one row columns 3, 5 and 6 stay changed by 0.1 in the mean; in 3 one half says the
    // opposite, in 5 one half says less than half of it, in 6 just more.
    const auto set_halves = [&](int x, float a, float b) {
        frames.back().reference_a->at(x, 0) = 0.5f + a;
        frames.back().reference_b->at(x, 0) = 0.5f + b;
    };
    set_halves(3, 0.3f, -0.1f);
    set_halves(5, -0.151f, -0.049f);
    set_halves(6, 0.149f, 0.051f);
    EXPECT_DOUBLE_EQ(*get_share("missed_invalidation", frames).value,
                     (3.0 * kRows - 1.0) / (7.0 * kRows - 2.0));
    EXPECT_DOUBLE_EQ(*get_share("false_invalidation", frames).value, 3.0 / 5.0)
        << "unsure is not unchanged";
}

TEST(Invalidation, NoiseOfTheReferenceIsNoChange) {
    // Most means differ by more than `change`, none by four standard deviations: uniform noise
    // ends at 2 x sqrt 3 of them.
    std::vector<PlantedFrame> frames(2, make_planted_frame(kSize, PlantedMotion::still));
    frames.back().history_state = Image(kSize, 4);
    for (int t = 0; t < 2; ++t) {
        add_reference_noise(frames[static_cast<std::size_t>(t)], 0.05, 40, t);
    }
    const MetricResult result = get_share("missed_invalidation", frames);
    EXPECT_FALSE(result.value.has_value());
    EXPECT_NE(result.undefined_reason.find("changes at 0 points"), std::string::npos)
        << result.undefined_reason;
}

TEST(Invalidation, AFewChangedPixelsAreNoShare) {
    const auto frames = plant_columns();
    const std::string all = std::to_string(7 * kRows);
    EXPECT_TRUE(
        get_share("missed_invalidation", frames, {{"least_pixels", all}}).value.has_value());
    const MetricResult few =
        get_share("missed_invalidation", frames, {{"least_pixels", std::to_string(7 * kRows + 1)}});
    EXPECT_FALSE(few.value.has_value());
    EXPECT_NE(few.undefined_reason.find(all), std::string::npos) << few.undefined_reason;
}

TEST(Invalidation, HasNoResultWithoutHistoryStateAndOnFirstFrames) {
    for (const char* name : {"missed_invalidation", "false_invalidation"}) {
        const auto metric = make_temporal(name);
        auto frames = plant_columns();
        EXPECT_FALSE(follow_planted(*metric, frames).front().has_value()) << name;
        frames.back().history_state.reset();
        EXPECT_FALSE(follow_planted(*metric, frames).back().has_value()) << name;
    }
}

TEST(Invalidation, IsUndefinedWhereNothingIsAsked) {
    auto frames = plant_columns();
    const auto expect_undefined = [&](const char* name, const std::string& reason) {
        const MetricResult result = get_share(name, frames);
        EXPECT_FALSE(result.value.has_value()) << name;
        EXPECT_NE(result.undefined_reason.find(reason), std::string::npos)
            << result.undefined_reason;
    };
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            set_cause(frames.back(), x, y, HistoryCause::no_history);
        }
    }
    expect_undefined("missed_invalidation", "changes at 0 points with a history");
    expect_undefined("false_invalidation", "stays at 0 points with a history");
}

} // namespace
} // namespace alcove
