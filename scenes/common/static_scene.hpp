#pragma once
// A scene whose geometry does not move: what most scenes return from `open`.

#include "core/contract/scene.hpp"

#include <vector>

namespace alcove {

/// All that makes a static scene, relative to `origin`.
struct StaticSceneContent {
    std::vector<Mesh> meshes;
    std::vector<Object> objects;
    std::vector<glm::dmat4> transforms; ///< object to scene, one an object
    Lights lights;
    Walkthrough walkthrough; ///< cameras relative to the origin as well
    double ao_radius_m = 0.5;
    /// World position of the scene's zero, metres. Transforms and cameras are moved by it in
    /// double. Translations that are multiples of 2^-20 m keep all their bits, and with them
    /// hash_geometry, up to 2^32 m away from zero.
    glm::dvec3 origin{0.0};
};

/// Frame 0 becomes a cut if the walkthrough does not list it. Asserts one transform an object and
/// meshes in range.
class StaticScene final : public Scene {
  public:
    explicit StaticScene(StaticSceneContent content);

    [[nodiscard]] std::span<const Mesh> get_meshes() const override { return m_content.meshes; }
    [[nodiscard]] std::span<const Object> get_objects() const override { return m_content.objects; }
    [[nodiscard]] const Lights& get_lights() const override { return m_content.lights; }
    [[nodiscard]] const Walkthrough& get_walkthrough() const override {
        return m_content.walkthrough;
    }
    [[nodiscard]] double get_ao_radius_m() const override { return m_content.ao_radius_m; }
    [[nodiscard]] glm::dvec3 get_origin() const override { return m_content.origin; }
    [[nodiscard]] Pose compute_pose(double time_s) const override;

  private:
    StaticSceneContent m_content; ///< transforms and cameras already in the world
};

} // namespace alcove
