#include "scenes/common/camera_curve.hpp"

#include "core/base/assert.hpp"

#include <algorithm>
#include <functional>
#include <type_traits>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace alcove {
namespace {

/// Slope at knot 1 of the parabola through three knots at times 0, h0 and h0 + h1, of slopes d0 and
/// d1.
template <class T>
T parabola_slope(const T& d0, const T& d1, double h0, double h1) {
    return (d0 * h1 + d1 * h0) / (h0 + h1);
}

/// Slope that keeps a cubic between its knots (F. N. Fritsch, J. Butland. A Method for Constructing
/// Local Monotone Piecewise Cubic Interpolants. 1984): the weighted harmonic mean, 0 at a turning
/// point.
double monotone_slope(double d0, double d1, double h0, double h1) {
    if (!(d0 * d1 > 0.0)) {
        return 0.0;
    }
    return 3.0 * (h0 + h1) / ((2.0 * h1 + h0) / d0 + (h1 + 2.0 * h0) / d1);
}

template <class T>
T hermite(const T& a, const T& b, const T& slope_a, const T& slope_b, double span, double s) {
    if (a == b && slope_a == T(0.0) && slope_b == T(0.0)) {
        return a; // the weights below add up to 1 only up to a bit
    }
    const double s2 = s * s;
    const double s3 = s2 * s;
    return a * (2.0 * s3 - 3.0 * s2 + 1.0) + slope_a * (span * (s3 - 2.0 * s2 + s)) +
           b * (3.0 * s2 - 2.0 * s3) + slope_b * (span * (s3 - s2));
}

} // namespace

CameraCurve::CameraCurve(std::vector<double> knots, std::vector<CameraPose> keys)
    : m_knots(std::move(knots)), m_keys(std::move(keys)) {
    ALCOVE_ASSERT(!m_keys.empty() && m_knots.size() == m_keys.size(), "one knot a key");
    ALCOVE_ASSERT(std::adjacent_find(m_knots.begin(), m_knots.end(), std::greater_equal<>{}) ==
                      m_knots.end(),
                  "knots ascend");
}

/// The last key at or before the parameter.
std::size_t CameraCurve::find_span(double parameter) const {
    ALCOVE_ASSERT(parameter >= m_knots.front() && parameter <= m_knots.back(),
                  "a parameter within the knots");
    const auto after = std::upper_bound(m_knots.begin(), m_knots.end(), parameter);
    return static_cast<std::size_t>(after - m_knots.begin()) - 1;
}

CameraPose CameraCurve::evaluate(double parameter) const {
    const std::size_t i = find_span(parameter);
    const CameraPose& a = m_keys[i];
    if (m_knots[i] == parameter) {
        return a;
    }
    const CameraPose& b = m_keys[i + 1];
    const double span = m_knots[i + 1] - m_knots[i];
    const double s = (parameter - m_knots[i]) / span;
    const auto curve = [&](auto field) {
        return hermite(a.*field, b.*field, compute_slope(i, field), compute_slope(i + 1, field),
                       span, s);
    };
    CameraPose pose;
    pose.position = curve(&CameraPose::position);
    pose.target = curve(&CameraPose::target);
    pose.fov_y_degrees = curve(&CameraPose::fov_y_degrees);
    pose.up = a.up == b.up ? a.up : glm::mix(glm::normalize(a.up), glm::normalize(b.up), s);
    return pose;
}

double CameraCurve::compute_speed(double parameter) const {
    ALCOVE_ASSERT(m_keys.size() > 1, "a curve of two keys");
    const std::size_t i = std::min(find_span(parameter), m_keys.size() - 2);
    const double span = m_knots[i + 1] - m_knots[i];
    const double s = (parameter - m_knots[i]) / span;
    const auto field = &CameraPose::position;
    // The derivative of hermite.
    return glm::length(compute_difference(i, field) * (6.0 * s - 6.0 * s * s) +
                       compute_slope(i, field) * (3.0 * s * s - 4.0 * s + 1.0) +
                       compute_slope(i + 1, field) * (3.0 * s * s - 2.0 * s));
}

/// True if a neighbour is the same.
bool CameraCurve::is_held(std::size_t key) const {
    return (key > 0 && m_keys[key - 1] == m_keys[key]) ||
           (key + 1 < m_keys.size() && m_keys[key + 1] == m_keys[key]);
}

template <class T>
T CameraCurve::compute_difference(std::size_t span, T CameraPose::*field) const {
    return (m_keys[span + 1].*field - m_keys[span].*field) / (m_knots[span + 1] - m_knots[span]);
}

template <class T>
T CameraCurve::compute_slope(std::size_t key, T CameraPose::*field) const {
    if (is_held(key)) {
        return T(0.0);
    }
    if (key == 0) {
        return compute_difference(key, field);
    }
    if (key + 1 == m_keys.size()) {
        return compute_difference(key - 1, field);
    }
    const double h0 = m_knots[key] - m_knots[key - 1];
    const double h1 = m_knots[key + 1] - m_knots[key];
    const T d0 = compute_difference(key - 1, field);
    const T d1 = compute_difference(key, field);
    if constexpr (std::is_same_v<T, double>) {
        return monotone_slope(d0, d1, h0, h1);
    } else {
        return parabola_slope(d0, d1, h0, h1);
    }
}

} // namespace alcove
