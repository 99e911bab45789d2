#include "methods/common/energy_runs.hpp"

#include "core/base/assert.hpp"

#include <bit>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace alcove {
namespace {

/// Step `index` of the curve through a square of `side` cells, a power of two.
std::pair<int, int> place_on_curve(std::size_t index, int side) {
    int x = 0;
    int y = 0;
    for (int cell = 1; cell < side; cell *= 2) {
        const bool is_right = (index & 2) != 0;
        const bool is_upper = is_right != ((index & 1) != 0);
        if (!is_upper) {
            if (is_right) {
                x = cell - 1 - x;
                y = cell - 1 - y;
            }
            std::swap(x, y);
        }
        x += is_right ? cell : 0;
        y += is_upper ? cell : 0;
        index /= 4;
    }
    return {x, y};
}

} // namespace

std::vector<std::size_t> order_along_curve(int side) {
    const auto cells = static_cast<int>(std::bit_ceil(static_cast<unsigned>(side)));
    std::vector<std::size_t> order;
    order.reserve(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
    const std::size_t steps = static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells);
    for (std::size_t i = 0; i < steps; ++i) {
        const auto [x, y] = place_on_curve(i, cells);
        if (x < side && y < side) {
            order.push_back(static_cast<std::size_t>(x) +
                            static_cast<std::size_t>(side) * static_cast<std::size_t>(y));
        }
    }
    return order;
}

std::vector<std::size_t> cut_into_runs(std::span<const double> energies, int count) {
    ALCOVE_ASSERT(count > 0, "a run or more");
    const double total = std::accumulate(energies.begin(), energies.end(), 0.0);
    std::vector<std::size_t> ends;
    if (total <= 0.0) {
        return ends;
    }
    double sum = 0.0;
    std::optional<double> last;
    for (std::size_t i = 0; i < energies.size(); ++i) {
        if (energies[i] > 0.0) {
            // The middle of its energy says which run a texel belongs to.
            const double run = std::floor((sum + 0.5 * energies[i]) / total * count);
            if (last && run != *last) {
                ends.push_back(i);
            }
            last = run;
            sum += energies[i];
        }
    }
    ends.push_back(energies.size());
    return ends;
}

} // namespace alcove
