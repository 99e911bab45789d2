#pragma once
// A scene of rigid objects, at rest or on the tracks of its walkthrough: what most scenes return
// from `open`.

#include "core/contract/scene.hpp"
#include "scenes/common/object_tracks.hpp"

#include <cstddef>
#include <vector>

namespace alcove {

/// All that makes a rigid scene, relative to `origin`.
struct RigidSceneContent {
    std::vector<Mesh> meshes;
    std::vector<Texture> textures;
    std::vector<Object> objects;        ///< `motion` is found out from the tracks
    std::vector<glm::dmat4> transforms; ///< object to scene at rest, one an object
    Lights lights;
    /// The directional lights turn about +Y at this rate, counter-clockwise seen from above.
    double light_degrees_per_s = 0.0;
    Walkthrough walkthrough; ///< cameras and the pivots of tracks relative to the origin as well
    double ao_radius_m = 0.5;
    /// World position of the scene's zero, metres. Transforms and cameras are moved by it in
    /// double. Translations that are multiples of 2^-20 m keep all their bits, and with them
    /// hash_geometry, up to 2^32 m away from zero.
    glm::dvec3 origin{0.0};
};

/// Frame 0 becomes a cut if the walkthrough does not list it. A track of an object that the scene
/// lacks moves nothing: check_scene refuses it. Asserts one transform an object, meshes in range
/// and tracks with keys.
class RigidScene final : public Scene {
  public:
    explicit RigidScene(RigidSceneContent content);

    [[nodiscard]] std::span<const Mesh> get_meshes() const override { return m_content.meshes; }
    [[nodiscard]] std::span<const Object> get_objects() const override { return m_content.objects; }
    [[nodiscard]] std::span<const Texture> get_textures() const override {
        return m_content.textures;
    }
    [[nodiscard]] const Lights& get_lights() const override { return m_content.lights; }
    [[nodiscard]] Lights compute_lights(double time_s) const override;
    [[nodiscard]] const Walkthrough& get_walkthrough() const override {
        return m_content.walkthrough;
    }
    [[nodiscard]] double get_ao_radius_m() const override { return m_content.ao_radius_m; }
    [[nodiscard]] glm::dvec3 get_origin() const override { return m_content.origin; }
    /// The rest transforms with the motion of the tracks in front of them (ObjectTracks::apply).
    [[nodiscard]] Pose compute_pose(double time_s) const override;
    /// False exactly if a track has two places.
    [[nodiscard]] bool is_static() const override { return !m_tracks.move_any(); }

  private:
    RigidSceneContent m_content; ///< cameras already in the world, transforms not
    ObjectTracks m_tracks;
};

} // namespace alcove
