// The contract of DESIGN 2 over every registered metric.
#include "core/base/error.hpp"
#include "core/base/history_state.hpp"
#include "core/contract/temporal_metric.hpp"
#include "metrics/common/planted_sequence.hpp"
#include "metrics/registry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

namespace alcove {
namespace {

std::vector<MetricUnit> list_metrics() {
    const Registry<MetricUnit> registry = metrics_registry();
    return {registry.units().begin(), registry.units().end()};
}

std::vector<MetricUnit> list_metrics(bool temporal) {
    std::vector<MetricUnit> chosen;
    for (const MetricUnit& unit : list_metrics()) {
        if (unit.is_temporal() == temporal) {
            chosen.push_back(unit);
        }
    }
    return chosen;
}

class MetricContract : public testing::TestWithParam<MetricUnit> {};

TEST_P(MetricContract, DescriptionIsComplete) {
    const MetricUnit& unit = GetParam();
    EXPECT_EQ(unit.name, unit.folder);
    EXPECT_FALSE(unit.title.empty());
    EXPECT_FALSE(unit.unit.empty());
    EXPECT_FALSE(unit.definition.empty());
    EXPECT_FALSE(unit.blind_to.empty());
    EXPECT_EQ(unit.content_hash.size(), 64u);
    EXPECT_LT(unit.minimum, unit.maximum);
}

TEST_P(MetricContract, IsOfImagesOrOverTimeAndHasTheChecksOfItsKind) {
    const MetricUnit& unit = GetParam();
    EXPECT_NE(static_cast<bool>(unit.create), static_cast<bool>(unit.create_temporal));
    EXPECT_EQ(unit.checks.empty(), unit.is_temporal());
    EXPECT_EQ(unit.temporal_checks.empty(), !unit.is_temporal());
}

INSTANTIATE_TEST_SUITE_P(All, MetricContract, testing::ValuesIn(list_metrics()),
                         [](const auto& unit) { return unit.param.name; });

Image make_image(int channels = 1, ImageSize size = {48, 40}) {
    Image image(size, channels);
    for (std::size_t i = 0; i < image.values().size(); ++i) {
        image.values()[i] = static_cast<float>((i * 37) % 101) / 101.0f;
    }
    return image;
}

class ImageMetricContract : public testing::TestWithParam<MetricUnit> {
  protected:
    /// Large enough for the metric, of odd and even side.
    static ImageSize size() {
        return {std::max(48, GetParam().smallest_side), std::max(41, GetParam().smallest_side)};
    }
    /// Of images that the metric has a value on.
    static int channels() { return GetParam().needs_colour ? 3 : 1; }
    /// What the metric has a value on: noise, or its canary.
    static Image make_reference(int channels, ImageSize of_size) {
        if (!GetParam().canary) {
            return make_image(channels, of_size);
        }
        const Image grey = GetParam().canary->make_reference(of_size);
        if (grey.channels() == channels) {
            return grey;
        }
        if (grey.channels() > channels) {
            return take_channel(grey, 0);
        }
        Image image(of_size, channels);
        for (std::size_t i = 0; i < image.values().size(); ++i) {
            image.values()[i] = grey.values()[i / static_cast<std::size_t>(channels)];
        }
        return image;
    }
    static Image make_fitting_image() { return make_reference(channels(), size()); }
    /// The error that the metric is made for: noise where it has no canary, or not this image's
    /// channels.
    static Image damage(const Image& image, float amount) {
        if (GetParam().canary && image.channels() >= channels()) {
            return GetParam().canary->damage(image, amount);
        }
        Image noisy = image;
        for (std::size_t i = 0; i < noisy.values().size(); ++i) {
            noisy.values()[i] += ((i * 2654435761u) >> 13) % 2 == 0 ? amount : -amount;
        }
        return noisy;
    }
    static std::optional<Image> make_depth(ImageSize of_size) {
        if (!GetParam().needs_depth) {
            return std::nullopt;
        }
        return GetParam().canary->make_depth(of_size);
    }
    /// With the depth that the metric needs.
    static MetricInput complete(MetricInput input, const std::optional<Image>& depth) {
        return {input.test,        input.reference, input.reference_a,
                input.reference_b, input.mask,      depth ? &*depth : nullptr};
    }
    [[nodiscard]] MetricResult evaluate(const MetricInput& input) const {
        return m_metric->evaluate(complete(input, make_depth(input.test.size())));
    }

