#include "methods/common/sobol.hpp"

namespace alcove {
namespace {

std::uint32_t reverse_bits(std::uint32_t x) {
    x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
    x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
    x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
    x = ((x >> 8) & 0x00ff00ffu) | ((x & 0x00ff00ffu) << 8);
    return (x >> 16) | (x << 16);
}

/// Each bit is flipped depending on the bits below it only: an Owen scramble of the reversed word.
/// Constants: Vegdahl. Building a better LK hash. 2021.
std::uint32_t permute(std::uint32_t x, std::uint32_t seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
}

/// Second Sobol dimension: direction numbers of the polynomial x + 1, v_{k+1} = v_k ^ (v_k >> 1).
std::uint32_t compute_second_dimension(std::uint32_t index) {
    std::uint32_t result = 0;
    for (std::uint32_t direction = 0x80000000u; index != 0; index >>= 1) {
        if ((index & 1u) != 0) {
            result ^= direction;
        }
        direction ^= direction >> 1;
    }
    return result;
}

/// Finaliser of MurmurHash3 (Appleby, public domain).
std::uint32_t finalise(std::uint32_t h) {
    h ^= h >> 16;
    h *= 0x85ebca6bu;
    h ^= h >> 13;
    h *= 0xc2b2ae35u;
    return h ^ (h >> 16);
}

/// The top 24 bits; as a signed number, whose conversion is one instruction.
float to_unit(std::uint32_t x) {
    return static_cast<float>(static_cast<std::int32_t>(x >> 8)) * 0x1p-24f;
}

/// The scramble of a word that comes with its bits reversed.
float scramble_reversed(std::uint32_t reversed, std::uint32_t seed) {
    return to_unit(reverse_bits(permute(reversed, seed)));
}

} // namespace

std::uint32_t hash_words(std::uint32_t a, std::uint32_t b) {
    // Each word goes through the finaliser of its own: mixed before one finaliser, words that
    // differ in one bit gave both dimensions of a point scrambles that depended on each other.
    return finalise(finalise(a + 0x9e3779b9u) + b * 0x85ebca77u + 0x165667b1u);
}

glm::vec2 compute_scrambled_sobol(std::uint32_t index, std::uint32_t seed) {
    // The first dimension is the index with its bits reversed, so reversed it is the index.
    return {scramble_reversed(index, hash_words(seed, 0u)),
            scramble_reversed(reverse_bits(compute_second_dimension(index)), hash_words(seed, 1u))};
}

SobolBundles::SobolBundles(unsigned count) {
    for (std::uint32_t i = 0; i < (count + kPoints - 1) / kPoints * kPoints; ++i) {
        m_second.push_back(reverse_bits(compute_second_dimension(i)));
    }
}

void SobolBundles::scramble(unsigned first, std::uint32_t seed, Points& points) const {
    const std::uint32_t seed_x = hash_words(seed, 0u);
    const std::uint32_t seed_y = hash_words(seed, 1u);
    const std::uint32_t* const second = m_second.data() + first;
    for (unsigned lane = 0; lane < kPoints; ++lane) {
        points.x[lane] = scramble_reversed(first + lane, seed_x);
        points.y[lane] = scramble_reversed(second[lane], seed_y);
    }
}

} // namespace alcove
