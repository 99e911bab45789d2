// Planted faults: one truth, eight ways to miss it, and the scores that are made for each. A fault
// must lift its own scores over their bounds and leave all others below theirs, but for the answers
// that list_scores names, with the reason. The matrix is printed.
#include "tests/metrics/temporal_sequences.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <fmt/format.h>

namespace alcove {
namespace {

constexpr ImageSize kSize{128, 96};
constexpr int kFrames = 17;
constexpr int kFlash = 8;

/// Coverage of a pixel by what lies to the right of an edge at `edge`.
double cover(double x, double edge) {
    return std::clamp(x + 0.5 - edge, 0.0, 1.0);
}

/// What a test image may have of truth's parts.
struct Parts {
    double shift = 0.0;  ///< px to the right
    double detail = 1.0; ///< share of it that is kept
};

/// A ramp, above with waves of 8 pixels; below it is flat but for a shadow of 20 pixels that moves
/// by 2 a frame; a post with sharp edges stands at the right.
double shade(double x, double y, double time, const Parts& parts = {}) {
    x -= parts.shift;
    const double post = cover(x, 108.0) - cover(x, 116.0);
    const double left = 2.0 * time + 20.0;
    const double shadow = cover(x, left) - cover(x, left + 20.0);
    const double wave = y < 32.0 ? 0.08 * std::sin(0.25 * std::numbers::pi * x) : 0.0;
    const double ground = y < 64.0 ? 0.35 + 0.003 * x + parts.detail * wave : 0.7 - 0.4 * shadow;
    return ground * (1.0 - post) + 0.2 * post;
}

Image draw(double time, const Parts& parts = {}) {
    Image image(kSize, 1);
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            image.at(x, y) = static_cast<float>(shade(x, y, time, parts));
        }
    }
    return image;
}

Image add(const Image& image, double value) {
    Image sum = image;
    for (float& each : sum.values()) {
        each += static_cast<float>(value);
    }
    return sum;
}

/// 16 levels of the view.
Image quantise(const Image& image) {
    Image codes = image;
    for (float& value : codes.values()) {
        value = decode_srgb(std::round(encode_srgb(value) * 15.0f) / 15.0f);
    }
    return codes;
}

struct Fault {
    std::string name;
    std::function<Image(int frame)> make_test;
};

Image mix(const Image& a, const Image& b, double share_of_b) {
    Image mixed(kSize, 1);
    add_scaled(mixed, a, 1.0 - share_of_b);
    add_scaled(mixed, b, share_of_b);
    return mixed;
}

std::vector<Fault> list_faults() {
    return {
        {"nothing", [](int t) { return draw(t); }},
        {"noise",
         [](int t) {
             Image image = draw(t);
             add_scaled(image, make_planted_noise(kSize, make_seed(1, t)), 0.03);
             return image;
         }},
        {"drift", [](int t) { return add(draw(t), 0.005 * t); }},
        {"bias", [](int t) { return add(draw(t), 0.1); }},
        {"ghost", [](int t) { return mix(draw(t), draw(t - 4), 0.3); }},
        {"flash", [](int t) { return add(draw(t), t == kFlash ? 0.2 : 0.0); }},
        {"shift",
         [](int t) {
             return draw(t, {0.5, 1.0});
         }},
        {"banding", [](int t) { return quantise(draw(t)); }},
        {"lost detail",
         [](int t) {
             return draw(t, {0.0, 0.3});
         }},
    };
}

using Values = std::vector<double>; ///< one a frame that has one

