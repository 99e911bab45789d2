#pragma once
// When does a number of tonight lie outside what its own history lets one expect? Pure functions
// over one series.
//
// The fence follows rustc-perf: a difference counts beyond Q3 + 3 IQR of the last differences of
// that very series, so that a noisy series has a wide one and a quiet one a narrow one.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace alcove {

/// A night is held against the median of so many nights before it, none older than the last
/// accepted step.
inline constexpr std::size_t kBaselineNights = 5;
/// The fence is made of so many differences,
inline constexpr std::size_t kFenceDifferences = 30;
/// and of no fewer than these: under them nothing is said.
inline constexpr std::size_t kFewestDifferences = 8;
/// Least fence of a metric, relative to its baseline. Images are deterministic on one device, so
/// their differences are 0 and a fence made of them too; another order of summation changes a mean
/// of 1e5 doubles by some 1e-12 and one kept in float by 1e-7.
inline constexpr double kQualityFence = 1e-6;

struct HistoryRule {
    bool is_logarithmic = false; ///< differences of logarithms; values are positive
    double relative_fence = 0.0; ///< least fence over |baseline|; for linear series
};

struct HistoryPoint {
    double value = 0.0;
    std::int64_t segment = 0; ///< points of different segments are never compared
    bool is_step = false;     ///< an accepted step: the baseline begins anew here
};

/// One night as its past lets one judge it. Differences and fences are logarithms where the rule is
/// logarithmic.
struct HistoryNight {
    std::optional<double> baseline;   ///< in the series' unit; none: the first of its segment
    std::optional<double> difference; ///< value - baseline
    std::optional<double> fence;      ///< none: too little history
    std::size_t past_differences = 0; ///< that the fence could be made of

    [[nodiscard]] bool is_beyond() const;
};

/// Every night of a series, in order, each judged by those before it in its own segment. Steps'
/// own differences are no noise and make no fence.
[[nodiscard]] std::vector<HistoryNight> replay_history(std::span<const HistoryPoint> points,
                                                       const HistoryRule& rule);

/// value - baseline, or the log of their ratio.
[[nodiscard]] double compute_difference(double value, double baseline, const HistoryRule& rule);

/// Does a second measurement of the same night say the same: the same side, beyond the fence?
[[nodiscard]] bool is_repeated(const HistoryNight& night, double second, const HistoryRule& rule);

} // namespace alcove
