#pragma once
// The shadow maps of one light at a time, one view or the six faces around a point, and how
// methods/common/shadow_map.glsl gets them: the next light draws over them.
// This work is based on: Williams. Casting curved shadows on curved surfaces. 1978.

#include "core/contract/method.hpp"
#include "core/frame/full_screen.hpp"

#include <span>
#include <string>
#include <vector>

namespace alcove {

/// Views of a light that is a point.
inline constexpr std::size_t kCubeFaces = 6;

/// For `#include "shadow_map_counts.glsl"`: what a program of lights with `faces` views, 1 or
/// kCubeFaces, is compiled with.
[[nodiscard]] std::string make_shadow_map_counts(std::size_t faces);

class ShadowMaps {
  public:
    /// `side`: texels of a map. Nothing is allocated before it is drawn.
    ShadowMaps(const gl::Functions& gl, int side) : m_gl(gl), m_side(side) {}
    /// Draws what the views see. GL state as Raster::draw leaves it.
    void draw(Raster& raster, std::span<const LightView> views);
    /// Texture units 12 and on, and the uniforms of methods/common/shadow_map.glsl, for the views
    /// that were drawn last. The program must be current and made for as many faces.
    void bind(const FullScreenProgram& program, const Camera& viewer,
              std::span<const LightView> views) const;

  private:
    const gl::Functions& m_gl;
    int m_side;
    std::vector<GBuffer> m_maps; ///< grows to the largest number of views
};

} // namespace alcove
