#pragma once
// Depth images of a few metres whose surfaces are known in closed form: what oracles are compared
// on.

#include "tests/methods/depth_image_rig.hpp"

#include <cmath>

#include <glm/vec3.hpp>

namespace alcove {

inline constexpr ImageSize kDepthSceneSize{48, 36};

/// The nearest of a set of surfaces along a pixel's ray of unit depth, with its normal.
class RayCaster {
  public:
    explicit RayCaster(const glm::dvec3& direction) : m_direction(direction) {}
    void add_plane(const glm::dvec3& point, const glm::dvec3& normal);
    void add_sphere(const glm::dvec3& center, double radius);
    [[nodiscard]] double depth() const { return m_depth; }
    [[nodiscard]] const glm::dvec3& normal() const { return m_normal; }

  private:
    void add_hit(double depth, const glm::dvec3& normal);
    glm::dvec3 m_direction;
    glm::dvec3 m_normal{0.0, 0.0, 1.0};
    double m_depth = INFINITY;
};

/// A pixel of the image from what its ray hit.
void write_hit(DepthImage& image, int x, int y, const RayCaster& ray);

/// A tilted wall at 3.4 m and before its left half a block that ends at 1.9 m.
[[nodiscard]] DepthImage make_step_image();
/// A floor, two walls, none along an axis, and two spheres before them.
[[nodiscard]] DepthImage make_corner_with_spheres_image();
/// Blocks of 6 x 6 pixels with random depths, slopes and normals, every seventh of them background.
/// Without the slopes one sample near its switch would flag a whole block.
[[nodiscard]] DepthImage make_random_blocks_image();
/// A floor 3 m below a camera that looks straight down, and a wall that rises from it at x =
/// `wall_m` towards the camera; 192 x 144 pixels.
[[nodiscard]] DepthImage make_floor_and_wall_image(double wall_m);

} // namespace alcove