    std::unique_ptr<Metric> m_metric = GetParam().create(GetParam().parameters.resolve({}, {}));
};

TEST_P(ImageMetricContract, AnImageAgainstItselfIsTheBestValue) {
    const Image image = make_fitting_image();
    const MetricResult result = evaluate({image, image});
    EXPECT_EQ(result.value.has_value(), GetParam().best.has_value());
    if (result.value) {
        EXPECT_NEAR(*result.value, *GetParam().best, 1e-12);
    } else {
        EXPECT_FALSE(result.undefined_reason.empty());
    }
}

TEST_P(ImageMetricContract, WorseImagesScoreWorse) {
    const Image reference = make_fitting_image();
    std::vector<double> values;
    for (const float noise : {0.05f, 0.1f, 0.2f}) {
        values.push_back(evaluate({damage(reference, noise), reference}).value.value());
    }
    const double sign = GetParam().direction == Direction::lower_is_better ? 1.0 : -1.0;
    EXPECT_LT(sign * values[0], sign * values[1]);
    EXPECT_LT(sign * values[1], sign * values[2]);
}

TEST_P(ImageMetricContract, ADifferentSizeThrows) {
    const Image a = make_fitting_image();
    const Image b = make_image(channels(), {size().width, size().height + 1});
    const Image c = make_image(4 - channels(), size());
    EXPECT_THROW(static_cast<void>(evaluate({a, b})), InputError);
    EXPECT_THROW(static_cast<void>(evaluate({a, c})), InputError);
}

TEST_P(ImageMetricContract, NanAndInfinityThrow) {
    const Image good = make_fitting_image();
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        Image image = good;
        image.at(3, 4) = bad;
        EXPECT_THROW(static_cast<void>(evaluate({image, good})), InputError);
        EXPECT_THROW(static_cast<void>(evaluate({good, image})), InputError);
        EXPECT_THROW(static_cast<void>(evaluate_in_domain(GetParam(), *m_metric, {image, good},
                                                          Domain::linear, GetParam().domain)),
                     InputError)
            << "conversion must not hide it";
        EXPECT_THROW(static_cast<void>(evaluate({good, good, &image, &good})), InputError);
        EXPECT_THROW(static_cast<void>(evaluate({good, good, &good, &image})), InputError);
    }
}

TEST_P(ImageMetricContract, CheckValuesHold) {
    for (const MetricCheck& check : GetParam().checks) {
        m_metric = GetParam().create(GetParam().parameters.resolve(check.parameters, {}));
        const MetricResult result = evaluate_check(*m_metric, check);
        ASSERT_TRUE(result.value) << check.name;
        EXPECT_NEAR(*result.value, check.expected, check.tolerance)
            << check.name << ": " << check.source;
    }
}

TEST_P(ImageMetricContract, EvaluatesTheSameTwiceAndLeavesAMapOfItsOwnSize) {
    const Image a = make_fitting_image();
    Image b = a;
    b.at(10, 10) = 0.9f;
    const MetricResult first = evaluate({a, b});
    EXPECT_EQ(first.value, evaluate({a, b}).value);
    if (first.map) {
        EXPECT_EQ(first.map->width() + 2 * first.map_offset, a.width());
        EXPECT_EQ(first.map->height() + 2 * first.map_offset, a.height());
    }
}

TEST_P(ImageMetricContract, AMaskOfOnesIsNoMask) {
    const Image reference = make_fitting_image();
    const Image test = damage(reference, 0.1f);
    const Image ones(size(), 1, 1.0f);
    const MetricResult plain = evaluate({test, reference});
    const MetricResult masked = evaluate({test, reference, nullptr, nullptr, &ones});
    EXPECT_EQ(masked.value, plain.value);
    ASSERT_EQ(masked.extras.size(), plain.extras.size());
    for (std::size_t i = 0; i < plain.extras.size(); ++i) {
        EXPECT_EQ(masked.extras[i].value, plain.extras[i].value) << plain.extras[i].name;
    }
    EXPECT_FALSE(plain.counted_pixels || plain.ignored_pixels);
    EXPECT_EQ(masked.ignored_pixels, 0u);
    EXPECT_GT(masked.counted_pixels.value(), 0u);
}

TEST_P(ImageMetricContract, CountedAndIgnoredPixelsAddUp) {
    const Image reference = make_fitting_image();
    const Image test = damage(reference, 0.1f);
    Image half(size(), 1);
    for (int y = 0; y < half.height(); ++y) {
        for (int x = 0; x < half.width() / 2; ++x) {
            half.at(x, y) = 1.0f;
        }
    }
    const Image ones(size(), 1, 1.0f);
    const MetricResult all = evaluate({test, reference, nullptr, nullptr, &ones});
    const MetricResult some = evaluate({test, reference, nullptr, nullptr, &half});
    EXPECT_EQ(*some.counted_pixels + *some.ignored_pixels, *all.counted_pixels);
    EXPECT_NEAR(static_cast<double>(*some.counted_pixels),
                0.5 * static_cast<double>(*all.counted_pixels),
                0.1 * static_cast<double>(*all.counted_pixels));
    EXPECT_TRUE(some.value);
}

TEST_P(ImageMetricContract, WhatLiesFarFromCountedPixelsDoesNotMatter) {
    const Image reference = make_fitting_image();
    const Image test = damage(reference, 0.1f);
    // Counted: the left third. Changed: the rightmost eight columns, out of reach of its windows,
    // halved as often as they may be.
    Image mask(size(), 1);
    Image changed = test;
    Image changed_reference = reference;
    for (int y = 0; y < mask.height(); ++y) {
        for (int x = 0; x < mask.width() / 3; ++x) {
            mask.at(x, y) = 1.0f;
        }
        for (int x = mask.width() - 8; x < mask.width(); ++x) {
            changed.at(x, y) = 0.25f;
            changed_reference.at(x, y) = 0.5f;
        }
    }
    const auto compare = [&](const Image& a, const Image& b, const Image* counted) {
        return evaluate({a, b, nullptr, nullptr, counted});
    };
    if (GetParam().name == "ms_ssim" || GetParam().name == "hdr_flip") {
        // The coarsest scale's windows reach everywhere; exposures are of the whole reference.
        GTEST_SKIP();
    }
    EXPECT_EQ(compare(test, reference, &mask).value,
              compare(changed, changed_reference, &mask).value);
    EXPECT_NE(compare(test, reference, nullptr).value,
              compare(changed, changed_reference, nullptr).value);
}

TEST_P(ImageMetricContract, AMaskThatCountsNothingLeavesNoValueAndSaysSo) {
    const Image image = make_fitting_image();
    const Image nothing(size(), 1);
    const MetricResult result = evaluate({image, image, nullptr, nullptr, &nothing});
    EXPECT_FALSE(result.value);
    EXPECT_NE(result.undefined_reason.find("mask"), std::string::npos);
    EXPECT_EQ(result.counted_pixels, 0u);
}

TEST_P(ImageMetricContract, AMaskOfAnotherSizeOrWithOtherValuesThrows) {
    const Image image = make_fitting_image();
    const Image narrow({size().width - 1, size().height}, 1, 1.0f);
    const Image deep(size(), 3, 1.0f);
    Image grey(size(), 1, 1.0f);
    grey.at(2, 3) = 0.5f;
    for (const Image* mask : std::array<const Image*, 3>{&narrow, &deep, &grey}) {
        EXPECT_THROW(static_cast<void>(evaluate({image, image, nullptr, nullptr, mask})),
                     InputError);
    }
}

TEST_P(ImageMetricContract, EverySizeHasAValueOrAReason) {
    for (const ImageSize size :
         {ImageSize{1, 1}, {10, 8}, {11, 11}, {16, 16}, {17, 23}, {177, 179}}) {
        for (const int channels : {1, 3}) {
            const Image reference = make_reference(channels, size);
            const Image test = damage(reference, 0.1f);
            const std::optional<Image> depth = make_depth(size);
            const MetricResult same =
                evaluate_in_domain(GetParam(), *m_metric, complete({reference, reference}, depth),
                                   Domain::linear, GetParam().domain);
            const MetricResult result =
                evaluate_in_domain(GetParam(), *m_metric, complete({test, reference}, depth),
                                   Domain::linear, GetParam().domain);
            const bool is_small = std::min(size.width, size.height) < GetParam().smallest_side;
            const bool has_value = !is_small && channels >= this->channels();
            EXPECT_EQ(result.value.has_value(), has_value) << size.width << "x" << size.height;
            EXPECT_EQ(result.undefined_reason.empty(), has_value);
            if (has_value && GetParam().best) {
                EXPECT_NEAR(same.value.value(), *GetParam().best, 1e-12);
                EXPECT_GE(*result.value, GetParam().minimum);
                EXPECT_LE(*result.value, GetParam().maximum);
            }
        }
    }
}

TEST_P(ImageMetricContract, ConstantsAndAShiftOfAPixelGiveFiniteValues) {
    const Image reference = make_fitting_image();
    Image shifted = reference;
    for (int y = 0; y < reference.height(); ++y) {
        for (int x = 1; x < reference.width(); ++x) {
            shifted.at(x, y) = reference.at(x - 1, y);
        }
    }
    const Image dark(size(), channels(), 0.25f);
    const Image bright(size(), channels(), 0.75f);
    const double sign = GetParam().direction == Direction::lower_is_better ? 1.0 : -1.0;
    for (const MetricInput& input : {MetricInput{shifted, reference}, MetricInput{dark, bright}}) {
        const double value = evaluate(input).value.value();
        EXPECT_TRUE(std::isfinite(value));
        if (!GetParam().best) {
            continue;
        }
        // What looks at fine structure alone is right to see nothing in a level.
        if (GetParam().canary || GetParam().name == "gradient_error") {
            EXPECT_GE(sign * value, sign * *GetParam().best);
        } else {
            EXPECT_GT(sign * value, sign * *GetParam().best);
        }
    }
}

TEST_P(ImageMetricContract, GreyIsColourWithEqualChannels) {
    if (GetParam().luma || GetParam().needs_colour) {
        GTEST_SKIP() << "colour is reduced to luma before it, or grey has no value";
    }
    const Image grey = make_fitting_image();
    const Image noisy = damage(grey, 0.1f);
    const auto repeat = [](const Image& image) {
        Image colour(image.size(), 3);
        for (std::size_t i = 0; i < colour.values().size(); ++i) {
            colour.values()[i] = image.values()[i / 3];
        }
        return colour;
    };
    EXPECT_NEAR(evaluate({noisy, grey}).value.value(),
                evaluate({repeat(noisy), repeat(grey)}).value.value(), 2e-6);
}

INSTANTIATE_TEST_SUITE_P(All, ImageMetricContract, testing::ValuesIn(list_metrics(false)),
                         [](const auto& unit) { return unit.param.name; });

TEST(MetricsThatNeedDepth, HaveNoValueWithoutItAndRefuseABadOne) {
    int count = 0;
    for (const MetricUnit& unit : list_metrics(false)) {
        if (!unit.needs_depth) {
            continue;
        }
        ++count;
        const ImageSize size{48, 41};
        const Image reference = unit.canary->make_reference(size);
        const Image test = unit.canary->damage(reference, 0.1f);
        const auto metric = unit.create(unit.parameters.resolve({}, {}));
        const MetricResult result = metric->evaluate({test, reference});
        EXPECT_FALSE(result.value);
        EXPECT_NE(result.undefined_reason.find("depth"), std::string::npos);
        const Image narrow({size.width - 1, size.height}, 1, 1.0f);
        Image negative(size, 1, 1.0f);
        negative.at(2, 3) = -1.0f;
        for (const Image* depth : std::array<const Image*, 2>{&narrow, &negative}) {
            EXPECT_THROW(static_cast<void>(
                             metric->evaluate({test, reference, nullptr, nullptr, nullptr, depth})),
                         InputError);
        }
    }
    EXPECT_GT(count, 0);
}

constexpr ImageSize kSequenceSize{48, 36};

/// A pan over a truth that stands in the upper half and swings in the lower, with the history state
/// of a method that drops what has changed and nothing else. The test is truth.
std::vector<PlantedFrame> plant_perfect_sequence() {
    constexpr PlantedMotion kMotion = PlantedMotion::pan_one_pixel;
    std::vector<PlantedFrame> frames(12, make_planted_frame(kSequenceSize, kMotion));
    for (std::size_t t = 0; t < frames.size(); ++t) {
        PlantedFrame& frame = frames[t];
        frame.history_state = Image(kSequenceSize, 4, 1.0f);
        for (int y = 0; y < kSequenceSize.height; ++y) {
            for (int x = 0; x < kSequenceSize.width; ++x) {
                const PlantedPoint point =
                    find_planted_point(kSequenceSize, kMotion, static_cast<int>(t), x, y);
                const bool swings = 2 * y >= kSequenceSize.height;
                // By 0.05 a frame, and back by 0.2 every fifth.
                const double swing = swings ? 0.05 * static_cast<double>(t % 5) : 0.0;
                frame.reference.at(x, y) =
                    static_cast<float>(0.4 + 0.2 * std::sin(0.3 * point.x) + swing);
                const HistoryCause cause = t == 0 ? HistoryCause::no_history
                                           : frame.to_previous.appeared.at(x, y) != 0.0f
                                               ? HistoryCause::off_screen
                                           : swings ? HistoryCause::neighbourhood
                                                    : HistoryCause::kept;
                frame.history_state->at(x, y, static_cast<int>(HistoryChannel::cause)) =
                    static_cast<float>(cause);
            }
        }
        frame.test = frame.reference;
    }
    return frames;
}

/// The same with errors and a history state that is wrong here and there.
std::vector<PlantedFrame> plant_faulty_sequence() {
    std::vector<PlantedFrame> frames = plant_perfect_sequence();
    for (std::size_t t = 0; t < frames.size(); ++t) {
        add_scaled(frames[t].test, make_planted_noise(kSequenceSize, static_cast<std::uint32_t>(t)),
                   0.1);
        for (int x = 0; x < kSequenceSize.width; x += 3) {
            for (int y = 0; y < kSequenceSize.height; ++y) {
                frames[t].history_state->at(x, y, static_cast<int>(HistoryChannel::cause)) =
                    static_cast<float>(x % 2 == 0 ? HistoryCause::kept
                                                  : HistoryCause::disocclusion);
            }
        }
    }
    return frames;
}

/// All that one frame hands to a metric, good as it is made.
struct FrameParts {
    Image test{kSequenceSize, 1, 0.5f};
    Image reference{kSequenceSize, 1, 0.5f};
    Image half_a{kSequenceSize, 1, 0.5f};
    Image half_b{kSequenceSize, 1, 0.5f};
    Image surface{kSequenceSize, 1, 1.0f};
    Image moves{kSequenceSize, 1};
    Image history_state{kSequenceSize, 4, 1.0f};
    EarlierFrame earlier{1, make_identity_correspondence(kSequenceSize),
                         Image(kSequenceSize, 1, 0.5f), Image(kSequenceSize, 1, 0.5f),
                         Image(kSequenceSize, 1, 0.5f)};
};

class TemporalMetricContract : public testing::TestWithParam<MetricUnit> {
  protected:
    /// A first frame, then this one.
    void feed(const FrameParts& parts) {
        const FrameParts first;
        m_metric->reset();
        static_cast<void>(m_metric->add({first.test,
                                         first.reference,
                                         &first.half_a,
                                         &first.half_b,
                                         {},
                                         first.surface,
                                         first.moves,
                                         &first.history_state}));
        static_cast<void>(m_metric->add({parts.test, parts.reference, &parts.half_a, &parts.half_b,
                                         std::span(&parts.earlier, 1), parts.surface, parts.moves,
                                         &parts.history_state, true}));
    }
    void expect_best(const std::vector<PlantedFrame>& frames) {
        for (const std::optional<MetricResult>& result : follow_planted(*m_metric, frames)) {
            if (!result) {
                continue;
            }
            if (!result->value) {
                EXPECT_FALSE(result->undefined_reason.empty());
                continue;
            }
            if (GetParam().ignores_reference) {
                EXPECT_GE(*result->value, GetParam().minimum);
                continue;
            }
            ASSERT_TRUE(GetParam().best) << "a value where the unit says that there is none";
            EXPECT_NEAR(*result->value, *GetParam().best, 1e-6);
        }
    }

