#pragma once
// Half resolution for methods that estimate there: which full-resolution pixel each texel stands
// for, and the way back along surfaces.
// This work is based on: Kopf, Cohen, Lischinski, Uyttendaele. Joint bilateral upsampling. 2007.

#include "core/contract/method.hpp"
#include "core/frame/full_screen.hpp"

namespace alcove {

struct BilateralUpsampleSettings {
    /// Window in full-resolution pixels, 2 to 32. 2: linear interpolation; 8 takes out noise that
    /// repeats every 4x4 texels, exactly where the surface faces the camera. On each axis a box of
    /// that width, drawn out by a linear interpolation over two pixels, so that even and odd widths
    /// are centred alike.
    int width = 2;
    double edge_distance_m = 0.1; ///< distance off the receiver's tangent plane with weight 1/e
};

/// Use: select(), estimate at half_size() with the selected pixels' depths (half_resolution.glsl),
/// then render().
class BilateralUpsample {
  public:
    BilateralUpsample() = default;
    explicit BilateralUpsample(const gl::Functions& gl);
    /// For images of `full` pixels, odd ones too.
    void resize(ImageSize full);
    /// Half of `full`, rounded up.
    [[nodiscard]] ImageSize half_size() const noexcept { return m_selection.size(); }

    /// Selects a pixel of every 2x2: the nearest and the farthest in turns, as a checkerboard. Pass
    /// `<owner>/downsample`.
    void select(const MethodInputs& inputs, const std::string& owner, PassRecorder& passes) const;
    /// RG32F, the selected pixel's eye depth and place in its 2x2: read_half_pixel reads it.
    [[nodiscard]] const gl::Texture& selection() const noexcept { return m_selection; }

    /// Visibility of half_size() at the selected pixels to full resolution. Needs select() before.
    /// The background comes out as exactly 1. Pass `<owner>/upsample`.
    void render(const MethodInputs& inputs, const BilateralUpsampleSettings& settings,
                const gl::Texture& half_visibility, GLuint full_framebuffer,
                const std::string& owner, PassRecorder& passes) const;

  private:
    const gl::Functions* m_gl = nullptr;
    FullScreenProgram m_select;
    FullScreenProgram m_upsample;
    gl::Texture m_selection;
    gl::FramebufferHandle m_selection_framebuffer;
};

} // namespace alcove
