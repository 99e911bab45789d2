#pragma once
// Length along a curve, and the parameter at a length.

#include <functional>
#include <span>
#include <vector>

namespace alcove {

/// Integrates the curve's speed with Gauss-Legendre quadrature over pieces that are halved until
/// both halves agree with the whole to 1e-9: the length is right to that, relative.
class ArcLength {
  public:
    /// `speed` is the length of the curve's derivative, smooth between the knots. Asserts two knots
    /// that ascend.
    ArcLength(std::function<double(double parameter)> speed, std::span<const double> knots);

    [[nodiscard]] double total() const noexcept { return m_total; }
    /// The parameter up to which the curve is `length` long, to 1e-12 of the total. Exact at both
    /// ends. Asserts that the length lies in [0, total].
    [[nodiscard]] double find_parameter(double length) const;

  private:
    struct Piece {
        double begin = 0.0;
        double end = 0.0;
        double length_before = 0.0;
        double length = 0.0;
    };
    [[nodiscard]] double integrate(double begin, double end) const;
    void add_pieces(double begin, double end, double whole, int depth);
    void add_piece(double begin, double end, double length);

    std::function<double(double)> m_speed;
    std::vector<Piece> m_pieces;
    double m_total = 0.0;
};

} // namespace alcove
