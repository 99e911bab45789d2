#pragma once
// The mean over a tile of sample sets, along surfaces: a separable box that holds every set once,
// symmetric around the pixel, with weights for depth and normal (cosine to the eighth).
// This work is based on: Segovia, Iehl, Mitanchey, Peroche. Non-interleaved deferred shading of
// interleaved sample patterns. 2006 (the geometry-aware box); the distance off the tangent plane in
// place of a difference of depths is ours.

#include "core/contract/method.hpp"
#include "core/frame/full_screen.hpp"

namespace alcove {

struct TileBlurSettings {
    int tile = 4;                 ///< side of the tile; 1: no blur, the result alone
    double edge_distance_m = 0.1; ///< off the receiver's tangent plane with weight 1/e
};

class TileBlur {
  public:
    TileBlur() = default;
    explicit TileBlur(const gl::Functions& gl);
    void resize(ImageSize size);
    /// `incoming`: RGBA32F, mean incoming radiance and, in a, eye depth. Writes it times albedo
    /// (is_shaded) or as visibility, at most 1 (red, into a one-channel target); 0, or visibility
    /// 1, on the background. Passes `<owner>/blur_x`, `<owner>/blur_y`, or, for a tile of 1,
    /// `<owner>/shade`.
    void render(const MethodInputs& inputs, const TileBlurSettings& settings,
                const gl::Texture& incoming, GLuint target, bool is_shaded,
                const std::string& owner, PassRecorder& passes) const;

  private:
    void draw(const MethodInputs& inputs, const TileBlurSettings& settings,
              const gl::Texture& source, GLuint target, bool is_along_x, int finish) const;

    const gl::Functions* m_gl = nullptr;
    FullScreenProgram m_program;
    gl::Texture m_intermediate;
    gl::FramebufferHandle m_intermediate_framebuffer;
};

} // namespace alcove