double take_median(const Values& unsorted) {
    Values values = unsorted;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double take_peak(const Values& values) {
    return *std::max_element(values.begin(), values.end()) - take_median(values);
}

double take_growth(const Values& values) {
    return values.back() - values.front();
}

double take_lost(const Values& values) {
    return 1.0 - take_median(values);
}

struct Score {
    std::string name;
    std::string metric; ///< "METRIC" or "METRIC.EXTRA"
    double (*reduce)(const Values&) = nullptr;
    double bound = 0.0;
    std::vector<std::string> own;  ///< faults that it is made for
    std::vector<std::string> also; ///< faults that it rightly answers to as well
};

std::vector<Score> list_scores() {
    return {
        {"flicker", "temporal_flicker", take_median, 0.035, {"noise"}, {}},
        {"fine noise", "flat_noise", take_median, 0.02, {"noise"}, {}},
        {"growth of mae", "mae", take_growth, 0.04, {"drift"}, {}},
        {"mae", "mae", take_median, 0.06, {"bias"}, {}},
        {"lag share", "lag_share", take_median, 0.2, {"ghost"}, {}},
        // It is the whole error where truth brightens, which a bias is part of.
        {"trail", "trail_energy", take_median, 0.06, {"ghost"}, {"bias"}},
        {"flicker's peak", "temporal_flicker", take_peak, 0.1, {"flash"}, {}},
        {"largest error", "max_error", take_median, 0.15, {"shift"}, {}},
        // Noise is gradient everywhere; `fine noise` tells the two apart.
        {"gradients", "gradient_error", take_median, 0.045, {"shift"}, {"noise"}},
        {"banding", "banding_energy", take_median, 0.004, {"banding"}, {}},
        {"lost detail", "gradient_error.kept_detail", take_lost, 0.08, {"lost detail"}, {}},
    };
}

std::vector<PlantedFrame> plant(const Fault& fault) {
    std::vector<PlantedFrame> frames(kFrames, make_planted_frame(kSize, PlantedMotion::still));
    for (int t = 0; t < kFrames; ++t) {
        frames[static_cast<std::size_t>(t)].reference = draw(t);
        frames[static_cast<std::size_t>(t)].test = fault.make_test(t);
    }
    return frames;
}

Values measure(const std::string& metric, const std::vector<PlantedFrame>& frames) {
    static const Registry<MetricUnit> registry = metrics_registry();
    const std::size_t dot = metric.find('.');
    const MetricUnit& unit = registry.find(metric.substr(0, dot));
    const ResolvedParameters parameters = unit.parameters.resolve({}, {});
    Values values;
    if (unit.is_temporal()) {
        for (const auto& result : follow_planted(*unit.create_temporal(parameters), frames)) {
            if (result && result->value) {
                values.push_back(*result->value);
            }
        }
        return values;
    }
    const auto evaluator = unit.create(parameters);
    for (const PlantedFrame& frame : frames) {
        const MetricResult result = evaluate_in_domain(
            unit, *evaluator, {frame.test, frame.reference}, Domain::visibility, unit.domain);
        if (dot == std::string::npos) {
            values.push_back(result.value.value());
        }
        for (const NamedValue& extra : result.extras) {
            if (dot != std::string::npos && extra.name == metric.substr(dot + 1)) {
                values.push_back(extra.value);
            }
        }
    }
    return values;
}

bool has(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

TEST(PlantedFaults, AreEachSeenByTheScoreThatIsMadeForThemAndOnlyByIt) {
    const std::vector<Fault> faults = list_faults();
    std::vector<std::vector<PlantedFrame>> planted;
    std::string head = fmt::format("{:16}{:>9}", "score", "bound");
    for (const Fault& fault : faults) {
        planted.push_back(plant(fault));
        head += fmt::format("{:>13}", fault.name);
    }
    fmt::print("{}\n", head);
    for (const Score& score : list_scores()) {
        std::string line = fmt::format("{:16}{:9.3f}", score.name, score.bound);
        for (std::size_t i = 0; i < faults.size(); ++i) {
            const Values values = measure(score.metric, planted[i]);
            ASSERT_FALSE(values.empty()) << score.name << ", " << faults[i].name;
            const double value = score.reduce(values);
            const bool sees = has(score.own, faults[i].name) || has(score.also, faults[i].name);
            EXPECT_EQ(value > score.bound, sees)
                << score.name << " of " << faults[i].name << ": " << value;
            line += fmt::format("{:12.4f}{}", value, value > score.bound ? '*' : ' ');
        }
        fmt::print("{}\n", line);
    }
}

TEST(PlantedFaults, EachHasAScoreOfItsOwn) {
    for (const Fault& fault : list_faults()) {
        int own = 0;
        for (const Score& score : list_scores()) {
            own += has(score.own, fault.name) ? 1 : 0;
        }
        EXPECT_EQ(own > 0, fault.name != "nothing") << fault.name;
    }
}

} // namespace
} // namespace alcove
