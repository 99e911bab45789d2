#pragma once
// Virtual point lights from reflective shadow maps.
// This work is based on: Keller. Instant radiosity. 1997; Dachsbacher, Stamminger. Reflective
// shadow maps. 2005.

#include "core/frame/raster.hpp"
#include "methods/common/shadow_light.hpp"

#include <cstdint>
#include <vector>

namespace alcove {

/// A point of a surface that sends on what a light of the scene brings it, as the cosine.
struct VirtualLight {
    glm::dvec3 position{0.0}; ///< world, metres
    glm::dvec3 normal{0.0, 1.0, 0.0};
    glm::vec3 intensity{0.0f}; ///< along the normal: reflected flux / pi
};

/// What the lights of a frame light first, texel by texel.
class ReflectiveShadowMaps {
  public:
    /// `side`: texels of a map.
    ReflectiveShadowMaps(const gl::Functions& gl, int side);
    /// Draws the maps of one light and keeps what it lights: the surfaces nearest to it, also of a
    /// light that shines through them.
    void add(Raster& raster, const ShadowLight& light);
    /// At most `count` lights of equal luminance at places of equal flux along a Hilbert curve over
    /// each map; `seed` shifts them. Forgets what was added.
    [[nodiscard]] std::vector<VirtualLight> choose(int count, std::uint32_t seed);

  private:
    struct Texel {
        VirtualLight light; ///< with the flux of the texel alone
        double luminance = 0.0;
    };

    void read(const LightView& view, const ShadowLight& light);

    const gl::Functions& m_gl;
    GBuffer m_gbuffer;
    std::vector<std::size_t> m_order; ///< along the curve
    std::vector<Texel> m_texels;      ///< of all maps
};

} // namespace alcove
