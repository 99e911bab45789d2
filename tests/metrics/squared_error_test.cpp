// mse, rmse and psnr beyond their check values: what halves of a reference take out, and what is
// refused.
#include "core/base/error.hpp"
#include "core/base/statistics.hpp"
#include "metrics/registry.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace alcove {
namespace {

const Registry<MetricUnit>& get_registry() {
    static const Registry<MetricUnit> registry = metrics_registry();
    return registry;
}

MetricResult evaluate(const std::string& name, const MetricInput& input) {
    const MetricUnit& unit = get_registry().find(name);
    return unit.create(unit.parameters.resolve({}, {}))->evaluate(input);
}

/// A smooth truth in [0.2, 0.8] and a test image that is off by a known amount a pixel.
constexpr ImageSize kSize{48, 32};
Image make_truth() {
    Image image(kSize, 1);
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            image.at(x, y) = 0.5f + 0.3f * std::sin(0.3f * static_cast<float>(x + 2 * y));
        }
    }
    return image;
}

Image make_test() {
    Image image = make_truth();
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            image.at(x, y) += (x + y) % 2 == 0 ? 0.01f : -0.02f;
        }
    }
    return image;
}

constexpr double kTrueMse = 0.5 * (0.01 * 0.01 + 0.02 * 0.02);
constexpr double kNoise = 0.05; ///< standard deviation of each half

struct Halves {
    Image a;
    Image b;
    Image mean;
};

Halves draw_halves(std::mt19937& random) {
    std::normal_distribution<float> normal(0.0f, static_cast<float>(kNoise));
    Halves halves{make_truth(), make_truth(), make_truth()};
    for (std::size_t i = 0; i < kSize.pixel_count(); ++i) {
        halves.a.values()[i] += normal(random);
        halves.b.values()[i] += normal(random);
        halves.mean.values()[i] = 0.5f * (halves.a.values()[i] + halves.b.values()[i]);
    }
    return halves;
}

/// Mean over the draws within three of its standard errors.
void expect_mean(const std::vector<double>& draws, double expected, const char* name) {
    const double error =
        compute_standard_deviation(draws) / std::sqrt(static_cast<double>(draws.size()));
    const double deviation = compute_mean(draws) - expected;
    testing::Test::RecordProperty(std::string(name) + "_deviation_in_errors",
                                  std::to_string(deviation / error));
    EXPECT_LT(std::abs(deviation), 3.0 * error) << name;
    EXPECT_LT(error, 0.02 * expected) << name << ": too few draws to say";
}

TEST(SquaredError, DebiasingTakesOutTheReferencesNoiseOnAverage) {
    std::mt19937 random(1);
    const Image test = make_test();
    std::vector<double> plain;
    std::vector<double> debiased;
    std::vector<double> floors;
    for (int draw = 0; draw < 400; ++draw) {
        const Halves halves = draw_halves(random);
        const MetricResult result = evaluate("mse", {test, halves.mean, &halves.a, &halves.b});
        plain.push_back(result.value.value());
        debiased.push_back(result.debiased.value());
        floors.push_back(result.floor.value());
    }
    const double noise_of_mean = 0.5 * kNoise * kNoise;
    expect_mean(debiased, kTrueMse, "debiased");
    expect_mean(floors, noise_of_mean, "floor");
    expect_mean(plain, kTrueMse + noise_of_mean, "plain");
    // The noise is five times the error here: what is taken out is most of the plain value.
    EXPECT_GT(compute_mean(plain), 4.0 * kTrueMse);
}

TEST(SquaredError, RmseAndPsnrAreTheSameNumbersOnTheirScales) {
    std::mt19937 random(2);
    const Image test = make_test();
    const Halves halves = draw_halves(random);
    const MetricInput input{test, halves.mean, &halves.a, &halves.b};
    const MetricResult mse = evaluate("mse", input);
    const MetricResult rmse = evaluate("rmse", input);
    const MetricResult psnr = evaluate("psnr", input);
    EXPECT_DOUBLE_EQ(*rmse.value * *rmse.value, *mse.value);
    EXPECT_DOUBLE_EQ(*rmse.floor * *rmse.floor, *mse.floor);
    ASSERT_GT(*mse.debiased, 0.0);
    EXPECT_DOUBLE_EQ(*rmse.debiased * *rmse.debiased, *mse.debiased);
    EXPECT_DOUBLE_EQ(*psnr.value, -10.0 * std::log10(*mse.value));
    EXPECT_DOUBLE_EQ(*psnr.debiased, -10.0 * std::log10(*mse.debiased));
}

