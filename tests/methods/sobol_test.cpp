// The points that the reference's rays are distributed by.
#include "methods/common/sobol.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace alcove {
namespace {

TEST(ScrambledSobol, EveryElementaryIntervalHoldsOneOfTheFirstPowerOfTwoPoints) {
    for (const std::uint32_t seed : {0u, 1u, 0xdeadbeefu}) {
        for (unsigned k = 0; k <= 10; ++k) {
            const std::uint32_t count = 1u << k;
            for (unsigned a = 0; a <= k; ++a) {
                const std::uint32_t columns = 1u << a;
                const std::uint32_t rows = 1u << (k - a);
                std::vector<int> hits(count, 0);
                for (std::uint32_t i = 0; i < count; ++i) {
                    const glm::vec2 u = compute_scrambled_sobol(i, seed);
                    const auto column =
                        static_cast<std::uint32_t>(u.x * static_cast<float>(columns));
                    const auto row = static_cast<std::uint32_t>(u.y * static_cast<float>(rows));
                    ++hits.at(row * columns + column);
                }
                ASSERT_EQ(hits, std::vector<int>(count, 1))
                    << "seed " << seed << " k " << k << " a " << a;
            }
        }
    }
}

TEST(ScrambledSobol, LaterBlocksAreStratifiedToo) {
    // Block j of 64 points, as the bundles of more rays go on.
    for (std::uint32_t block = 1; block < 8; ++block) {
        std::vector<int> hits(64, 0);
        for (std::uint32_t i = 0; i < 64; ++i) {
            const glm::vec2 u = compute_scrambled_sobol(64 * block + i, 5u);
            ++hits.at(static_cast<std::size_t>(u.x * 8.0f) * 8 +
                      static_cast<std::size_t>(u.y * 8.0f));
        }
        ASSERT_EQ(hits, std::vector<int>(64, 1)) << block;
    }
}

/// Chi square of counts against equal expectations.
double compute_chi_square(const std::vector<int>& counts, double expected) {
    double sum = 0.0;
    for (const int count : counts) {
        sum += (count - expected) * (count - expected) / expected;
    }
    return sum;
}

TEST(ScrambledSobol, APointIsUniformOverSeeds) {
    // 16 x 16 cells, 65,536 seeds: 255 degrees of freedom, standard deviation 22.6. 255 + 5 x 22.6
    // = 368.
    constexpr int kCells = 16;
    constexpr std::uint32_t kSeeds = 65536;
    for (const std::uint32_t index : {0u, 1u, 37u}) {
        std::vector<int> counts(kCells * kCells, 0);
        for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
            const glm::vec2 u = compute_scrambled_sobol(index, seed);
            ASSERT_TRUE(u.x >= 0.0f && u.x < 1.0f && u.y >= 0.0f && u.y < 1.0f);
            ++counts.at(static_cast<std::size_t>(u.x * kCells) * kCells +
                        static_cast<std::size_t>(u.y * kCells));
        }
        const double chi_square = compute_chi_square(counts, kSeeds / 256.0);
        RecordProperty("chi_square_" + std::to_string(index), std::to_string(chi_square));
        EXPECT_LT(chi_square, 368.0) << index;
    }
}

TEST(ScrambledSobol, MeansOfDifferentSeedsAreIndependentAndCentred) {
    // Each mean of 16 points of x y (expectation 1/4) as a draw: neighbouring seeds do not
    // correlate, and the mean over 20,000 draws is 1/4. Five standard errors each.
    constexpr int kDraws = 20000;
    std::vector<double> draws;
    for (std::uint32_t seed = 0; seed < kDraws; ++seed) {
        double sum = 0.0;
        for (std::uint32_t i = 0; i < 16; ++i) {
            const glm::vec2 u = compute_scrambled_sobol(i, seed);
            sum += static_cast<double>(u.x) * static_cast<double>(u.y);
        }
        draws.push_back(sum / 16.0 - 0.25);
    }
    double sum = 0.0;
    double squares = 0.0;
    for (const double draw : draws) {
        sum += draw;
        squares += draw * draw;
    }
    EXPECT_LT(std::abs(sum / kDraws), 5.0 * std::sqrt(squares / kDraws / kDraws));
    for (const std::size_t lag : {1u, 2u, 256u}) {
        double products = 0.0;
        for (std::size_t i = 0; i + lag < draws.size(); ++i) {
            products += draws[i] * draws[i + lag];
        }
        EXPECT_LT(std::abs(products / squares), 5.0 / std::sqrt(double{kDraws})) << lag;
    }
}

TEST(HashWords, NeighboursInEitherWordDifferInHalfTheirBits) {
    // 4,096 pairs of 32 bits: the mean share of changed bits is 1/2 within 5 x 0.5 / sqrt(131,072)
    // = 0.007; 0.02 leaves room for a hash that is good, not perfect.
    int changed_a = 0;
    int changed_b = 0;
    for (std::uint32_t i = 0; i < 4096; ++i) {
        changed_a += __builtin_popcount(hash_words(i, 9u) ^ hash_words(i + 1, 9u));
        changed_b += __builtin_popcount(hash_words(9u, i) ^ hash_words(9u, i + 1));
    }
    EXPECT_NEAR(changed_a / (4096.0 * 32.0), 0.5, 0.02);
    EXPECT_NEAR(changed_b / (4096.0 * 32.0), 0.5, 0.02);
}

} // namespace
} // namespace alcove
