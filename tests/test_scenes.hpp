#pragma once
// Small scenes with known geometry, shared by the tests of frame, methods and contracts.

#include "core/contract/scene.hpp"

namespace alcove {

/// How an object goes on from each frame to the next.
struct ObjectStep {
    std::size_t object = 0;
    glm::dvec3 translation{0.0}; ///< metres
    double turn_radians = 0.0;   ///< about its own origin around +Y
};

/// Meshes made by hand; objects stand still or move by a constant step each frame of 1/30 s.
class TestScene final : public Scene {
  public:
    TestScene(std::vector<Mesh> meshes, std::vector<glm::dmat4> transforms,
              std::vector<Camera> cameras, double ao_radius_m, glm::dvec3 origin = glm::dvec3(0.0),
              std::vector<ObjectStep> steps = {});

    /// Has the sun, which shines through everything, cast shadows.
    void cast_shadows() { m_lights.directional.front().casts_shadow = true; }

    [[nodiscard]] std::span<const Mesh> get_meshes() const override { return m_meshes; }
    [[nodiscard]] std::span<const Object> get_objects() const override { return m_objects; }
    [[nodiscard]] const Lights& get_lights() const override { return m_lights; }
    [[nodiscard]] const Walkthrough& get_walkthrough() const override { return m_walkthrough; }
    [[nodiscard]] double get_ao_radius_m() const override { return m_ao_radius_m; }
    [[nodiscard]] glm::dvec3 get_origin() const override { return m_origin; }
    [[nodiscard]] Pose compute_pose(double time_s) const override;
    [[nodiscard]] bool is_static() const override { return m_steps.empty(); }

  private:
    std::vector<Mesh> m_meshes;
    std::vector<Object> m_objects;
    std::vector<glm::dmat4> m_transforms;
    std::vector<ObjectStep> m_steps;
    Lights m_lights;
    Walkthrough m_walkthrough;
    double m_ao_radius_m;
    glm::dvec3 m_origin;
};

/// A quadrilateral with one normal; corners counter-clockwise seen from its front.
[[nodiscard]] Mesh make_quad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
                             const glm::vec3& d);
/// An axis-aligned closed box with flat faces.
[[nodiscard]] Mesh make_box(const glm::vec3& minimum, const glm::vec3& maximum);
/// A sphere with smooth normals, `rings` x 2 `rings` quads.
[[nodiscard]] Mesh make_sphere(const glm::vec3& center, float radius, int rings);

/// A plane of 400 m that crosses the view axis at 5 m, turned by `tilt` radians about the x axis so
/// that its top leans away. Camera at 0 looking along -z, FOV 60 degrees, near 0.1, far 1000;
/// radius 0.5 m.
[[nodiscard]] TestScene make_plane_scene(double tilt_radians);
/// Ray parameter (= eye depth for directions of compute_pixel_direction) at that plane.
[[nodiscard]] double intersect_test_plane(const glm::dvec3& eye, const glm::dvec3& direction,
                                          double tilt_radians);

/// The canary: a floor, boxes in contact, a sphere and a thin post before open background, a wall
/// over the left border; two frames with a moving camera, between which a box rises from the floor;
/// moved as a whole by `origin`.
[[nodiscard]] TestScene make_box_scene(const glm::dvec3& origin = glm::dvec3(0.0));

} // namespace alcove
