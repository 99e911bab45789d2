#pragma once
// Axis-aligned boxes in double.

#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace alcove {

/// Empty until a point is added.
struct Bounds {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};

    void add(const glm::dvec3& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    /// By the eight corners of a box: never too small.
    void add(const Bounds& box, const glm::dmat4& transform) {
        for (unsigned corner = 0; corner < 8; ++corner) {
            add(glm::dvec3(transform * glm::dvec4((corner & 1u) != 0 ? box.high.x : box.low.x,
                                                  (corner & 2u) != 0 ? box.high.y : box.low.y,
                                                  (corner & 4u) != 0 ? box.high.z : box.low.z,
                                                  1.0)));
        }
    }
    [[nodiscard]] glm::dvec3 centre() const { return 0.5 * (low + high); }
    [[nodiscard]] double diagonal() const { return glm::distance(low, high); }
};

} // namespace alcove