    std::unique_ptr<TemporalMetric> m_metric =
        GetParam().create_temporal(GetParam().parameters.resolve({}, {}));
};

TEST_P(TemporalMetricContract, TruthIsTheBestValueOrHasAReasonForNone) {
    expect_best(plant_perfect_sequence());
    expect_best(std::vector<PlantedFrame>(
        12, make_planted_frame(kSequenceSize, PlantedMotion::rotating_disc)));
}

TEST_P(TemporalMetricContract, ValuesStayInTheirRangeAndTheLastFrameIsSpokenOf) {
    const auto results = follow_planted(*m_metric, plant_faulty_sequence());
    EXPECT_TRUE(results.back().has_value());
    for (const std::optional<MetricResult>& result : results) {
        if (result && result->value) {
            EXPECT_GE(*result->value, GetParam().minimum);
            EXPECT_LE(*result->value, GetParam().maximum);
        } else if (result) {
            EXPECT_FALSE(result->undefined_reason.empty());
        }
    }
}

TEST_P(TemporalMetricContract, ResetMakesASequenceRepeatItsValues) {
    const std::vector<PlantedFrame> frames = plant_faulty_sequence();
    const auto first = follow_planted(*m_metric, frames);
    // Another sequence, without errors; follow_planted resets before each.
    static_cast<void>(follow_planted(*m_metric, plant_perfect_sequence()));
    const auto again = follow_planted(*m_metric, frames);
    for (std::size_t t = 0; t < frames.size(); ++t) {
        ASSERT_EQ(again[t].has_value(), first[t].has_value()) << t;
        if (first[t]) {
            EXPECT_EQ(again[t]->value, first[t]->value) << t;
            EXPECT_EQ(again[t]->undefined_reason, first[t]->undefined_reason) << t;
            EXPECT_EQ(again[t]->debiased, first[t]->debiased) << t;
            EXPECT_EQ(again[t]->floor, first[t]->floor) << t;
            EXPECT_EQ(again[t]->map.has_value(), first[t]->map.has_value()) << t;
            if (first[t]->map && again[t]->map) {
                EXPECT_EQ(first[t]->map->size(), kSequenceSize) << "a map has the frame's size";
                EXPECT_EQ(hash_image(*again[t]->map), hash_image(*first[t]->map)) << t;
            }
        }
    }
}

TEST_P(TemporalMetricContract, NanAndInfinityThrow) {
    EXPECT_NO_THROW(feed({}));
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        FrameParts parts;
        parts.test.at(3, 4) = bad;
        EXPECT_THROW(feed(parts), InputError);
    }
}

