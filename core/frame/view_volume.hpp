#pragma once
// What a camera can see, as tests of boxes. All tests err on the side of seeing: a box that is said
// to be outside has no point in the image, whatever float rounding does to its vertices on the GPU.

#include "core/base/camera.hpp"

#include <optional>

namespace alcove {

/// A parallelepiped in world axes, metres: the points centre + a h0 + b h1 + c h2 with a, b, c in
/// [-1,1] and h the columns of `half`.
struct OrientedBox {
    glm::dvec3 centre{0.0};
    glm::dmat3 half{0.0};
};

/// The box [low, high] of object space, placed by an affine transform.
[[nodiscard]] OrientedBox place_box(const glm::vec3& low, const glm::vec3& high,
                                    const glm::dmat4& world_from_object);

/// The pixels that a box may touch (inclusive, row 0 at the bottom as OpenGL's) and its smallest
/// eye depth.
struct ScreenBounds {
    int left = 0;
    int bottom = 0;
    int right = 0;
    int top = 0;
    double nearest_m = 0.0;
    [[nodiscard]] double pixel_count() const { return (right - left + 1.0) * (top - bottom + 1.0); }
};

class ViewVolume {
  public:
    ViewVolume(const Camera& camera, ImageSize size);

    /// False only if no point of the box lies in the view frustum.
    [[nodiscard]] bool may_show(const OrientedBox& box) const;
    /// True only if the near plane cuts off no point of the box.
    [[nodiscard]] bool is_beyond_near(const OrientedBox& box) const;
    /// Nothing for a box that reaches the near plane or lies beside the image.
    [[nodiscard]] std::optional<ScreenBounds> project(const OrientedBox& box) const;
    [[nodiscard]] const Camera& camera() const noexcept { return m_camera; }

  private:
    struct ViewBox {
        glm::dvec3 centre;
        glm::dmat3 half;
        double margin; ///< metres that rounding may move a point of the box by
    };
    [[nodiscard]] ViewBox to_view(const OrientedBox& box) const;

    Camera m_camera;
    ImageSize m_size;
    glm::dvec2 m_tangents;
};

} // namespace alcove
