#pragma once
// The harness's own pass: a method's visibility or radiance into the shaded picture. Charged to
// nobody.

#include "core/frame/full_screen.hpp"
#include "core/frame/gbuffer.hpp"
#include "core/frame/passes.hpp"
#include "core/frame/surroundings.hpp"

#include <optional>

#include <glm/vec3.hpp>

namespace alcove {

/// What a method left: one of the two is not null.
struct ComposedImages {
    const gl::Texture* visibility = nullptr;
    const gl::Texture* radiance = nullptr;
    bool replaces_direct_light = false; ///< the radiance is all light
};

class Compose {
  public:
    Compose(const gl::Functions& gl, ImageSize size);
    /// The G-buffer may be multisampled: then every sample is shaded and their mean is the picture.
    /// direct + mean surrounding radiance x albedo x visibility, or direct + radiance where the
    /// method gives that, or radiance alone where that is all light; linear Rec. 709, RGBA16F. The
    /// mean is that over the hemisphere around the normal, weighted by the cosine: the ambient
    /// radiance where the scene has no environment. The background shows the surroundings.
    /// `pixel_depth`, of a multisampled G-buffer alone: eye depth at the pixels' centres, for which
    /// the method's image was made; every sample takes the value of that of the 3x3 pixels around
    /// whose depth is nearest to its own. Null: of its own pixel.
    void render(const GBuffer& gbuffer, const SurroundingsView& surroundings, const Camera& camera,
                const ComposedImages& images, PassRecorder& passes,
                const gl::Texture* pixel_depth = nullptr);
    [[nodiscard]] const gl::Texture& picture() const noexcept { return m_picture; }

  private:
    const gl::Functions& m_gl;
    gl::Texture m_picture;
    gl::FramebufferHandle m_framebuffer;
    FullScreenProgram m_program;
    std::optional<FullScreenProgram> m_multisampled; ///< compiled when it is first asked for
};

/// Linear radiance to linear light for a display: x (1 + x / 16) / (1 + x), which maps 4 to 1,
/// clamped. This work is based on: Reinhard, Stark, Shirley, Ferwerda. Photographic tone
/// reproduction for digital images. 2002, equation 4 with L_white = 4.
[[nodiscard]] Image tone_map(const Image& radiance);

} // namespace alcove
