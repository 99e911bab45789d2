#include "metrics/common/filter_row.hpp"

#include "core/base/assert.hpp"
#include "metrics/common/clones.hpp"

#include <cstdlib>
#include <cstring>

namespace alcove {
namespace {

/// As many floats as the widest registers of today hold; narrower ones take several. The sums stay
/// in registers over all taps, where a loop over a row for each tap would wait for memory.
using Lanes [[gnu::vector_size(64)]] = float;
constexpr std::size_t kLanes = sizeof(Lanes) / sizeof(float);
static_assert(kFilterBlock == 2 * kLanes);

inline void load(Lanes& lanes, const float* from) {
    std::memcpy(&lanes, from, sizeof lanes);
}

inline void store(const Lanes& lanes, float* to) {
    std::memcpy(to, &lanes, sizeof lanes);
}

inline void begin_block(bool add, const float* out, Lanes& low, Lanes& high) {
    low = Lanes{};
    high = Lanes{};
    if (add) {
        load(low, out);
        load(high, out + kLanes);
    }
}

ALCOVE_CLONES void filter_block_rows(const float* weights, std::size_t tap_count,
                                     const float* const* taps, std::size_t count, bool add,
                                     float* out) {
    for (std::size_t i = 0; i < count; i += kFilterBlock) {
        Lanes low;
        Lanes high;
        begin_block(add, out + i, low, high);
        for (std::size_t k = 0; k < tap_count; ++k) {
            Lanes a;
            Lanes b;
            load(a, taps[k] + i);
            load(b, taps[k] + i + kLanes);
            low += weights[k] * a;
            high += weights[k] * b;
        }
        store(low, out + i);
        store(high, out + i + kLanes);
    }
}

} // namespace

void filter_row(FilterKind kind, const HalfFilter& filter, const float* const* taps,
                std::size_t count, bool add, float* out) {
    ALCOVE_ASSERT(count % kFilterBlock == 0, "whole blocks");
    const int radius = filter.radius();
    std::vector<float> weights;
    for (int k = -radius; k <= radius; ++k) {
        const float weight = filter.weights[static_cast<std::size_t>(std::abs(k))];
        weights.push_back(kind == FilterKind::odd && k < 0 ? -weight : weight);
    }
    filter_block_rows(weights.data(), weights.size(), taps - radius, count, add, out);
}

} // namespace alcove
