#include "harness/run/error_map.hpp"

#include "core/base/domain.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace alcove {

Image make_error_map(const Image& test, const Image& reference, float range) {
    ALCOVE_ASSERT(test.size() == reference.size(), "images of one size");
    // A diverging scale with equal lightness steps to both sides of a light grey.
    constexpr std::array<float, 3> kZero{0.92f, 0.92f, 0.92f};
    constexpr std::array<float, 3> kTooDark{0.70f, 0.06f, 0.14f};
    constexpr std::array<float, 3> kTooBright{0.08f, 0.28f, 0.72f};
    const Image test_luma = compute_luma(test);
    const Image reference_luma = compute_luma(reference);
    Image map(test.size(), 3);
    for (int y = 0; y < map.height(); ++y) {
        for (int x = 0; x < map.width(); ++x) {
            const float error = test_luma.at(x, y) - reference_luma.at(x, y);
            const auto& end = error < 0.0f ? kTooDark : kTooBright;
            // The square root lifts small errors, which are the most frequent.
            const float weight = std::sqrt(std::min(std::abs(error) / range, 1.0f));
            for (int c = 0; c < 3; ++c) {
                const auto i = static_cast<std::size_t>(c);
                map.at(x, y, c) = kZero.at(i) + weight * (end.at(i) - kZero.at(i));
            }
        }
    }
    return map;
}

} // namespace alcove
