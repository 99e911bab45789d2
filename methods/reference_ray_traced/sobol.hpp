#pragma once
// Owen-scrambled Sobol points in two dimensions: what the reference's rays are distributed by.

#include <cstdint>

#include <glm/vec2.hpp>

namespace alcove {

/// Point `index` of the first two Sobol dimensions, Owen-scrambled by `seed`; in [0,1). Any 2^k first points are
/// stratified in every elementary interval, and different seeds are independent randomisations.
/// This work is based on: Burley. Practical hash-based Owen scrambling. 2020, and the permutation of Laine and Karras.
/// Stratified sampling for stochastic transparency. 2011.
[[nodiscard]] glm::vec2 compute_scrambled_sobol(std::uint32_t index, std::uint32_t seed);

/// A well mixed 32-bit hash of two words.
[[nodiscard]] std::uint32_t hash_words(std::uint32_t a, std::uint32_t b);

} // namespace alcove
