#include "scenes/common/keyframes.hpp"

#include "core/base/assert.hpp"

#include <algorithm>
#include <cmath>

namespace alcove {
namespace {

/// The two keys around a time and how far it is between them.
struct Span {
    std::size_t first = 0;
    std::size_t second = 0;
    double share = 0.0; ///< in [0,1); 0 exactly on a key
    double length_s = 0.0;
};

Span find_span(const Keyframes& keys, double time_s) {
    const std::size_t parts = keys.interpolation == KeyInterpolation::cubic ? 3 : 1;
    ALCOVE_ASSERT(!keys.times_s.empty() &&
                      keys.values.size() == keys.times_s.size() * keys.components * parts,
                  "values for every key");
    const std::vector<double>& times = keys.times_s;
    const auto after = std::upper_bound(times.begin(), times.end(), time_s);
    if (after == times.begin()) {
        return {};
    }
    const auto first = static_cast<std::size_t>(after - times.begin()) - 1;
    if (after == times.end()) {
        return {first, first, 0.0, 0.0};
    }
    const double length_s = *after - times[first];
    return {first, first + 1, (time_s - times[first]) / length_s, length_s};
}

double get_value(const Keyframes& keys, std::size_t key, std::size_t component) {
    const bool is_cubic = keys.interpolation == KeyInterpolation::cubic;
    return keys.values[(is_cubic ? 3 * key + 1 : key) * keys.components + component];
}

double interpolate(const Keyframes& keys, const Span& span, std::size_t component) {
    const double a = get_value(keys, span.first, component);
    if (span.share == 0.0 || keys.interpolation == KeyInterpolation::step) {
        return a;
    }
    const double b = get_value(keys, span.second, component);
    const double s = span.share;
    if (keys.interpolation == KeyInterpolation::linear) {
        return a + s * (b - a);
    }
    const double slope_a =
        span.length_s *
        static_cast<double>(keys.values[(3 * span.first + 2) * keys.components + component]);
    const double slope_b =
        span.length_s *
        static_cast<double>(keys.values[3 * span.second * keys.components + component]);
    const double s2 = s * s;
    const double s3 = s2 * s;
    return (2.0 * s3 - 3.0 * s2 + 1.0) * a + (s3 - 2.0 * s2 + s) * slope_a +
           (3.0 * s2 - 2.0 * s3) * b + (s3 - s2) * slope_b;
}

glm::dquat get_rotation(const Keyframes& keys, std::size_t key) {
    const glm::dquat rotation(get_value(keys, key, 3), get_value(keys, key, 0),
                              get_value(keys, key, 1), get_value(keys, key, 2));
    return glm::normalize(rotation);
}

} // namespace

std::vector<double> evaluate_numbers(const Keyframes& keys, double time_s) {
    const Span span = find_span(keys, time_s);
    std::vector<double> numbers(keys.components);
    for (std::size_t i = 0; i < keys.components; ++i) {
        numbers[i] = interpolate(keys, span, i);
    }
    return numbers;
}

glm::dvec3 evaluate_vector(const Keyframes& keys, double time_s) {
    ALCOVE_ASSERT(keys.components == 3, "keys of vectors");
    const Span span = find_span(keys, time_s);
    return {interpolate(keys, span, 0), interpolate(keys, span, 1), interpolate(keys, span, 2)};
}

glm::dquat evaluate_rotation(const Keyframes& keys, double time_s) {
    ALCOVE_ASSERT(keys.components == 4, "keys of quaternions");
    const Span span = find_span(keys, time_s);
    if (keys.interpolation == KeyInterpolation::linear && span.share != 0.0) {
        // glm::slerp takes the short way.
        return glm::normalize(glm::slerp(get_rotation(keys, span.first),
                                         get_rotation(keys, span.second), span.share));
    }
    return glm::normalize(glm::dquat(interpolate(keys, span, 3), interpolate(keys, span, 0),
                                     interpolate(keys, span, 1), interpolate(keys, span, 2)));
}

} // namespace alcove
