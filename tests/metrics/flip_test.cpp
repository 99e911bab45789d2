// FLIP beyond its check values: the powers it is built on, pooling, viewing conditions, exposures.
#include "core/base/error.hpp"
#include "metrics/common/fast_pow.hpp"
#include "metrics/common/flip_pooling.hpp"
#include "metrics/common/test_images.hpp"
#include "metrics/flip/flip.hpp"
#include "metrics/hdr_flip/hdr_flip.hpp"
#include "metrics/hdr_flip/tone_mapping.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace alcove {
namespace {

std::unique_ptr<Metric> create(const MetricUnit& unit,
                               const std::vector<ParameterOverride>& overrides = {}) {
    return unit.create(unit.parameters.resolve(overrides, {}));
}

double get_extra(const MetricResult& result, const std::string& name) {
    for (const NamedValue& extra : result.extras) {
        if (extra.name == name) {
            return extra.value;
        }
    }
    ADD_FAILURE() << name;
    return 0.0;
}

TEST(FastPow, StaysWithinItsBound) {
    double worst = 0.0;
    for (const float exponent : {0.02f, 1.0f / 3.0f, 0.5f, 0.7f, 1.0f, 2.4f, 3.0f}) {
        for (float x = 1.1e-12f; x < 1e6f; x *= 1.0007f) {
            const double exact = std::pow(static_cast<double>(x), static_cast<double>(exponent));
            const double got = static_cast<double>(compute_pow(x, exponent));
            // Far from 1 the logarithm's rounding is multiplied by the exponent.
            const double allowed = 1e-6 + 2e-7 * static_cast<double>(exponent) *
                                              std::abs(std::log2(static_cast<double>(x)));
            worst = std::max(worst, std::abs(got / exact - 1.0) / allowed);
        }
    }
    EXPECT_LT(worst, 1.0);
    EXPECT_EQ(compute_pow(0.0f, 0.7f), 0.0f);
    EXPECT_EQ(compute_pow(1.0f, 0.7f), 1.0f);
}

TEST(FlipPooling, WeightedQuantilesByHand) {
    // 8 pixels of 0.105 (bin 10, centre 0.105) and 2 of 0.505: weights 0.84 and 1.01, total 1.85.
    Image map({10, 1}, 1, 0.105f);
    map.at(8, 0) = 0.505f;
    map.at(9, 0) = 0.505f;
    const MetricResult result = pool_flip_map(map, nullptr);
    EXPECT_NEAR(*result.value, (8 * 0.105 + 2 * 0.505) / 10.0, 1e-8);
    // 0.25 x 1.85 = 0.4625 of 0.84 into bin 10; half: 0.085 of 1.01 into bin 50.
    EXPECT_NEAR(get_extra(result, "weighted_quartile_1"), (10.0 + 0.4625 / 0.84) / 100.0, 1e-9);
    EXPECT_NEAR(get_extra(result, "weighted_median"), (50.0 + 0.085 / 1.01) / 100.0, 1e-9);
    EXPECT_NEAR(get_extra(result, "weighted_quartile_3"), (50.0 + 0.5475 / 1.01) / 100.0, 1e-9);
    EXPECT_NEAR(get_extra(result, "min"), 0.105, 1e-7);
    EXPECT_NEAR(get_extra(result, "max"), 0.505, 1e-7);
}

TEST(Flip, PublishedSinglePixelsHold) {
    const auto metric = create(flip_unit());
    const auto map_of = [&](const Image& a, const Image& b) {
        return std::move(*metric->evaluate({a, b}).map);
    };
    const Image firefly = map_of(make_constant(0), make_firefly());
    EXPECT_NEAR(*std::max_element(firefly.values().begin(), firefly.values().end()), 0.864906,
                1e-4);
    EXPECT_NEAR(map_of(make_checkerboard(), make_constant(188)).at(0, 0), 0.519358, 1e-4);
    const Image noise = map_of(make_colour_ramp(), make_noisy_colour_ramp(8));
    EXPECT_NEAR(noise.at(0, 0), 0.065879, 1e-4);
    EXPECT_NEAR(*std::max_element(noise.values().begin(), noise.values().end()), 0.212343, 1e-4);
}

TEST(Flip, ViewingConditionsGiveThePixelsADegree) {
    const MetricUnit unit = flip_unit();
    const auto get_ppd = [&](const std::vector<ParameterOverride>& overrides) {
        return std::get<double>(unit.parameters.resolve(overrides, {}).get("ppd"));
    };
    // 0.7 3840 / 0.7 pi / 180; single precision prints 67.020645.
    EXPECT_NEAR(get_ppd({}), 67.020643, 1e-6);
    EXPECT_NEAR(get_ppd({{"distance_m", "1.4", Provenance::command_line}}), 2 * 67.020643, 2e-6);
    EXPECT_EQ(get_ppd({{"ppd", "30", Provenance::command_line}}), 30.0);
    EXPECT_THROW(get_ppd({{"ppd", "0.5", Provenance::command_line}}), InputError);
    EXPECT_THROW(get_ppd({{"ppi", "30", Provenance::command_line}}), InputError);
    // From further away a pixel's checkerboard is seen less.
    const auto evaluate = [&](const char* ppd) {
        return *create(unit, {{"ppd", ppd, Provenance::command_line}})
                    ->evaluate({make_checkerboard(), make_constant(188)})
                    .value;
    };
    EXPECT_GT(evaluate("20"), 2.0 * evaluate("67"));
}

TEST(Flip, AMaskPoolsItsPixelsAlone) {
    const Image a = make_step(32);
    const Image b = make_step(33);
    Image mask({64, 64}, 1);
    for (int y = 0; y < 64; ++y) {
        mask.at(60, y) = 1.0f;
    }
    const MetricResult far = create(flip_unit())->evaluate({a, b, nullptr, nullptr, &mask});
    EXPECT_EQ(*far.value, 0.0) << "28 pixels from the step";
    EXPECT_EQ(far.counted_pixels, 64u);
    EXPECT_EQ(far.ignored_pixels, 64u * 63u);
    EXPECT_EQ(get_extra(far, "weighted_median"), 0.0);
}

TEST(HdrFlip, ExposuresAreThePublishedOnes) {
    const MetricUnit unit = hdr_flip_unit();
    struct Case {
        const char* mapper;
        double start;
        double stop;
        double largest;
    };
    for (const Case& expected : {Case{"aces", -6.0262, 1.8930, 0.0909},
                                 {"hable", -5.4644, 2.4549, 0.1223},
                                 {"reinhard", -4.6070, 3.3122, 0.0976}}) {
        const auto metric =
            create(unit, {{"tone_mapper", expected.mapper, Provenance::command_line}});
        const MetricCheck& ramp = unit.checks.front();
        const MetricResult result = metric->evaluate({ramp.make_test(), ramp.make_reference()});
        EXPECT_NEAR(get_extra(result, "start_exposure"), expected.start, 6e-5) << expected.mapper;
        EXPECT_NEAR(get_extra(result, "stop_exposure"), expected.stop, 6e-5) << expected.mapper;
        EXPECT_EQ(get_extra(result, "exposures"), 8.0) << expected.mapper;
        EXPECT_NEAR(get_extra(result, "max"), expected.largest, 6e-5) << expected.mapper;
    }
}

TEST(HdrFlip, ExposuresCanBePinnedAndMustBeInOrder) {
    const MetricUnit unit = hdr_flip_unit();
    const Image test({16, 16}, 1, 3.0f);
    const Image reference({16, 16}, 1, 4.0f);
    const auto pin = [&](const char* start, const char* stop) {
        return create(unit, {{"start_exposure", start, Provenance::command_line},
                             {"stop_exposure", stop, Provenance::command_line}});
    };
    const MetricResult result = pin("-3", "0.5")->evaluate({test, reference});
    EXPECT_EQ(get_extra(result, "start_exposure"), -3.0);
    EXPECT_EQ(get_extra(result, "exposures"), 4.0);
    EXPECT_THROW(static_cast<void>(pin("1", "0")->evaluate({test, reference})), InputError);
    EXPECT_EQ(list_exposures({-1.0, 1.0}), (std::vector<double>{-1.0, 1.0}));
}

TEST(HdrFlip, BlackReferencesHaveAValue) {
    const Image black({16, 16}, 3);
    const auto metric = create(hdr_flip_unit());
    EXPECT_EQ(*metric->evaluate({black, black}).value, 0.0);
    EXPECT_TRUE(std::isfinite(*metric->evaluate({Image({16, 16}, 3, 1.0f), black}).value));
}

} // namespace
} // namespace alcove
