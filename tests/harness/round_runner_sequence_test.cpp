// What a round measures and keeps of its burst as a sequence, and against what.

#include "harness/run/history_record.hpp"
#include "tests/harness/round_runner_fixture.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <tuple>

namespace alcove {
namespace {

constexpr const char* kWithHistory = "tssao:history_cap=64";

class RoundRunnerSequenceTest : public RoundRunnerTest {
  protected:
    static bool is_temporal(const std::string& metric) {
        static const Registry<MetricUnit> kMetrics = get_units().metrics;
        return std::any_of(kMetrics.units().begin(), kMetrics.units().end(),
                           [&metric](const MetricUnit& unit) {
                               return unit.name == metric && unit.is_temporal();
                           });
    }
    /// Frames with a row of this metric, of one method's cell.
    std::set<int> list_frames(std::size_t method, const std::string& metric,
                              SampleState state = SampleState::cold) const {
        std::set<int> frames;
        for (const MetricRow& row : m_result.metrics) {
            if (row.cell == cell(method).id && row.metric == metric && row.state == state) {
                EXPECT_TRUE(frames.insert(row.frame).second) << metric << " stands twice";
            }
        }
        return frames;
    }
    const MetricRow& find_row(std::size_t method, const std::string& metric, int frame,
                              SampleState state = SampleState::cold) const {
        const auto row =
            std::find_if(m_result.metrics.begin(), m_result.metrics.end(), [&](const auto& it) {
                return it.cell == cell(method).id && it.metric == metric && it.frame == frame &&
                       it.state == state;
            });
        EXPECT_NE(row, m_result.metrics.end()) << metric << " of frame " << frame;
        return *row;
    }
    /// Picture -> frames that have it, of one cell.
    std::map<std::string, std::set<int>> list_pictures(const std::string& id) const {
        std::map<std::string, std::set<int>> pictures;
        const std::filesystem::path images = m_folder.path() / "images" / round().id / id;
        for (const auto& entry : std::filesystem::directory_iterator(images)) {
            const std::string name = entry.path().stem().string();
            pictures[name.substr(name.find('_') + 1)].insert(std::stoi(name));
        }
        return pictures;
    }
};

using Frames = std::set<int>;

TEST_F(RoundRunnerSequenceTest, MetricsOverTimeAreOfTheBurstWithoutItsFirstFrames) {
    run({kWithHistory, "template_method"}, 1);
    for (const std::size_t method : {0u, 1u}) {
        // Frame 2 is a cut: a sequence of 0 and 1, another of 2 and 3.
        for (const char* metric : {"temporal_flicker", "flicker_ratio", "trail_energy"}) {
            EXPECT_EQ(list_frames(method, metric), (Frames{1, 3})) << metric;
        }
        EXPECT_EQ(list_frames(method, "recovery_frames"), (Frames{1, 3})) << "last frames";
        EXPECT_EQ(list_frames(method, "lag_share"), Frames{}) << "8 frames are needed";
    }
    EXPECT_EQ(list_frames(0, "missed_invalidation"), (Frames{1, 3}));
    EXPECT_EQ(list_frames(1, "missed_invalidation"), Frames{}) << "no history, no cause";
    for (const MetricRow& row : m_result.metrics) {
        if (is_temporal(row.metric)) {
            EXPECT_TRUE(row.frame == 1 || row.frame == 3) << row.metric << " of " << row.frame;
            EXPECT_EQ(row.state, SampleState::cold);
            EXPECT_TRUE(row.value.has_value() || !row.note.empty()) << row.metric;
        }
    }
    EXPECT_GT(m_result.done.temporal_s, 0.0);
}

TEST_F(RoundRunnerSequenceTest, HistoryIsToldOfMethodsThatHaveOne) {
    run({"template_method", kWithHistory}, 1);
    for (const HistoryNumberInfo& number : list_history_numbers()) {
        EXPECT_EQ(list_frames(0, number.name), Frames{});
        EXPECT_EQ(list_frames(0, number.name, SampleState::converged), Frames{});
        EXPECT_EQ(list_frames(1, number.name), (Frames{0, 1, 2, 3})) << number.name;
        // Ages need a sequence.
        EXPECT_EQ(list_frames(1, number.name, SampleState::converged),
                  number.name == "history_age" ? Frames{} : (Frames{10, 20, 30}));
    }
    for (const int begin : {0, 2}) {
        EXPECT_EQ(find_row(1, "history_no_history", begin).value, 1.0);
        EXPECT_EQ(find_row(1, "history_invalidated", begin).value, 1.0);
        EXPECT_EQ(find_row(1, "history_age", begin).value, 0.0);
        EXPECT_EQ(find_row(1, "history_no_history", begin + 1).value, 0.0);
        EXPECT_GT(find_row(1, "history_age", begin + 1).value, 0.5) << "most of it was kept";
    }
    for (const int single : {10, 20, 30}) {
        EXPECT_GT(find_row(1, "history_converged", single, SampleState::converged).value, 0.99);
    }
}

TEST_F(RoundRunnerSequenceTest, TheFilmHasEveryFrameOfItsBurstAndNoOther) {
    m_films_burst = true;
    run({kWithHistory, "template_method"}, 1);
    const Frames all{0, 1, 2, 3};
    const Frames behind_the_first{1, 3};
    const Frames singles{10, 20, 30};
    const std::map<std::string, std::set<int>> both{
        {"film_visibility", all},
        {"film_error", all},
        {"film_temporal_flicker", behind_the_first},
        {"accumulated_flicker_p95", behind_the_first},
        {"accumulated_profile", behind_the_first},
        {"visibility", singles},
        {"error", singles},
        {"shaded", singles},
    };
    EXPECT_EQ(list_pictures(cell(1).id), both);
    std::map<std::string, std::set<int>> with_history = both;
    for (const char* picture : {"film_age", "film_cause", "film_convergence", "film_samples"}) {
        with_history[picture] = all;
    }
    for (const char* picture : {"film_missed_invalidation", "film_false_invalidation",
                                "accumulated_invalidations", "accumulated_samples"}) {
        with_history[picture] = behind_the_first;
    }
    EXPECT_EQ(list_pictures(cell(0).id), with_history);
    EXPECT_EQ(list_pictures("reference"),
              (std::map<std::string, std::set<int>>{{"film_visibility", all},
                                                    {"accumulated_profile", behind_the_first},
                                                    {"visibility", singles},
                                                    {"shaded", singles}}));
}

TEST_F(RoundRunnerSequenceTest, TwoRunsGiveTheSameRows) {
    const auto list_rows = [this] {
        std::vector<
            std::tuple<std::string, int, SampleState, std::string, std::optional<double>,
                       std::optional<double>, std::optional<double>, std::string, std::string>>
            rows;
        for (const MetricRow& row : m_result.metrics) {
            rows.emplace_back(row.cell, row.frame, row.state, row.metric, row.value, row.debiased,
                              row.floor, row.note, row.image_hash);
        }
        return rows;
    };
    run({kWithHistory, "hemisphere_ssao"}, 1, 1);
    const auto first = list_rows();
    run({kWithHistory, "hemisphere_ssao"}, 2, 7);
    EXPECT_EQ(list_rows(), first) << "neither repeats nor order may show";
    EXPECT_GT(first.size(), 100u);
}

TEST_F(RoundRunnerSequenceTest, AMethodAgainstItselfHasNoErrorAndNoFloor) {
    m_reference = "tssao@reference_480";
    run({"tssao@reference_480", "none"}, 1);
    EXPECT_FALSE(m_result.done.reference_cached);
    int compared = 0;
    for (const MetricRow& row : m_result.metrics) {
        EXPECT_FALSE(row.debiased || row.floor) << row.metric << ": there are no halves";
        if (row.metric == "rmse" || row.metric == "temporal_flicker") {
            const bool is_itself = row.cell == cell(0).id;
            EXPECT_EQ(row.value == 0.0, is_itself) << row.metric << " of " << row.cell;
            compared += is_itself ? 1 : 0;
        }
    }
    EXPECT_EQ(compared, kRoundFrames + 2);
    for (const int frame : {1, 3}) {
        EXPECT_EQ(find_row(0, "flicker_ratio", frame).value, std::nullopt);
    }
}

TEST_F(RoundRunnerSequenceTest, AReferenceWithAHistoryIsConvergedAndDisturbsNobodysHistory) {
    m_reference = "history_method";
    run({"history_method"}, 1);
    // Visibility is 1 / (frames since the history was forgotten); the reference shows the frame
    // behind its warm-up.
    const double reference = 1.0 / (kHistoryWarmFrames + 1);
    const std::map<int, int> counts{{0, 1}, {1, 2}, {2, 1}, {3, 2}, {10, 1}, {20, 1}, {30, 1}};
    for (const auto& [frame, count] : counts) {
        EXPECT_NEAR(find_row(0, "rmse", frame).value.value(), 1.0 / count - reference, 1e-6)
            << frame;
    }
    for (const int single : {10, 20, 30}) {
        EXPECT_EQ(find_row(0, "rmse", single, SampleState::converged).value, 0.0);
    }
    // The reference holds the pose; the method that is measured sees it move.
    for (const HistoryEntry& entry : log()) {
        if (entry.event == HistoryEvent::render && entry.instance == 0 && entry.frame < 4) {
            EXPECT_EQ(entry.is_held, entry.frame % 2 == 0) << entry.frame;
        }
    }
}

} // namespace
} // namespace alcove
