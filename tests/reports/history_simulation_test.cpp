// What the gate can see: thirty nights with planted changes, over many seeds. The table that is
// printed is the one in reports/README.md.

#include "reports/analysis/history_night.hpp"
#include "tests/reports/forged_store.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <map>

#include <gtest/gtest.h>

namespace alcove {
namespace {

constexpr int kSeeds = 200;
constexpr int kNights = 30;
constexpr double kSigma = 0.01;    ///< of the logarithm of a time, night to night
constexpr double kSlowDown = 0.05; ///< of one pass
constexpr int kSlowNight = 20;     ///< counted from 1, as all nights here
constexpr int kImageNight = 25;
constexpr int kBurstNight = 13; ///< first of three with five times the noise
constexpr int kBurstNights = 3;
constexpr double kBurst = 5.0;
constexpr int kSteadySeries = 6;
constexpr std::array kMethods{"tssao", "hemisphere_ssao"};

bool is_burst(int night) {
    return night >= kBurstNight && night < kBurstNight + kBurstNights;
}

SeriesName name_pass(const std::string& pass) {
    return forged::make_name("tssao", "cold", pass, "x anchor");
}

/// One measurement of a night: one pass that becomes slower, steady ones, images, a metric.
std::vector<NightPoint> measure(int night, forged::Noise& noise) {
    const double sigma = kSigma * (is_burst(night) ? kBurst : 1.0);
    std::vector<NightPoint> points;
    const auto add_pass = [&](const std::string& pass, double value) {
        points.push_back(
            forged::make_point(SeriesKind::pass, name_pass(pass), noise.draw(value, sigma)));
    };
    add_pass("slowing", night >= kSlowNight ? 1.0 + kSlowDown : 1.0);
    for (int i = 0; i < kSteadySeries; ++i) {
        add_pass("steady" + std::to_string(i), 1.0 + i);
    }
    for (const char* method : kMethods) {
        const bool is_other = method == kMethods[0] && night >= kImageNight;
        points.push_back(forged::make_images(method, is_other ? "new" : "old"));
        points.push_back(forged::make_point(SeriesKind::quality,
                                            forged::make_name(method, "cold", "", "rmse"), 0.04));
    }
    return points;
}

struct Tally {
    std::map<int, int> detected; ///< night of the first "slower" of the slowing pass: seeds
    int missed = 0;
    int images = 0;       ///< image changes on kImageNight, of the method that changed
    int wrong_images = 0; ///< any other
    int wrong_metrics = 0;
    // Of times that did not change: series-nights with enough history, suspicions, verdicts.
    std::array<int, 2> steady{};
    std::array<int, 2> suspected{};
    std::array<int, 2> alarms{};
};

void add_night(Tally& tally, const Night& night, const Night& before, int number) {
    const auto burst = static_cast<std::size_t>(is_burst(number));
    for (std::size_t i = 0; i < night.points.size(); ++i) {
        const JudgedPoint& judged = night.points[i];
        const bool is_verdict =
            judged.verdict == NightVerdict::slower || judged.verdict == NightVerdict::faster;
        switch (judged.point.kind) {
        case SeriesKind::images:
            if (judged.verdict == NightVerdict::image_changed) {
                const bool is_planted =
                    number == kImageNight && judged.point.name.method == kMethods[0];
                ++(is_planted ? tally.images : tally.wrong_images);
            }
            break;
        case SeriesKind::quality:
            tally.wrong_metrics += judged.judged.is_beyond() ? 1 : 0;
            break;
        default:
            // After its step the slowing pass is no steady series.
            if (judged.judged.fence &&
                (judged.point.name.pass != "slowing" || number < kSlowNight)) {
                ++tally.steady[burst];
                tally.suspected[burst] +=
                    before.points[i].verdict == NightVerdict::unconfirmed ? 1 : 0;
                tally.alarms[burst] += is_verdict ? 1 : 0;
            }
        }
    }
}

void simulate(std::uint64_t seed, Tally& tally) {
    forged::Noise noise(seed);
    Store store(":memory:");
    int detected = 0;
    for (int number = 1; number <= kNights; ++number) {
        Night night = judge_night(store.read(), forged::make_run(number), measure(number, noise));
        const Night before = night;
        if (!list_suspect_rounds(night).empty()) {
            confirm_times(night, measure(number, noise));
        }
        store.append(night.run, make_rows(night));
        add_night(tally, night, before, number);
        if (number >= kSlowNight && detected == 0 &&
            night.points[0].verdict == NightVerdict::slower) {
            detected = number;
        }
    }
    if (detected == 0) {
        ++tally.missed;
    } else {
        ++tally.detected[detected];
    }
}

double per_thousand(int count, int of) {
    return 1000.0 * count / of;
}

void print_table(const Tally& tally) {
    std::printf("| planted | seen |\n| --- | --- |\n");
    int sum = 0;
    for (int night = kSlowNight; night < kSlowNight + 3; ++night) {
        const auto found = tally.detected.find(night);
        sum += found == tally.detected.end() ? 0 : found->second;
        std::printf("| 5 %% slower pass, by night %d after it | %.0f %% of %d seeds |\n",
                    night - kSlowNight + 1, 100.0 * sum / kSeeds, kSeeds);
    }
    std::printf("| ... later or never | %.0f %%, %.0f %% |\n",
                100.0 * (kSeeds - sum - tally.missed) / kSeeds, 100.0 * tally.missed / kSeeds);
    std::printf("| another image, same time | %.0f %% on its night, %d elsewhere |\n",
                100.0 * tally.images / kSeeds, tally.wrong_images);
    std::printf(
        "| nothing, 1 %% noise | %.1f suspicions, %.2f verdicts in 1000 series-nights (%d) |\n",
        per_thousand(tally.suspected[0], tally.steady[0]),
        per_thousand(tally.alarms[0], tally.steady[0]), tally.steady[0]);
    std::printf(
        "| nothing, three nights of 5 %% noise | %.0f suspicions, %.0f verdicts in 1000 (%d) |\n",
        per_thousand(tally.suspected[1], tally.steady[1]),
        per_thousand(tally.alarms[1], tally.steady[1]), tally.steady[1]);
}

/// Four standard errors of a share of `n`.
double four_errors(double share, int n) {
    return 4.0 * std::sqrt(share * (1.0 - share) / n);
}

TEST(HistorySimulation, TheGateSeesWhatWasPlantedAndLittleElse) {
    Tally tally;
    for (int seed = 1; seed <= kSeeds; ++seed) {
        simulate(static_cast<std::uint64_t>(seed), tally);
    }
    print_table(tally);

    EXPECT_EQ(tally.images, kSeeds) << "images are deterministic: every change is seen, once";
    EXPECT_EQ(tally.wrong_images, 0);
    EXPECT_EQ(tally.wrong_metrics, 0);
}

} // namespace
} // namespace alcove
