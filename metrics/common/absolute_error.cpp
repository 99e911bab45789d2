#include "metrics/common/absolute_error.hpp"

#include <cmath>

namespace alcove {
namespace {

std::vector<float> list_differences(const Image& a, const Image& b, const PooledRegion& region,
                                    float scale) {
    std::vector<float> differences;
    differences.reserve(region.count() * static_cast<std::size_t>(a.channels()));
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            for (int c = 0; c < a.channels() && region.is_counted(x, y); ++c) {
                differences.push_back(scale * std::abs(a.at(x, y, c) - b.at(x, y, c)));
            }
        }
    }
    return differences;
}

Image make_map(const Image& a, const Image& b) {
    Image map(a.size(), 1);
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            float sum = 0.0f;
            for (int c = 0; c < a.channels(); ++c) {
                sum += std::abs(a.at(x, y, c) - b.at(x, y, c));
            }
            map.at(x, y) = sum / static_cast<float>(a.channels());
        }
    }
    return map;
}

} // namespace

MetricResult pool_absolute_error(const MetricInput& input,
                                 const std::function<double(std::vector<float>&)>& pool) {
    const PooledRegion region(input.mask, input.test.size());
    MetricResult result;
    region.report(result);
    result.map = make_map(input.test, input.reference);
    if (region.count() == 0) {
        return result;
    }
    std::vector<float> differences = list_differences(input.test, input.reference, region, 1.0f);
    result.value = pool(differences);
    if (input.reference_a != nullptr) {
        std::vector<float> noise =
            list_differences(*input.reference_a, *input.reference_b, region, 0.5f);
        result.floor = pool(noise);
    }
    return result;
}

} // namespace alcove
