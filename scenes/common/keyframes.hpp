#pragma once
// Values that change over time by keys: the samplers of glTF 2.0, 3.11 and appendix C.

#include <cstddef>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

namespace alcove {

enum class KeyInterpolation { step, linear, cubic };

/// Before the first key and after the last one the value is that key's.
struct Keyframes {
    KeyInterpolation interpolation = KeyInterpolation::linear;
    std::size_t components = 1;
    std::vector<double> times_s; ///< ascending, at least one
    /// `components` a key; with `cubic` three times as many: slope before, value, slope after, with
    /// slopes per second.
    std::vector<float> values;
};

/// In double, from the time alone. Asserts that there are as many values as times call for.
[[nodiscard]] std::vector<double> evaluate_numbers(const Keyframes& keys, double time_s);
/// Asserts three components.
[[nodiscard]] glm::dvec3 evaluate_vector(const Keyframes& keys, double time_s);
/// x, y, z, w; unit. `linear` turns at constant speed the short way. Asserts four components.
[[nodiscard]] glm::dquat evaluate_rotation(const Keyframes& keys, double time_s);

} // namespace alcove
