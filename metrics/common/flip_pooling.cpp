// This work is based on: Andersson, Nilsson, Shirley, Akenine-Moller. Visualizing and Communicating
// Errors in Rendered Images. 2021.
#include "metrics/common/flip_pooling.hpp"

#include <algorithm>
#include <array>

namespace alcove {
namespace {

constexpr std::size_t kBins = 100;
using Histogram = std::array<double, kBins>; ///< counts

Histogram count_bins(const std::vector<float>& errors) {
    Histogram counts{};
    for (const float error : errors) {
        const auto bin = static_cast<std::size_t>(static_cast<double>(error) * kBins);
        counts.at(std::min(bin, kBins - 1)) += 1.0;
    }
    return counts;
}

double find_weighted_quantile(const Histogram& counts, double share) {
    const auto get_weight = [&counts](std::size_t bin) {
        return counts.at(bin) * (static_cast<double>(bin) + 0.5) / kBins;
    };
    double total = 0.0;
    for (std::size_t bin = 0; bin < kBins; ++bin) {
        total += get_weight(bin);
    }
    double below = 0.0;
    std::size_t bin = 0;
    while (bin + 1 < kBins && below + get_weight(bin) <= share * total) {
        below += get_weight(bin);
        ++bin;
    }
    return (static_cast<double>(bin) + (share * total - below) / get_weight(bin)) / kBins;
}

} // namespace

MetricResult pool_flip_map(Image map, const Image* mask) {
    const PooledRegion region(mask, map.size());
    MetricResult result;
    region.report(result);
    if (region.count() > 0) {
        std::vector<double> sums;
        for (int y = 0; y < map.height(); ++y) {
            sums.push_back(region.sum_row(y, map.values().data() +
                                                 static_cast<std::ptrdiff_t>(y) * map.width()));
        }
        result.value = region.compute_mean(sums);
        const std::vector<float> errors = list_counted(map, region);
        const auto [least, largest] = std::minmax_element(errors.begin(), errors.end());
        const Histogram counts = count_bins(errors);
        const auto find = [&](double share) {
            return *largest > 0.0f ? find_weighted_quantile(counts, share) : 0.0;
        };
        result.extras = {{"weighted_median", find(0.5)},
                         {"weighted_quartile_1", find(0.25)},
                         {"weighted_quartile_3", find(0.75)},
                         {"min", static_cast<double>(*least)},
                         {"max", static_cast<double>(*largest)}};
    }
    result.map = std::move(map);
    return result;
}

} // namespace alcove
