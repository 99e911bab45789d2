#include "metrics/common/row_bands.hpp"

#include <algorithm>
#include <thread>
#include <vector>

namespace alcove {

void for_row_bands(int rows, const std::function<void(int begin, int end)>& work) {
    constexpr int kSmallestBand = 64; // starting a thread costs as much as some rows
    constexpr unsigned kMostBands = 64;
    const auto cores =
        static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, kMostBands));
    const int bands = std::clamp(rows / kSmallestBand, 1, cores);
    const auto begin_of = [rows, bands](int band) { return rows * band / bands; };
    std::vector<std::jthread> threads;
    for (int band = 1; band < bands; ++band) {
        threads.emplace_back(work, begin_of(band), begin_of(band + 1));
    }
    work(0, begin_of(1));
}

} // namespace alcove
