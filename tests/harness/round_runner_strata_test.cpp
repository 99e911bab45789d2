// A round whose image metrics are measured over strata.
#include "harness/run/strata.hpp"
#include "tests/harness/round_runner_fixture.hpp"

#include <cmath>
#include <map>

namespace alcove {
namespace {

class RoundStrataTest : public RoundRunnerTest {
  protected:
    RoundStrataTest() { m_measures_strata = true; }
};

TEST_F(RoundStrataTest, EveryCapturedFrameHasEveryMetricOverEveryStratum) {
    run({"hemisphere_ssao"}, 1);
    std::map<std::string, int> rows;
    for (const MetricRow& row : m_result.metrics) {
        ++rows[row.metric];
    }
    ASSERT_GT(rows["rmse"], 0);
    for (const StratumInfo& stratum : list_strata()) {
        EXPECT_EQ(rows["rmse[" + stratum.name + "]"], rows["rmse"]) << stratum.name;
        EXPECT_EQ(rows["pixels[" + stratum.name + "]"], rows["rmse"]) << stratum.name;
    }
}

TEST_F(RoundStrataTest, TheThreeAnglesAddUpToTheWholeError) {
    run({"hemisphere_ssao"}, 1);
    struct Sums {
        double whole = 0.0;
        double parts = 0.0;
    };
    const double pixels = static_cast<double>(round().width) * round().height;
    std::map<std::pair<int, int>, Sums> frames;
    std::map<std::pair<std::pair<int, int>, std::string>, double> counts;
    for (const MetricRow& row : m_result.metrics) {
        const std::pair<int, int> frame{row.segment, row.frame};
        if (row.metric == "mse") {
            frames[frame].whole = row.value.value() * pixels;
        } else if (row.metric.starts_with("pixels[angle")) {
            counts[{frame, row.metric.substr(6)}] = row.value.value();
        }
    }
    for (const MetricRow& row : m_result.metrics) {
        const std::pair<int, int> frame{row.segment, row.frame};
        if (row.metric.starts_with("mse[angle") && row.value) {
            frames[frame].parts += *row.value * counts.at({frame, row.metric.substr(3)});
        }
    }
    ASSERT_EQ(frames.size(), static_cast<std::size_t>(kRoundFrames));
    for (const auto& [frame, sums] : frames) {
        // The background has no error: both say 1.
        EXPECT_GT(sums.whole, 0.0);
        EXPECT_NEAR(sums.parts, sums.whole, 1e-6 * sums.whole) << frame.second;
    }
}

TEST_F(RoundStrataTest, StrataThatCountNothingSayWhy) {
    run({"hemisphere_ssao"}, 1);
    int empty = 0;
    for (const MetricRow& row : m_result.metrics) {
        if (row.metric.starts_with("rmse[") && !row.value) {
            EXPECT_NE(row.note.find("mask"), std::string::npos) << row.metric;
            ++empty;
        }
    }
    EXPECT_GT(empty, 0) << "nothing moves on a first frame";
}

} // namespace
} // namespace alcove
