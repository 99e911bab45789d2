#pragma once
// The sum of the light of many lights, one pass a light, and what a picture and a visibility image
// take from it.

#include "core/contract/method.hpp"
#include "core/frame/full_screen.hpp"

#include <array>

namespace alcove {

/// What is added to the sum of lights.
struct LightSumSettings {
    bool adds_surroundings_to_visibility = false; ///< as light that nothing blocks
    bool adds_surroundings = false;               ///< the prefiltered light from all around
    const gl::Texture* reflected = nullptr;       ///< radiance that is added as it is; may be null
};

class LightSum {
  public:
    explicit LightSum(const gl::Functions& gl);
    void resize(ImageSize size);
    /// Clears the sums. `wants_visibility`: passes write the light that would arrive if nothing
    /// blocked it to a second output.
    void begin(bool wants_visibility);
    /// Adds what the program's first output gives, and its second one. The program must be current.
    void add(const FullScreenProgram& program) const;
    /// Radiance = albedo (sum / pi + surroundings) + reflected, 0 on the background. Needs normal
    /// and albedo.
    [[nodiscard]] const gl::Texture& shade(const MethodInputs& inputs,
                                           const LightSumSettings& settings);
    /// Luminance of the sum over that of the light that would arrive if nothing blocked it; 1 where
    /// that is none, and on the background. Only after a begin that asked for it.
    [[nodiscard]] const gl::Texture& show_visibility(const MethodInputs& inputs,
                                                     const LightSumSettings& settings);

  private:
    void draw(const MethodInputs& inputs, const LightSumSettings& settings, bool shows_visibility,
              GLuint target);

    const gl::Functions& m_gl;
    FullScreenProgram m_shade;
    ImageSize m_size;
    bool m_keeps_open = false;
    gl::Texture m_arriving; ///< RGBA32F: irradiance; 1000 lights need the digits
    gl::Texture m_open;     ///< the same as if nothing blocked it; only on demand
    gl::FramebufferHandle m_arriving_framebuffer;
    gl::FramebufferHandle m_both_framebuffer;
    gl::Texture m_nothing; ///< stands for reflected light where there is none
    gl::Texture m_radiance;
    gl::FramebufferHandle m_radiance_framebuffer;
    gl::Texture m_visibility;
    gl::FramebufferHandle m_visibility_framebuffer;
};

} // namespace alcove
