#pragma once
// A smooth curve of cameras through keys.

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

namespace alcove {

/// Where a camera stands and what it sees, as files say it.
struct CameraPose {
    glm::dvec3 position{0.0}; ///< metres
    glm::dvec3 target{0.0};   ///< metres
    glm::dvec3 up{0.0, 1.0, 0.0};
    double fov_y_degrees = 60.0;
    bool operator==(const CameraPose&) const = default;
};

/// Position and target run on cubic Hermite curves through the keys (tangents of the parabola
/// through three neighbours), the field of view on a monotone cubic, up on a line. On a knot the
/// pose is the key's, exactly. Between two equal neighbouring keys it is theirs, exactly: the
/// tangents of both keys are 0. Curves may swing out between other keys.
class CameraCurve {
  public:
    /// `knots` are the keys' parameters. Asserts one knot a key, at least one, ascending.
    CameraCurve(std::vector<double> knots, std::vector<CameraPose> keys);

    [[nodiscard]] const std::vector<double>& knots() const noexcept { return m_knots; }
    /// Asserts that the parameter lies within the knots.
    [[nodiscard]] CameraPose evaluate(double parameter) const;
    /// Length of d position / d parameter. Asserts two keys and a parameter within the knots.
    [[nodiscard]] double compute_speed(double parameter) const;

  private:
    [[nodiscard]] std::size_t find_span(double parameter) const;
    [[nodiscard]] bool is_held(std::size_t key) const;
    template <class T>
    [[nodiscard]] T compute_difference(std::size_t span, T CameraPose::*field) const;
    template <class T>
    [[nodiscard]] T compute_slope(std::size_t key, T CameraPose::*field) const;

    std::vector<double> m_knots;
    std::vector<CameraPose> m_keys;
};

} // namespace alcove
