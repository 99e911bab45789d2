#pragma once
// Least cost over the unit cube without derivatives: a coarse grid, then a local search from its
// best point.
//
// This work is based on: Rowan. Functional stability analysis of numerical algorithms. 1990
// (subplex), as NLopt implements it (Johnson. The NLopt nonlinear-optimization package).

#include <cstdint>
#include <functional>
#include <vector>

namespace alcove {

struct CostEvaluation {
    std::vector<double> point; ///< each coordinate in [0,1]
    double cost = 0.0;
    bool is_grid = false; ///< else of the local search
};

struct MinimiserSettings {
    int evaluations = 48;   ///< at most, grid and search together; 2 or more
    std::uint64_t seed = 1; ///< moves the grid by up to half of a cell
};

struct Minimum {
    std::vector<CostEvaluation> history; ///< in order
    std::size_t best = 0;                ///< of the history
};

/// Points of the grid along each axis: the most of which all together are no more than half of the
/// evaluations, but 2 at least as long as they fit at all.
[[nodiscard]] int count_grid_points(std::size_t dimensions, int evaluations);

/// Same settings and cost, same history. Costs must be finite. Asserts a dimension or more. Throws
/// FailureError if the library fails.
[[nodiscard]] Minimum minimise(std::size_t dimensions, const MinimiserSettings& settings,
                               const std::function<double(const std::vector<double>&)>& cost);

} // namespace alcove
