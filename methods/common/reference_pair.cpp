#include "methods/common/reference_pair.hpp"

#include <cmath>
#include <cstddef>
#include <span>

namespace alcove {

Image compute_mean(const ReferencePair& pair) {
    Image mean = pair.a;
    const std::span<const float> b = pair.b.values();
    for (std::size_t i = 0; i < b.size(); ++i) {
        mean.values()[i] = 0.5f * (mean.values()[i] + b[i]);
    }
    return mean;
}

double compute_noise(const ReferencePair& pair) {
    double sum = 0.0;
    const std::span<const float> a = pair.a.values();
    const std::span<const float> b = pair.b.values();
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double difference = static_cast<double>(a[i]) - static_cast<double>(b[i]);
        sum += difference * difference;
    }
    return 0.5 * std::sqrt(sum / static_cast<double>(a.size()));
}

} // namespace alcove
