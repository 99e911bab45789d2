// The gate: fences by hand, steps, segments, confirmation, images.

#include "reports/analysis/history_night.hpp"
#include "reports/analysis/history_points.hpp"
#include "reports/analysis/history_wording.hpp"
#include "tests/reports/forged_store.hpp"
#include "tests/reports/synthetic_run.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace alcove {
namespace {

constexpr HistoryRule kLinear{false, 0.0};
constexpr HistoryRule kTimes{true, 0.0};

std::vector<HistoryPoint> make_points(std::initializer_list<double> values) {
    std::vector<HistoryPoint> points;
    for (const double value : values) {
        points.push_back({value, 1, false});
    }
    return points;
}

/// Ten nights of 10, 11, 10, 11, ...
std::vector<HistoryPoint> make_restless() {
    return make_points({10, 11, 10, 11, 10, 11, 10, 11, 10, 11});
}

TEST(History, TheBaselineIsTheMedianOfTheLastFiveNights) {
    const auto nights = replay_history(make_points({1, 2, 9, 3, 4, 5, 100, 6}), kLinear);
    EXPECT_FALSE(nights[0].baseline);
    EXPECT_EQ(nights[1].baseline, 1.0);
    EXPECT_EQ(nights[2].baseline, 1.5);
    EXPECT_EQ(nights[5].baseline, 3.0); // 1 2 9 3 4
    EXPECT_EQ(nights[6].baseline, 4.0); // 2 9 3 4 5
    EXPECT_EQ(nights[7].baseline, 5.0); // 9 3 4 5 100
    EXPECT_EQ(nights[7].difference, 1.0);
}

TEST(History, TheFenceIsThirdQuartilePlusThreeRanges) {
    // Differences of nights 1 to 8: 1, 0.5, 1, 0, 1, 1, 1, 1; of their absolutes Q1 = 0.875,
    // Q3 = 1.
    const auto nights = replay_history(make_restless(), kLinear);
    std::vector<double> differences;
    for (std::size_t i = 1; i < 9; ++i) {
        differences.push_back(std::abs(*nights[i].difference));
    }
    const double q1 = compute_quantile(differences, 0.25);
    const double q3 = compute_quantile(differences, 0.75);
    ASSERT_TRUE(nights[9].fence);
    EXPECT_EQ(nights[9].past_differences, 8u);
    EXPECT_DOUBLE_EQ(*nights[9].fence, q3 + 3.0 * (q3 - q1));
    EXPECT_FALSE(nights[8].fence) << "seven differences are too few";
    EXPECT_FALSE(nights[8].is_beyond());
}

TEST(History, TheFenceForgetsWhatIsOlderThanThirtyDifferences) {
    std::vector<HistoryPoint> points = make_points({10, 30, 10, 30, 10, 30, 10, 30, 10, 30});
    for (int i = 0; i < 36; ++i) {
        points.push_back({10.0, 1, false});
    }
    EXPECT_EQ(replay_history(points, kLinear).back().fence, 0.0);
}

TEST(History, TimesAreComparedByTheirLogarithms) {
    const auto nights = replay_history(make_points({2, 3}), kTimes);
    EXPECT_DOUBLE_EQ(*nights[1].difference, std::log(1.5));
    EXPECT_DOUBLE_EQ(to_change(*nights[1].difference, kTimes), 0.5);
}

TEST(History, AStepBeginsTheBaselineAnewAndMakesNoFence) {
    std::vector<HistoryPoint> points = make_restless();
    points.push_back({20.0, 1, true});
    points.push_back({20.5, 1, false});
    const auto nights = replay_history(points, kLinear);
    EXPECT_TRUE(nights[10].is_beyond());
    EXPECT_EQ(nights[11].baseline, 20.0);
    EXPECT_EQ(nights[11].past_differences, 9u);
    EXPECT_FALSE(nights[11].is_beyond()) << "reported once";
}

TEST(History, SegmentsAreNeverCompared) {
    std::vector<HistoryPoint> points = make_restless();
    points.push_back({99.0, 2, false});
    points.push_back({10.0, 1, false});
    const auto nights = replay_history(points, kLinear);
    EXPECT_FALSE(nights[10].baseline);
    EXPECT_EQ(nights[10].past_differences, 0u);
    EXPECT_EQ(nights[11].past_differences, 9u) << "an old driver that comes back finds its past";
}

TEST(History, AMetricThatNeverMovedHasARelativeFence) {
    std::vector<HistoryPoint> points;
    for (int i = 0; i < 12; ++i) {
        points.push_back({0.5, 1, false});
    }
    const auto judge = [&](double value) {
        std::vector<HistoryPoint> all = points;
        all.push_back({value, 1, false});
        return replay_history(all, get_rule(SeriesKind::quality)).back();
    };
    EXPECT_DOUBLE_EQ(*judge(0.5).fence, 0.5 * kQualityFence);
    EXPECT_FALSE(judge(0.5 * (1.0 + 0.9e-6)).is_beyond());
    EXPECT_TRUE(judge(0.5 * (1.0 + 1.1e-6)).is_beyond());
}

TEST(History, ASecondMeasurementMustLieBeyondTheFenceOnTheSameSide) {
    std::vector<HistoryPoint> points = make_restless();
    points.push_back({20.0, 1, false});
    const HistoryNight night = replay_history(points, kLinear).back();
    EXPECT_TRUE(is_repeated(night, 19.0, kLinear));
    EXPECT_FALSE(is_repeated(night, 11.5, kLinear));
    EXPECT_FALSE(is_repeated(night, 1.0, kLinear));
    EXPECT_FALSE(is_repeated(replay_history(make_restless(), kLinear).back(), 99.0, kLinear));
}

/// Twelve quiet nights, then what the test gives.
class NightGate : public testing::Test {
  protected:
    NightGate() { forged::append_nights(m_store, {.nights = 12, .methods = 2}); }

