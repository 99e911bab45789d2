#pragma once
// Hard shadows held against shadow rays: which are missing, which are false.

#include "core/contract/scene.hpp"

namespace alcove {

struct ShadowRates {
    int count = 0;              ///< pixels that face the light
    int shadowed = 0;           ///< of them, in the truth
    int found = 0;              ///< of them, in the image
    double missing_share = 0.0; ///< of the pixels, shadowed in the truth alone
    double false_share = 0.0;   ///< of the pixels, shadowed in the image alone
};

/// A scene in other lights, held at one of its frames.
class LitLike final : public Scene {
  public:
    LitLike(const Scene& scene, Lights lights, int frame);
    std::span<const Mesh> get_meshes() const override { return m_scene.get_meshes(); }
    std::span<const Object> get_objects() const override { return m_scene.get_objects(); }
    std::span<const Texture> get_textures() const override { return m_scene.get_textures(); }
    const Lights& get_lights() const override { return m_lights; }
    const Walkthrough& get_walkthrough() const override { return m_walkthrough; }
    double get_ao_radius_m() const override { return m_scene.get_ao_radius_m(); }
    glm::dvec3 get_origin() const override { return m_scene.get_origin(); }
    Pose compute_pose(double time_s) const override { return m_scene.compute_pose(time_s); }

  private:
    const Scene& m_scene;
    Lights m_lights;
    Walkthrough m_walkthrough;
};

/// 1 where the scene's first camera sees a point that its only light reaches, 0 in shadow, 2 where
/// the surface does not face the light or there is none. Exact shadow rays.
[[nodiscard]] Image trace_shadows(const Scene& scene, ImageSize size);

/// `visibility`: 0 in shadow, 1 outside.
[[nodiscard]] ShadowRates compare_shadows(const Image& visibility, const Image& truth);

} // namespace alcove
