// The contract of DESIGN 2 over every registered metric.
#include "core/base/error.hpp"
#include "core/contract/metric.hpp"
#include "metrics/registry.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace alcove {
namespace {

std::vector<MetricUnit> list_metrics() {
    const Registry<MetricUnit> registry = metrics_registry();
    return {registry.units().begin(), registry.units().end()};
}

Image make_image(int channels = 1, ImageSize size = {48, 40}) {
    Image image(size, channels);
    for (std::size_t i = 0; i < image.values().size(); ++i) {
        image.values()[i] = static_cast<float>((i * 37) % 101) / 101.0f;
    }
    return image;
}

class MetricContract : public testing::TestWithParam<MetricUnit> {
  protected:
    std::unique_ptr<Metric> m_metric = GetParam().create(GetParam().parameters.resolve({}, {}));
};

TEST_P(MetricContract, DescriptionIsComplete) {
    const MetricUnit& unit = GetParam();
    EXPECT_EQ(unit.name, unit.folder);
    EXPECT_FALSE(unit.title.empty());
    EXPECT_FALSE(unit.unit.empty());
    EXPECT_FALSE(unit.definition.empty());
    EXPECT_FALSE(unit.blind_to.empty());
    EXPECT_EQ(unit.content_hash.size(), 64u);
    EXPECT_FALSE(unit.checks.empty());
    EXPECT_LT(unit.minimum, unit.maximum);
}

TEST_P(MetricContract, AnImageAgainstItselfIsTheBestValue) {
    const Image image = make_image();
    const MetricResult result = m_metric->evaluate({image, image});
    EXPECT_EQ(result.value.has_value(), GetParam().best.has_value());
    if (result.value) {
        EXPECT_NEAR(*result.value, *GetParam().best, 1e-12);
    } else {
        EXPECT_FALSE(result.undefined_reason.empty());
    }
}

TEST_P(MetricContract, WorseImagesScoreWorse) {
    const Image reference = make_image();
    std::vector<double> values;
    for (const float noise : {0.05f, 0.1f, 0.2f}) {
        Image test = reference;
        for (std::size_t i = 0; i < test.values().size(); ++i) {
            test.values()[i] += (i * 2654435761u) % 2 == 0 ? noise : -noise;
        }
        values.push_back(m_metric->evaluate({test, reference}).value.value());
    }
    const double sign = GetParam().direction == Direction::lower_is_better ? 1.0 : -1.0;
    EXPECT_LT(sign * values[0], sign * values[1]);
    EXPECT_LT(sign * values[1], sign * values[2]);
}

TEST_P(MetricContract, ADifferentSizeThrows) {
    const Image a = make_image();
    const Image b = make_image(1, {48, 41});
    const Image c = make_image(3);
    EXPECT_THROW(static_cast<void>(m_metric->evaluate({a, b})), InputError);
    EXPECT_THROW(static_cast<void>(m_metric->evaluate({a, c})), InputError);
}

TEST_P(MetricContract, NanAndInfinityThrow) {
    const Image good = make_image();
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        Image image = good;
        image.at(3, 4) = bad;
        EXPECT_THROW(static_cast<void>(m_metric->evaluate({image, good})), InputError);
        EXPECT_THROW(static_cast<void>(m_metric->evaluate({good, image})), InputError);
        EXPECT_THROW(static_cast<void>(
                         evaluate_in_domain(GetParam(), *m_metric, {image, good}, Domain::linear)),
                     InputError)
            << "conversion must not hide it";
        EXPECT_THROW(static_cast<void>(m_metric->evaluate({good, good, &image, &good})),
                     InputError);
        EXPECT_THROW(static_cast<void>(m_metric->evaluate({good, good, &good, &image})),
                     InputError);
    }
}

TEST_P(MetricContract, CheckValuesHold) {
    for (const MetricCheck& check : GetParam().checks) {
        const Image test = check.make_test();
        const Image reference = check.make_reference();
        const MetricResult result = m_metric->evaluate({test, reference});
        ASSERT_TRUE(result.value) << check.name;
        EXPECT_NEAR(*result.value, check.expected, check.tolerance)
            << check.name << ": " << check.source;
    }
}

TEST_P(MetricContract, EvaluatesTheSameTwiceAndLeavesAMapOfItsOwnSize) {
    const Image a = make_image();
    Image b = a;
    b.at(10, 10) = 0.9f;
    const MetricResult first = m_metric->evaluate({a, b});
    EXPECT_EQ(first.value, m_metric->evaluate({a, b}).value);
    if (first.map) {
        EXPECT_EQ(first.map->width() + 2 * first.map_offset, a.width());
        EXPECT_EQ(first.map->height() + 2 * first.map_offset, a.height());
    }
}

INSTANTIATE_TEST_SUITE_P(All, MetricContract, testing::ValuesIn(list_metrics()),
                         [](const auto& unit) { return unit.param.name; });

} // namespace
} // namespace alcove
