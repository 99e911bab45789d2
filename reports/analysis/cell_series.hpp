#pragma once
// The times of one round, sorted by what they mean.

#include "reports/analysis/series.hpp"
#include "reports/record/record.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace alcove {

struct CellSeries {
    Series envelope;
    /// Envelopes of held frames; a single is rendered several times in a repeat, each of them a
    /// frame of its own.
    Series converged;
    /// Held frames rendered so far, by segment and repeat.
    std::map<std::pair<int, int>, int> held;
    Series inputs;
    Series compose;
    Series divided; ///< sum of its own passes
    std::vector<std::string> pass_order;
    std::map<std::string, Series> passes; ///< its own and "input/..."
    std::map<std::string, bool> cached;   ///< by pass
};

struct RoundSeries {
    Series base;                             ///< the base G-buffer
    std::map<std::string, CellSeries> cells; ///< by id
};

/// "input/motion": what its inputs cost beyond the base G-buffer.
[[nodiscard]] bool is_input_pass(const std::string& pass);

[[nodiscard]] RoundSeries sort_samples(const std::vector<SampleRow>& samples);

} // namespace alcove
