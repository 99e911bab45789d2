#include "tests/benchmark/ratio.hpp"

#include "core/base/statistics.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>

namespace alcove {

double time_call(const std::function<void()>& call) {
    const auto begin = std::chrono::steady_clock::now();
    call();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

std::vector<double> time_in_turn(const std::function<void()>& a, const std::function<void()>& b,
                                 int count) {
    a();
    b();
    std::vector<double> ratios;
    for (int i = 0; i < count; ++i) {
        const double first = time_call(a);
        ratios.push_back(first / time_call(b));
    }
    return ratios;
}

bool print_target(const std::string& name, double bound, bool at_least,
                  const std::vector<double>& ratios) {
    const double median = compute_median(ratios);
    const auto [low, high] = std::minmax_element(ratios.begin(), ratios.end());
    const bool met = at_least ? median >= bound : median <= bound;
    std::printf("%-52s | %s %-6.4g | %8.4g (%.4g..%.4g) | n=%zu | %s\n", name.c_str(),
                at_least ? ">=" : "<=", bound, median, *low, *high, ratios.size(),
                met ? "met" : "NOT MET");
    std::fflush(stdout);
    return met;
}

} // namespace alcove
