#pragma once
// A separable blur of a visibility image that respects depth edges, as two passes.

#include "core/contract/method.hpp"
#include "core/frame/full_screen.hpp"

namespace alcove {

struct CrossBilateralBlurSettings {
    int radius = 2; ///< taps on each side of the centre, >= 1
    double edge_distance_m =
        0.1; ///< distance off the receiver's tangent plane with weight 1/e; infinity: plain blur
};

class CrossBilateralBlur {
  public:
    CrossBilateralBlur() = default;
    explicit CrossBilateralBlur(const gl::Functions& gl);
    void resize(ImageSize size);
    /// Blurs `visibility` along x into an own texture, then along y back. Passes `<owner>/blur_x`,
    /// `<owner>/blur_y`.
    void render(const MethodInputs& inputs, const CrossBilateralBlurSettings& settings,
                const gl::Texture& visibility, GLuint visibility_framebuffer,
                const std::string& owner, PassRecorder& passes) const;

  private:
    const gl::Functions* m_gl = nullptr;
    FullScreenProgram m_program;
    gl::Texture m_intermediate;
    gl::FramebufferHandle m_intermediate_framebuffer;
};

} // namespace alcove
