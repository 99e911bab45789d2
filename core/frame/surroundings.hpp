#pragma once
// The light of the surroundings on the GPU: Environment's two octahedral maps as textures.

#include "core/contract/scene.hpp"
#include "core/gl/handles.hpp"

#include <memory>
#include <optional>

#include <glm/mat3x3.hpp>

namespace alcove {

/// For shaders: `texture(map, encode_octahedral(map_from_view * direction))` with
/// core/frame/octahedral.glsl, for view-space directions that need not be unit.
struct SurroundingsView {
    const gl::Texture* radiance = nullptr; ///< RGBA32F, nearest filtering: the texels of look_up
    /// RGBA32F, linear filtering: the mean over the hemisphere around a direction, weighted by the
    /// cosine. Between texels at the map's seam below the horizon it is off by what half a texel
    /// (3 degrees) changes.
    const gl::Texture* prefiltered = nullptr;
    glm::mat3 map_from_view{1.0f};
};

class Surroundings {
  public:
    explicit Surroundings(const gl::Functions& gl) : m_gl(gl) {}
    /// Uploads, unless the same light is there. Without an environment the maps hold `ambient`.
    void update(const Lights& lights);
    /// Asserts that update was called. Holds as long as this lives.
    [[nodiscard]] SurroundingsView look_through(const Camera& camera) const;

  private:
    const gl::Functions& m_gl;
    std::shared_ptr<const Environment> m_environment; ///< of the textures
    std::optional<glm::vec3> m_ambient;               ///< of the textures, without environment
    double m_turn_radians = 0.0;
    gl::Texture m_radiance;
    gl::Texture m_prefiltered;
};

} // namespace alcove
