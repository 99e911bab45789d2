#pragma once
// Owen-scrambled Sobol points in two dimensions: what the reference's rays are distributed by.

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

namespace alcove {

/// Point `index` of the first two Sobol dimensions, Owen-scrambled by `seed`; in [0,1). Any 2^k
/// first points are stratified in every elementary interval, and different seeds are independent
/// randomisations. This work is based on: Burley. Practical hash-based Owen scrambling. 2020, and
/// the permutation of Laine and Karras. Stratified sampling for stochastic transparency. 2011.
[[nodiscard]] glm::vec2 compute_scrambled_sobol(std::uint32_t index, std::uint32_t seed);

/// compute_scrambled_sobol for many seeds, 16 points at a time: what depends on the index alone is
/// made once.
class SobolBundles {
  public:
    static constexpr unsigned kPoints = 16;
    struct Points {
        alignas(64) std::array<float, kPoints> x;
        alignas(64) std::array<float, kPoints> y;
    };
    /// Points 0 to count - 1, rounded up to whole bundles.
    explicit SobolBundles(unsigned count);
    /// Points `first` to `first + 15`; `first` is a multiple of 16.
    void scramble(unsigned first, std::uint32_t seed, Points& points) const;

  private:
    std::vector<std::uint32_t> m_second; ///< the second dimension with its bits reversed
};

/// A well mixed 32-bit hash of two words.
[[nodiscard]] std::uint32_t hash_words(std::uint32_t a, std::uint32_t b);

} // namespace alcove