    static SeriesName name_time() {
        return forged::make_name("method_0", "cold", "envelope", "x anchor");
    }
    static NightPoint make_time(double value) {
        return forged::make_point(SeriesKind::time, name_time(), value);
    }
    Night judge(std::vector<NightPoint> points) const {
        return judge_night(m_store.read(), forged::make_run(12), std::move(points));
    }
    Store m_store{":memory:"};
};

TEST_F(NightGate, ATimeIsSlowerOnlyIfItIsMeasuredTwice) {
    Night night = judge({make_time(3.0)});
    EXPECT_EQ(night.past_nights, 12u);
    EXPECT_EQ(night.points[0].verdict, NightVerdict::unconfirmed);
    EXPECT_FALSE(night.is_failed());
    EXPECT_EQ(list_suspect_rounds(night), std::set<std::string>{"r001-bunny"});
    Night confirmed = night;
    confirm_times(confirmed, {make_time(2.9)});
    EXPECT_EQ(confirmed.points[0].verdict, NightVerdict::slower);
    EXPECT_TRUE(confirmed.is_failed());
    confirm_times(night, {make_time(1.5)});
    EXPECT_EQ(night.points[0].verdict, NightVerdict::unconfirmed);
    EXPECT_FALSE(night.is_failed());
    const auto rows = make_rows(night);
    ASSERT_TRUE(rows[0].verdict);
    EXPECT_FALSE(rows[0].verdict->is_confirmed);
}

TEST_F(NightGate, FasterIsSaidAndFailsNothing) {
    Night night = judge({make_time(1.0)});
    confirm_times(night, {make_time(1.0)});
    EXPECT_EQ(night.points[0].verdict, NightVerdict::faster);
    EXPECT_FALSE(night.is_failed());
}

TEST_F(NightGate, AConfirmedStepIsReportedOnce) {
    Night night = judge({make_time(3.0)});
    confirm_times(night, {make_time(3.0)});
    m_store.append(night.run, make_rows(night));
    const Night next = judge_night(m_store.read(), forged::make_run(13), {make_time(3.0)});
    EXPECT_EQ(next.points[0].verdict, NightVerdict::same);
    EXPECT_EQ(next.points[0].judged.baseline, 3.0);
}

TEST_F(NightGate, MetricsAreWorseOrBetterByTheirDirection) {
    const auto make_metric = [](const char* metric, double value, bool lower_is_better) {
        NightPoint point = forged::make_point(
            SeriesKind::quality, forged::make_name("method_0", "cold", "", metric), value);
        point.lower_is_better = lower_is_better;
        return point;
    };
    EXPECT_EQ(judge({make_metric("rmse", 0.0401, true)}).points[0].verdict, NightVerdict::worse);
    EXPECT_EQ(judge({make_metric("rmse", 0.0399, true)}).points[0].verdict, NightVerdict::better);
    EXPECT_EQ(judge({make_metric("rmse", 0.04, true)}).points[0].verdict, NightVerdict::same);
    EXPECT_EQ(judge({make_metric("ssim", 0.97, false)}).points[0].verdict, NightVerdict::worse);
    EXPECT_TRUE(judge({make_metric("ssim", 0.97, false)}).is_failed());
}

TEST_F(NightGate, AnotherImageFailsAndSaysWhatMovedWithIt) {
    NightPoint rmse = forged::make_point(SeriesKind::quality,
                                         forged::make_name("method_0", "cold", "", "rmse"), 0.05);
    const Night night = judge({make_time(1.5), forged::make_images("method_0", "ffff"), rmse});
    EXPECT_EQ(night.points[1].verdict, NightVerdict::image_changed);
    EXPECT_TRUE(night.is_failed());
    const std::vector<NightLine> lines = list_findings(night);
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_EQ(lines[1].note, "was 00000000000000a1; rmse cold worse; no time moved");
    EXPECT_EQ(judge({forged::make_images("method_0", "00000000000000a1")}).points[0].verdict,
              NightVerdict::same);
}

TEST_F(NightGate, AnotherDriverOrSceneBeginsAnew) {
    for (std::string StoredSegment::*part : {&StoredSegment::device, &StoredSegment::anchor,
                                             &StoredSegment::scene, &StoredSegment::reference}) {
        std::vector<NightPoint> points{make_time(9.0), forged::make_images("method_0", "ffff")};
        points[0].segment.*part += " of another kind";
        points[1].segment.*part += " of another kind";
        const Night night = judge(points);
        EXPECT_EQ(night.count(NightVerdict::too_little_history), 2u);
    }
}

TEST_F(NightGate, MillisecondsAreNeverGated) {
    const Night night = judge({forged::make_point(
        SeriesKind::milliseconds, forged::make_name("method_0", "cold", "envelope", "ms"), 900.0)});
    EXPECT_EQ(night.points[0].verdict, NightVerdict::not_gated);
    EXPECT_TRUE(list_suspect_rounds(night).empty());
}

/// The value of the one point with this state, pass and metric.
const NightPoint& find(const std::vector<NightPoint>& points, const std::string& scene,
                       const std::string& method, const std::string& state, const std::string& pass,
                       const std::string& metric) {
    static const NightPoint kNone;
    const NightPoint* only = nullptr;
    for (const NightPoint& point : points) {
        const SeriesName& name = point.name;
        if (name.scene == scene && name.method == method && name.state == state &&
            name.pass == pass && name.metric == metric) {
            EXPECT_EQ(only, nullptr) << "names are unique";
            only = &point;
        }
    }
    EXPECT_NE(only, nullptr) << method << " " << state << " " << pass << " " << metric;
    return only == nullptr ? kNone : *only;
}

TEST(NightPoints, ARunLeavesRatiosPassesMetricsAndImages) {
    const synthetic::TemporaryFolder folder;
    const RunFolder run = synthetic::write_run(folder.path(), {});
    const std::vector<NightPoint> points = collect_points(run);
    const auto at = [&](const char* method, const char* state, const char* pass,
                        const char* metric) -> const NightPoint& {
        return find(points, "courtyard", method, state, pass, metric);
    };
    const NightPoint& time = at("tssao", "cold", "envelope", "x anchor");
    EXPECT_NEAR(time.value, synthetic::true_ratio("tssao"), 1e-6);
    EXPECT_TRUE(time.interval);
    EXPECT_EQ(time.n, 6);
    EXPECT_EQ(time.name.size, "320x180");
    EXPECT_EQ(time.name.suite, "default");
    EXPECT_EQ(time.name.device, "software: llvmpipe, A made-up processor, 8 threads");
    EXPECT_NE(time.segment.device.find("timestamp_finish"), std::string::npos);
    EXPECT_EQ(time.segment.anchor, "1");
    EXPECT_EQ(time.segment.reference, "") << "a time does not depend on the reference";
    EXPECT_EQ(at("tssao", "cold", "envelope", "ms").kind, SeriesKind::milliseconds);
    EXPECT_NEAR(at("hemisphere_ssao", "cold", "", "rmse").value,
                synthetic::true_rmse("hemisphere_ssao", 0), 1e-12);
    EXPECT_FALSE(at("hemisphere_ssao", "converged", "", "ssim").lower_is_better);
    EXPECT_EQ(at("tssao", "cold", "", "temporal_flicker").kind, SeriesKind::quality);
    EXPECT_NE(at("tssao", "cold", "", "rmse").segment.reference.find("reference_ray_traced"),
              std::string::npos);
    EXPECT_EQ(at("tssao", "all", "", "images").image_hash.size(), 16u);
    EXPECT_TRUE(std::none_of(points.begin(), points.end(), [](const NightPoint& point) {
        return point.name.method.starts_with("anchor");
    }));
    EXPECT_TRUE(std::none_of(points.begin(), points.end(), [](const NightPoint& point) {
        return point.name.method == "none" && has_logarithm(point.kind);
    })) << "what costs nothing by definition has no time";
}

TEST(NightPoints, CachedInputCostsAreLeftOut) {
    const synthetic::TemporaryFolder folder;
    const auto count_inputs = [&](const char* name, bool is_cached) {
        RunFolder run = RunFolder::create(folder.path() / name, synthetic::make_context(),
                                          synthetic::make_plan({}));
        const RoundRecord& round = run.plan().rounds[0];
        std::vector<SampleRow> samples = synthetic::make_samples(run.plan(), round);
        for (SampleRow& row : samples) {
            row.cached = is_cached && row.pass == "input/motion";
        }
        run.finish_round(round.id, samples, synthetic::make_metrics(round), {});
        const std::vector<NightPoint> points = collect_points(run);
        return std::count_if(points.begin(), points.end(), [](const NightPoint& point) {
            return point.kind == SeriesKind::input;
        });
    };
    EXPECT_EQ(count_inputs("measured", false), 1);
    EXPECT_EQ(count_inputs("cached", true), 0);
}

} // namespace
} // namespace alcove