TEST_P(TemporalMetricContract, WrongSizesAndChannelsThrow) {
    const std::vector<std::function<Image*(FrameParts&)>> images{
        [](FrameParts& parts) { return &parts.test; },
        [](FrameParts& parts) { return &parts.reference; },
        [](FrameParts& parts) { return &parts.half_a; },
        [](FrameParts& parts) { return &parts.half_b; },
        [](FrameParts& parts) { return &parts.surface; },
        [](FrameParts& parts) { return &parts.moves; },
        [](FrameParts& parts) { return &parts.history_state; },
        [](FrameParts& parts) { return &parts.earlier.reference; },
        [](FrameParts& parts) { return &*parts.earlier.reference_a; },
        [](FrameParts& parts) { return &*parts.earlier.reference_b; },
        [](FrameParts& parts) { return &parts.earlier.correspondence.position; },
        [](FrameParts& parts) { return &parts.earlier.correspondence.valid; },
        [](FrameParts& parts) { return &parts.earlier.correspondence.appeared; },
    };
    for (std::size_t i = 0; i < images.size(); ++i) {
        FrameParts narrow;
        Image& cut = *images[i](narrow);
        cut = Image({kSequenceSize.width - 1, kSequenceSize.height}, cut.channels());
        EXPECT_THROW(feed(narrow), InputError) << i;
        FrameParts deep;
        Image& more = *images[i](deep);
        more = Image(kSequenceSize, more.channels() + 1);
        EXPECT_THROW(feed(deep), InputError) << i;
    }
}

TEST_P(TemporalMetricContract, CheckValuesHold) {
    for (const TemporalCheck& check : GetParam().temporal_checks) {
        EXPECT_NEAR(check.run(*m_metric), check.expected, check.tolerance)
            << check.name << ": " << check.source;
    }
}

INSTANTIATE_TEST_SUITE_P(All, TemporalMetricContract, testing::ValuesIn(list_metrics(true)),
                         [](const auto& unit) { return unit.param.name; });

} // namespace
} // namespace alcove
