#pragma once
// What the tests of metrics over time share: units by name, and sequences with noise of a seed.

#include "metrics/common/planted_sequence.hpp"
#include "metrics/registry.hpp"

#include <gtest/gtest.h>

namespace alcove {

inline constexpr PlantedMotion kAllMotions[]{PlantedMotion::still, PlantedMotion::pan_one_pixel,
                                             PlantedMotion::pan_half_pixel,
                                             PlantedMotion::rotating_disc};

/// With its default parameters, or with overrides.
[[nodiscard]] inline std::unique_ptr<TemporalMetric>
make_temporal(const std::string& name, const std::vector<ParameterOverride>& overrides = {}) {
    static const Registry<MetricUnit> registry = metrics_registry();
    const MetricUnit& unit = registry.find(name);
    return unit.create_temporal(unit.parameters.resolve(overrides, {}));
}

/// A seed of its own for each use and frame.
[[nodiscard]] inline std::uint32_t make_seed(int use, int frame) {
    return static_cast<std::uint32_t>(1000 * use + frame);
}

/// Gives the frame halves with independent noise of a standard deviation about its reference, and
/// their mean as reference.
inline void add_reference_noise(PlantedFrame& frame, double deviation, int use, int number) {
    const ImageSize size = frame.reference.size();
    frame.reference_a = frame.reference;
    frame.reference_b = frame.reference;
    add_scaled(*frame.reference_a, make_planted_noise(size, make_seed(use, 2 * number)), deviation);
    add_scaled(*frame.reference_b, make_planted_noise(size, make_seed(use, 2 * number + 1)),
               deviation);
    frame.reference = Image(size, 1);
    add_scaled(frame.reference, *frame.reference_a, 0.5);
    add_scaled(frame.reference, *frame.reference_b, 0.5);
}

/// The values of all frames but the first. Expects that each has one.
[[nodiscard]] inline std::vector<double> list_values(const std::string& name,
                                                     const std::vector<PlantedFrame>& frames) {
    const auto metric = make_temporal(name);
    std::vector<double> values;
    const auto results = follow_planted(*metric, frames);
    EXPECT_FALSE(results.front().has_value()) << "a first frame has no result";
    for (std::size_t t = 1; t < results.size(); ++t) {
        values.push_back(results[t].value().value.value());
    }
    return values;
}

} // namespace alcove
