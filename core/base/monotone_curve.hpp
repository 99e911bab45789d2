#pragma once
// The best monotone curve from one image's values to another's: what a slider, a power or any curve
// of that kind could mend at most.
//
// This work is based on: Ayer, Brunk, Ewing, Reid, Silverman. An empirical distribution function
// for sampling with incomplete information. 1955 (pool adjacent violators).

#include <span>
#include <vector>

namespace alcove {

/// A curve that never falls, as its support points, ascending in x; linear between them, constant
/// beyond the ends.
struct MonotoneCurve {
    std::vector<double> x;
    std::vector<double> y;
    /// Asserts that there is a point.
    [[nodiscard]] double evaluate(double at) const;
};

/// The non-decreasing sequence nearest to `values` in weighted squares. Asserts equal sizes and
/// weights above 0.
[[nodiscard]] std::vector<double> fit_isotonic(std::span<const double> values,
                                               std::span<const double> weights);

/// Pairs (x, y) with x in [0,1], kept as moments of y in kBins bins of x: memory does not depend on
/// their number, and a bin's width is a quarter of an 8-bit code.
class CurveMoments {
  public:
    static constexpr int kBins = 1024;
    CurveMoments();

    /// Asserts equal sizes. x outside of [0,1] counts as the end.
    void add(std::span<const float> x, std::span<const float> y);
    void add(const CurveMoments& other);
    [[nodiscard]] double count() const noexcept { return m_count; }

    /// The best curve for these pairs. Asserts that there are any.
    [[nodiscard]] MonotoneCurve fit() const;
    /// Mean (y - curve(x))^2 with x at the mean of its bin.
    [[nodiscard]] double compute_mse(const MonotoneCurve& curve) const;
    /// Mean (y - x)^2, exact.
    [[nodiscard]] double compute_mse() const;

  private:
    struct Bin {
        double count = 0.0;
        double x = 0.0;
        double y = 0.0;
        double y_squared = 0.0;
    };
    std::vector<Bin> m_bins;
    double m_count = 0.0;
    double m_squares = 0.0; ///< sum of (y - x)^2
};

} // namespace alcove
