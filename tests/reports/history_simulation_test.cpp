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
constexpr double kSigma = 0.01; ///< of the logarithm of a time, from night to night
constexpr int kSlowNight = 20;  ///< counted from 1, as all nights here
constexpr int kImageNight = 25;
constexpr int kBurstNight = 13; ///< first of three with five times the noise
constexpr int kBurstNights = 3;
constexpr double kBurst = 5.0;
constexpr std::array kSlowDowns{0.03, 0.05, 0.10}; ///< each of a pass of its own
constexpr std::size_t kSteadyPasses = 4;
constexpr std::array kMethods{"tssao", "hemisphere_ssao"};
constexpr int kAlert = 3; ///< nights within which a slow-down should be seen

/// Does the machine have its three noisy nights?
enum class Machine { quiet, restless };

bool is_burst(Machine machine, int night) {
    return machine == Machine::restless && night >= kBurstNight &&
           night < kBurstNight + kBurstNights;
}

/// One measurement of a night: passes that become slower, steady ones, images, a metric.
std::vector<NightPoint> measure(Machine machine, int night, forged::Noise& noise) {
    const double sigma = kSigma * (is_burst(machine, night) ? kBurst : 1.0);
    std::vector<NightPoint> points;
    const auto add_pass = [&](double value) {
        const SeriesName name =
            forged::make_name("tssao", "cold", "pass" + std::to_string(points.size()), "x anchor");
        points.push_back(forged::make_point(SeriesKind::pass, name, noise.draw(value, sigma)));
    };
    for (const double slow_down : kSlowDowns) {
        add_pass(night >= kSlowNight ? 1.0 + slow_down : 1.0);
    }
    for (std::size_t i = 0; i < kSteadyPasses; ++i) {
        add_pass(2.0);
    }
    for (const char* method : kMethods) {
        const bool is_other = method == kMethods[0] && night >= kImageNight;
        points.push_back(forged::make_images(method, is_other ? "new" : "old"));
        points.push_back(forged::make_point(SeriesKind::quality,
                                            forged::make_name(method, "cold", "", "rmse"), 0.04));
    }
    return points;
}

/// How often something happened among how many chances.
struct Share {
    int count = 0;
    int of = 0;
    void add(bool happened) {
        count += happened ? 1 : 0;
        ++of;
    }
    [[nodiscard]] double value() const { return static_cast<double>(count) / of; }
};

struct Tally {
    std::array<Share, kSlowDowns.size()> first; ///< slower on the very night
    std::array<Share, kSlowDowns.size()> soon;  ///< within kAlert nights
    Share images;                               ///< the planted change, on its night
    Share other_images;
    Share metrics;
    // Of times that did not change, where there is history enough; [1]: on noisy nights.
    std::array<Share, 2> suspected;
    std::array<Share, 2> alarms;
};

bool is_verdict(const JudgedPoint& judged) {
    return judged.verdict == NightVerdict::slower || judged.verdict == NightVerdict::faster;
}

void add_night(Tally& tally, const Night& night, int number, bool is_noisy) {
    for (std::size_t i = 0; i < night.points.size(); ++i) {
        const JudgedPoint& judged = night.points[i];
        if (judged.point.kind == SeriesKind::images) {
            const bool is_planted =
                number == kImageNight && judged.point.name.method == kMethods[0];
            (is_planted ? tally.images : tally.other_images)
                .add(judged.verdict == NightVerdict::image_changed);
        } else if (judged.point.kind == SeriesKind::quality) {
            tally.metrics.add(judged.judged.is_beyond());
        } else if (judged.judged.fence && i >= kSlowDowns.size()) {
            tally.suspected[is_noisy ? 1 : 0].add(judged.judged.is_beyond());
            tally.alarms[is_noisy ? 1 : 0].add(is_verdict(judged));
        }
    }
}

