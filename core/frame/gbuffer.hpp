#pragma once
// The channels that the rasterised scene leaves for methods, as textures.

#include "core/frame/channels.hpp"
#include "core/frame/precision.hpp"
#include "core/gl/handles.hpp"

#include <array>

namespace alcove {

class GBuffer {
  public:
    /// `samples` a pixel; with more than one, textures are read by sampler2DMS. Throws InputError
    /// for more samples than the device offers, and for multisampled eye depth from raster depth.
    GBuffer(const gl::Functions& gl, ImageSize size, ChannelSet channels,
            const Precision& precision, int samples = 1);

    [[nodiscard]] ImageSize size() const noexcept { return m_size; }
    [[nodiscard]] ChannelSet channels() const noexcept { return m_channels; }
    [[nodiscard]] int samples() const noexcept { return m_samples; }
    [[nodiscard]] const Precision& precision() const noexcept { return m_precision; }
    /// Asserts that the channel was asked for.
    [[nodiscard]] const gl::Texture& texture(Channel channel) const;

    // For the renderer.
    [[nodiscard]] GLuint framebuffer() const noexcept { return m_framebuffer.get(); }
    /// The channels that an object which stands still writes: all but motion, which is cleared to
    /// 0.
    [[nodiscard]] ChannelSet still_channels() const noexcept { return m_still_channels; }
    [[nodiscard]] GLuint still_framebuffer() const noexcept { return m_still_framebuffer.get(); }
    [[nodiscard]] const gl::Texture& raster_depth() const noexcept { return m_raster_depth; }
    /// Target of the pass that rebuilds eye depth from raster depth; 0 unless precision asks for
    /// it.
    [[nodiscard]] GLuint rebuild_framebuffer() const noexcept {
        return m_rebuild_framebuffer.get();
    }

  private:
    ImageSize m_size;
    ChannelSet m_channels;
    ChannelSet m_still_channels;
    Precision m_precision;
    int m_samples;
    std::array<gl::Texture, kChannels.size()> m_textures;
    gl::Texture m_raster_depth;
    gl::FramebufferHandle m_framebuffer;
    gl::FramebufferHandle m_still_framebuffer;
    gl::FramebufferHandle m_rebuild_framebuffer;
};

} // namespace alcove