TEST(SquaredError, ADebiasedValueBelowZeroReadsAsZeroOrNothing) {
    // Halves on either side of the test image: (t - a)(t - b) < 0 everywhere.
    const Image test({4, 4}, 1, 0.5f);
    const Image a({4, 4}, 1, 0.6f);
    const Image b({4, 4}, 1, 0.4f);
    const MetricInput input{test, test, &a, &b};
    EXPECT_NEAR(*evaluate("mse", input).debiased, -0.01, 1e-7);
    EXPECT_EQ(*evaluate("rmse", input).debiased, 0.0);
    const MetricResult psnr = evaluate("psnr", input);
    EXPECT_FALSE(psnr.debiased.has_value());
    EXPECT_FALSE(psnr.value.has_value());
    EXPECT_FALSE(psnr.undefined_reason.empty());
}

TEST(SquaredError, WithoutHalvesNothingIsDebiased) {
    const Image test = make_test();
    const Image truth = make_truth();
    for (const char* name : {"mse", "rmse", "psnr"}) {
        const MetricResult result = evaluate(name, {test, truth});
        EXPECT_FALSE(result.debiased.has_value()) << name;
        EXPECT_FALSE(result.floor.has_value()) << name;
    }
    // Six digits are what the float images hold of differences of 0.01.
    EXPECT_NEAR(*evaluate("mse", {test, truth}).value, kTrueMse, 1e-6 * kTrueMse * 10.0);
}

TEST(SquaredError, MapsHoldTheErrorOfEachPixelOverAllChannels) {
    Image test({3, 2}, 3, 0.5f);
    const Image reference({3, 2}, 3, 0.5f);
    test.at(2, 1, 0) = 0.8f;
    test.at(2, 1, 2) = 0.9f;
    const MetricResult mse = evaluate("mse", {test, reference});
    EXPECT_EQ(mse.map->channels(), 1);
    EXPECT_NEAR(mse.map->at(2, 1), (0.09f + 0.16f) / 3.0f, 1e-6f);
    EXPECT_EQ(mse.map->at(1, 1), 0.0f);
    EXPECT_NEAR(*mse.value, (0.09 + 0.16) / 18.0, 1e-7);
    const MetricResult rmse = evaluate("rmse", {test, reference});
    EXPECT_NEAR(rmse.map->at(2, 1), std::sqrt(0.25f / 3.0f), 1e-6f);
}

/// The message of the InputError that a metric throws.
std::string find_refusal(const std::string& name, const Image& test, const Image& reference) {
    try {
        static_cast<void>(evaluate(name, {test, reference}));
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(MetricInput, ANanIsNamedWithItsPixelAndImage) {
    const Image good({20, 16}, 1, 0.5f);
    Image bad = good;
    bad.at(13, 7) = std::numeric_limits<float>::quiet_NaN();
    for (const char* name : {"mse", "rmse", "psnr", "ssim"}) {
        const std::string in_test = find_refusal(name, bad, good);
        EXPECT_NE(in_test.find("(13, 7)"), std::string::npos) << in_test;
        EXPECT_NE(in_test.find("test image"), std::string::npos) << in_test;
        EXPECT_NE(in_test.find(name), std::string::npos) << in_test;
        const std::string in_reference = find_refusal(name, good, bad);
        EXPECT_NE(in_reference.find("(13, 7)"), std::string::npos) << in_reference;
        EXPECT_NE(in_reference.find("reference image"), std::string::npos) << in_reference;
    }
    bad.at(13, 7) = std::numeric_limits<float>::infinity();
    EXPECT_NE(find_refusal("mse", bad, good).find("(13, 7)"), std::string::npos);
}

TEST(MetricInput, ShapesThatDifferAreNamedBoth) {
    const Image wide({20, 16}, 1, 0.5f);
    for (const char* name : {"mse", "rmse", "psnr", "ssim"}) {
        const std::string sizes = find_refusal(name, wide, Image({16, 20}, 1, 0.5f));
        EXPECT_NE(sizes.find("20x16x1"), std::string::npos) << sizes;
        EXPECT_NE(sizes.find("16x20x1"), std::string::npos) << sizes;
        EXPECT_NE(find_refusal(name, wide, Image({20, 16}, 3, 0.5f)).find("20x16x3"),
                  std::string::npos);
    }
}

} // namespace
} // namespace alcove
