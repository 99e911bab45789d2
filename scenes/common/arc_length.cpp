#include "scenes/common/arc_length.hpp"

#include "core/base/assert.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace alcove {
namespace {

constexpr double kTolerance = 1e-9;
/// Halvings: only at a cusp, where the speed has a corner, are they used up.
constexpr int kDeepest = 40;

struct Node {
    double place = 0.0; ///< in [-1,1]
    double weight = 0.0;
};

/// Gauss-Legendre, exact for polynomials of degree 9 (M. Abramowitz, I. Stegun. Handbook of
/// Mathematical Functions. 1964, table 25.4; closed form).
std::array<Node, 5> make_nodes() {
    const double root = 2.0 * std::sqrt(10.0 / 7.0);
    const double inner = std::sqrt(5.0 - root) / 3.0;
    const double outer = std::sqrt(5.0 + root) / 3.0;
    const double inner_weight = (322.0 + 13.0 * std::sqrt(70.0)) / 900.0;
    const double outer_weight = (322.0 - 13.0 * std::sqrt(70.0)) / 900.0;
    return {{{-outer, outer_weight},
             {-inner, inner_weight},
             {0.0, 128.0 / 225.0},
             {inner, inner_weight},
             {outer, outer_weight}}};
}

} // namespace

ArcLength::ArcLength(std::function<double(double parameter)> speed, std::span<const double> knots)
    : m_speed(std::move(speed)) {
    ALCOVE_ASSERT(knots.size() > 1, "a curve has two knots");
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
        ALCOVE_ASSERT(knots[i] < knots[i + 1], "knots ascend");
        add_pieces(knots[i], knots[i + 1], integrate(knots[i], knots[i + 1]), kDeepest);
    }
}

double ArcLength::integrate(double begin, double end) const {
    static const std::array<Node, 5> kNodes = make_nodes();
    const double middle = 0.5 * (begin + end);
    const double half = 0.5 * (end - begin);
    double sum = 0.0;
    for (const Node& node : kNodes) {
        sum += node.weight * m_speed(middle + half * node.place);
    }
    return sum * half;
}

void ArcLength::add_pieces(double begin, double end, double whole, int depth) {
    const double middle = 0.5 * (begin + end);
    const double left = integrate(begin, middle);
    const double right = integrate(middle, end);
    if (depth == 0 || std::abs(left + right - whole) <= kTolerance * (left + right)) {
        add_piece(begin, middle, left);
        add_piece(middle, end, right);
    } else {
        add_pieces(begin, middle, left, depth - 1);
        add_pieces(middle, end, right, depth - 1);
    }
}

void ArcLength::add_piece(double begin, double end, double length) {
    m_pieces.push_back({begin, end, m_total, length});
    m_total += length;
}

double ArcLength::find_parameter(double length) const {
    ALCOVE_ASSERT(length >= 0.0 && length <= m_total, "a length within the curve");
    if (length == 0.0) {
        return m_pieces.front().begin;
    }
    if (length == m_total) {
        return m_pieces.back().end;
    }
    const auto after = std::upper_bound(
        m_pieces.begin(), m_pieces.end(), length,
        [](double wanted, const Piece& piece) { return wanted < piece.length_before; });
    const Piece& piece = *(after - 1);
    // Newton's method, kept within a bracket that shrinks.
    const double wanted = length - piece.length_before;
    double low = piece.begin;
    double high = piece.end;
    double parameter = low + (high - low) * std::min(1.0, wanted / piece.length);
    constexpr int kMostSteps = 60; // bisection alone is down to the last bit by then
    for (int step = 0; step < kMostSteps; ++step) {
        const double error = integrate(piece.begin, parameter) - wanted;
        if (std::abs(error) <= 1e-12 * m_total) {
            break;
        }
        (error > 0.0 ? high : low) = parameter;
        const double next = parameter - error / m_speed(parameter);
        parameter = next > low && next < high ? next : 0.5 * (low + high);
    }
    return parameter;
}

} // namespace alcove
