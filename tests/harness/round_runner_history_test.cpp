// Cold and converged (DESIGN 3.5), as a method with a history sees them and as its images show
// them.

#include "core/base/hash.hpp"
#include "tests/harness/round_runner_fixture.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

namespace alcove {
namespace {

/// Frames since the reset that each render of one replay sees, in order: a burst 0..3 with a cut at
/// 2, three singles.
constexpr std::array kColdCounts{1, 2, 1, 2, 1, 1, 1};
constexpr std::array kColdFrames{0, 1, 2, 3, 10, 20, 30};
/// DESIGN 3.5: times of 8 held frames.
constexpr int kTimedHeld = 8;

/// The method that is replayed, cut at what opens it (one warm-up frame), and those that hold their
/// converged history over all repeats.
struct Replays {
    std::vector<std::vector<HistoryEntry>> timing;    ///< cold frames of each repeat
    std::vector<HistoryEntry> capture;                ///< cold, then every single held
    std::vector<std::vector<HistoryEntry>> converged; ///< first and last single
};

std::vector<HistoryEntry> take_renders(const std::vector<HistoryEntry>& log, int instance) {
    std::vector<HistoryEntry> renders;
    std::copy_if(log.begin(), log.end(), std::back_inserter(renders),
                 [instance](const HistoryEntry& entry) {
                     return entry.event == HistoryEvent::render && entry.instance == instance;
                 });
    return renders;
}

Replays divide(const HistoryLog& log, int repeats) {
    const std::vector<HistoryEntry> renders = take_renders(log.entries, 0);
    constexpr std::size_t kCapture = kColdFrames.size() + 3 * (kHistoryWarmFrames + 1);
    EXPECT_EQ(renders.size(),
              1 + static_cast<std::size_t>(repeats) * kColdFrames.size() + kCapture);
    EXPECT_EQ(log.instances, 3);
    Replays replays;
    auto next = renders.begin() + 1;
    for (int r = 0; r < repeats; ++r) {
        replays.timing.emplace_back(next, next + kColdFrames.size());
        next += kColdFrames.size();
    }
    replays.capture.assign(next, renders.end());
    for (const int instance : {1, 2}) {
        replays.converged.push_back(take_renders(log.entries, instance));
        EXPECT_EQ(replays.converged.back().size(),
                  static_cast<std::size_t>(kHistoryWarmFrames + repeats * kTimedHeld));
    }
    return replays;
}

void expect_cold(const std::vector<HistoryEntry>& replay) {
    for (std::size_t i = 0; i < kColdFrames.size(); ++i) {
        EXPECT_EQ(replay.at(i).frame, kColdFrames.at(i)) << i;
        EXPECT_EQ(replay.at(i).count, kColdCounts.at(i)) << i;
        // What the view says and what the history holds agree.
        EXPECT_EQ(replay.at(i).history_valid, kColdCounts.at(i) > 1) << i;
        EXPECT_EQ(replay.at(i).is_held, kColdCounts.at(i) == 1) << i;
    }
}

/// From `first`: warm_frames() frames, then `shown` more, all of one held pose and starting from
/// nothing.
void expect_held(const std::vector<HistoryEntry>& replay, std::size_t first, int frame, int shown) {
    for (int i = 0; i < kHistoryWarmFrames + shown; ++i) {
        const HistoryEntry& entry = replay.at(first + static_cast<std::size_t>(i));
        EXPECT_EQ(entry.frame, frame);
        EXPECT_EQ(entry.count, i + 1);
        EXPECT_EQ(entry.history_valid, i > 0) << "only the first frame has no history";
        EXPECT_TRUE(entry.is_held);
    }
}

TEST_F(RoundRunnerTest, TimingReplaysForgetAtSegmentsAndCuts) {
    run({"history_method"});
    for (const std::vector<HistoryEntry>& replay : divide(*m_log, 2).timing) {
        expect_cold(replay);
    }
}

TEST_F(RoundRunnerTest, TheFirstAndLastSingleAreHeldOverAllRepeatsBehindOneWarmUp) {
    run({"history_method"});
    const Replays replays = divide(*m_log, 2);
    expect_held(replays.converged.at(0), 0, 10, 2 * kTimedHeld);
    expect_held(replays.converged.at(1), 0, 30, 2 * kTimedHeld);
}

TEST_F(RoundRunnerTest, TheCaptureReplayHoldsEverySingle) {
    run({"history_method"});
    const Replays replays = divide(*m_log, 2);
    expect_cold(replays.capture);
    for (int single = 0; single < 3; ++single) {
        const auto first = static_cast<std::size_t>(7 + single * (kHistoryWarmFrames + 1));
        expect_held(replays.capture, first, 10 * (single + 1), 1);
    }
}

TEST_F(RoundRunnerTest, EveryRenderGetsWhatWasDeclaredAndOneSeed) {
    run({"history_method"});
    const std::vector<HistoryEntry> renders = take_renders(log(), 0);
    for (const HistoryEntry& entry : renders) {
        EXPECT_TRUE(entry.has_motion);
        EXPECT_TRUE(entry.has_geometry);
        EXPECT_TRUE(entry.has_lights);
        EXPECT_EQ(entry.noise_seed, renders.front().noise_seed);
    }
}

TEST_F(RoundRunnerTest, ColdAndConvergedImagesAreThoseOfTheirHistories) {
    run({"history_method"});
    const auto hash_count = [](int count) {
        return to_hex(hash_image(Image({96, 72}, 1, 1.0f / static_cast<float>(count))));
    };
    std::map<std::pair<int, SampleState>, std::string> hashes;
    for (const MetricRow& row : m_result.metrics) {
        if (row.metric == "mse") {
            EXPECT_TRUE(hashes.emplace(std::pair(row.frame, row.state), row.image_hash).second)
                << "frame " << row.frame << " stands twice";
        }
    }
    ASSERT_EQ(hashes.size(), 7u + 3u);
    for (std::size_t i = 0; i < kColdFrames.size(); ++i) {
        EXPECT_EQ(hashes.at({kColdFrames.at(i), SampleState::cold}), hash_count(kColdCounts.at(i)));
    }
    for (const int single : {10, 20, 30}) {
        EXPECT_EQ(hashes.at({single, SampleState::converged}), hash_count(kHistoryWarmFrames + 1));
    }
}

TEST_F(RoundRunnerTest, ConvergedTimesHaveBothKindsInEveryRepeat) {
    run({"history_method", "template_method"}, 3);
    std::map<std::tuple<int, int, SampleKind>, int> counts;
    for (const SampleRow& row : find_samples(cell(0).id, SampleState::converged)) {
        ++counts[{row.repeat, row.frame, row.kind}];
    }
    ASSERT_EQ(counts.size(), 3u * 2u * 2u);
    for (int repeat = 0; repeat < 3; ++repeat) {
        for (const int single : {10, 30}) {
            // Half of the 8 frames each; a divided frame has a row for each of its two passes.
            EXPECT_EQ((counts[{repeat, single, SampleKind::envelope}]), kTimedHeld / 2);
            EXPECT_EQ((counts[{repeat, single, SampleKind::divided}]), kTimedHeld / 2 * 2);
        }
    }
    EXPECT_TRUE(find_samples(cell(1).id, SampleState::converged).empty())
        << "a method without history has one value that stands in both columns";
}

} // namespace
} // namespace alcove
