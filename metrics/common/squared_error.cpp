#include "metrics/common/squared_error.hpp"

namespace alcove {
namespace {

/// mean of (a - b)(c - d)
double compute_mean_product(const Image& a, const Image& b, const Image& c, const Image& d,
                            const PooledRegion& region) {
    const auto channels = static_cast<std::size_t>(a.channels());
    std::size_t i = 0;
    double sum = 0.0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x, i += channels) {
            if (!region.is_counted(x, y)) {
                continue;
            }
            for (std::size_t k = i; k < i + channels; ++k) {
                const double first =
                    static_cast<double>(a.values()[k]) - static_cast<double>(b.values()[k]);
                const double second =
                    static_cast<double>(c.values()[k]) - static_cast<double>(d.values()[k]);
                sum += first * second;
            }
        }
    }
    return sum / static_cast<double>(region.count() * channels);
}

} // namespace

SquaredError compute_squared_error(const MetricInput& input, const PooledRegion& region) {
    ALCOVE_ASSERT(region.count() > 0 && region.size() == input.test.size(), "pixels to pool");
    SquaredError error;
    error.mean =
        compute_mean_product(input.test, input.reference, input.test, input.reference, region);
    if (input.reference_a != nullptr) {
        const Image& a = *input.reference_a;
        const Image& b = *input.reference_b;
        error.debiased = compute_mean_product(input.test, a, input.test, b, region);
        error.noise = 0.25 * compute_mean_product(a, b, a, b, region);
    }
    return error;
}

Image make_squared_error_map(const MetricInput& input) {
    Image map(input.test.size(), 1);
    const auto channels = static_cast<std::size_t>(input.test.channels());
    for (std::size_t i = 0; i < map.values().size(); ++i) {
        float sum = 0.0f;
        for (std::size_t c = 0; c < channels; ++c) {
            const float difference =
                input.test.values()[i * channels + c] - input.reference.values()[i * channels + c];
            sum += difference * difference;
        }
        map.values()[i] = sum / static_cast<float>(channels);
    }
    return map;
}

} // namespace alcove
