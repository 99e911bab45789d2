#pragma once
// Powers for loops that a compiler turns into vector instructions: no branches, no tables, no
// calls.

#include <bit>
#include <cstdint>
#include <numbers>

namespace alcove {

/// log2 of a positive normal number, absolute error under 4e-7 for 1e-6..1: exponent plus the
/// atanh series of the mantissa in [sqrt(1/2), sqrt(2)), whose first left-out term is below 1e-9.
[[nodiscard]] inline float compute_log2(float x) {
    constexpr std::uint32_t kRootHalf = 0x3f3504f3; // bits of sqrt(1/2)
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(x) - kRootHalf;
    const auto exponent = static_cast<float>(static_cast<std::int32_t>(bits) >> 23);
    const float mantissa = std::bit_cast<float>((bits & 0x007fffffu) + kRootHalf);
    const float s = (mantissa - 1.0f) / (mantissa + 1.0f);
    const float s2 = s * s;
    constexpr auto kTwoOverLn2 = static_cast<float>(2.0 / std::numbers::ln2);
    const float series =
        s + s * s2 * (1.0f / 3.0f + s2 * (1.0f / 5.0f + s2 * (1.0f / 7.0f + s2 * (1.0f / 9.0f))));
    return exponent + kTwoOverLn2 * series;
}

/// 2^x for -126 <= x < 127, relative error under 2e-7: Taylor series of the rest after rounding to
/// an integer, |rest| <= 1/2, whose first left-out term is below 6e-9.
[[nodiscard]] inline float compute_exp2(float x) {
    constexpr float kRound = 12582912.0f; // 1.5 * 2^23: adding it leaves the nearest integer
    const float shifted = x + kRound;
    const float rest = (x - (shifted - kRound)) * static_cast<float>(std::numbers::ln2);
    const float series =
        1.0f +
        rest * (1.0f + rest * (1.0f / 2.0f +
                               rest * (1.0f / 6.0f +
                                       rest * (1.0f / 24.0f +
                                               rest * (1.0f / 120.0f +
                                                       rest * (1.0f / 720.0f + rest / 5040.0f))))));
    const std::uint32_t power = (std::bit_cast<std::uint32_t>(shifted) - 0x4b400000u) << 23;
    return std::bit_cast<float>(std::bit_cast<std::uint32_t>(series) + power);
}

/// x^exponent for x in 0..1e6 and an exponent in 0..3; 0 for x below 1e-12. Relative error under
/// 1e-6, see the test.
[[nodiscard]] inline float compute_pow(float x, float exponent) {
    constexpr float kSmallest = 1e-12f;
    const float base = x < kSmallest ? kSmallest : x;
    const float power = compute_exp2(exponent * compute_log2(base));
    return x < kSmallest ? 0.0f : power;
}

} // namespace alcove