void simulate(Machine machine, std::uint64_t seed, Tally& tally) {
    forged::Noise noise(seed);
    Store store(":memory:");
    std::array<int, kSlowDowns.size()> detected{};
    for (int number = 1; number <= kNights; ++number) {
        Night night =
            judge_night(store.read(), forged::make_run(number), measure(machine, number, noise));
        if (!list_suspect_rounds(night).empty()) {
            confirm_times(night, measure(machine, number, noise));
        }
        store.append(night.run, make_rows(night));
        add_night(tally, night, number, is_burst(machine, number));
        for (std::size_t i = 0; i < detected.size(); ++i) {
            if (number >= kSlowNight && detected[i] == 0 &&
                night.points[i].verdict == NightVerdict::slower) {
                detected[i] = number;
            }
        }
    }
    for (std::size_t i = 0; i < detected.size(); ++i) {
        tally.first[i].add(detected[i] == kSlowNight);
        tally.soon[i].add(detected[i] != 0 && detected[i] < kSlowNight + kAlert);
    }
}

Tally simulate_seeds(Machine machine) {
    Tally tally;
    for (int seed = 1; seed <= kSeeds; ++seed) {
        simulate(machine, static_cast<std::uint64_t>(seed), tally);
    }
    return tally;
}

void print_table(const Tally& quiet, const Tally& restless) {
    std::printf("| planted | quiet machine | after three nights of five times the noise |\n"
                "| --- | --- | --- |\n");
    for (std::size_t i = 0; i < kSlowDowns.size(); ++i) {
        std::printf("| a pass %.0f %% slower | %.0f %% on its night, %.0f %% within %d | %.0f %%, "
                    "%.0f %% |\n",
                    100.0 * kSlowDowns[i], 100.0 * quiet.first[i].value(),
                    100.0 * quiet.soon[i].value(), kAlert, 100.0 * restless.first[i].value(),
                    100.0 * restless.soon[i].value());
    }
    std::printf("| another image, same time | %.0f %% on its night | %.0f %% |\n",
                100.0 * quiet.images.value(), 100.0 * restless.images.value());
    std::printf("| nothing: suspicions in 1000 series-nights | %.1f | %.1f, noisy nights %.0f |\n",
                1000.0 * quiet.suspected[0].value(), 1000.0 * restless.suspected[0].value(),
                1000.0 * restless.suspected[1].value());
    std::printf("| nothing: verdicts in 1000 series-nights | %.1f | %.1f, noisy nights %.0f |\n",
                1000.0 * quiet.alarms[0].value(), 1000.0 * restless.alarms[0].value(),
                1000.0 * restless.alarms[1].value());
}

/// `expected` comes from 8000 seeds of the same rule written down independently, in another
/// language; a share of n independent chances lies within four standard errors of it (4 in 1e5
/// do not). Nights of one series share baseline and fence, which is worth `dependence` chances.
void expect_share(const char* what, const Share& share, double expected, double dependence = 1.0) {
    const double error = std::sqrt(expected * (1.0 - expected) * dependence / share.of);
    EXPECT_NEAR(share.value(), expected, 4.0 * error) << what;
}

TEST(HistorySimulation, TheGateSeesWhatWasPlantedAndLittleElse) {
    const Tally quiet = simulate_seeds(Machine::quiet);
    const Tally restless = simulate_seeds(Machine::restless);
    print_table(quiet, restless);

    constexpr std::array kQuietFirst{0.139, 0.622, 0.9998};
    constexpr std::array kQuietSoon{0.179, 0.698, 0.9999};
    constexpr std::array kRestlessFirst{0.061, 0.347, 0.948};
    constexpr std::array kRestlessSoon{0.075, 0.395, 0.954};
    for (std::size_t i = 0; i < kSlowDowns.size(); ++i) {
        expect_share("quiet, on its night", quiet.first[i], kQuietFirst[i]);
        expect_share("quiet, soon", quiet.soon[i], kQuietSoon[i]);
        expect_share("restless, on its night", restless.first[i], kRestlessFirst[i]);
        expect_share("restless, soon", restless.soon[i], kRestlessSoon[i]);
    }
    constexpr double kSharedNights = 4.0;
    expect_share("quiet alarms", quiet.alarms[0], 0.00085, kSharedNights);
    expect_share("restless alarms", restless.alarms[0], 0.0080, kSharedNights);
    expect_share("noisy alarms", restless.alarms[1], 0.137, kSharedNights);
    for (const Tally& tally : {quiet, restless}) {
        EXPECT_EQ(tally.images.count, kSeeds) << "every change of an image is seen on its night";
        EXPECT_EQ(tally.other_images.count, 0) << "and only there: it is reported once";
        EXPECT_EQ(tally.metrics.count, 0);
    }
}

} // namespace
} // namespace alcove
