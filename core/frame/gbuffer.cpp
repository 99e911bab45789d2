#include "core/frame/gbuffer.hpp"

#include "core/base/error.hpp"

#include <vector>

namespace alcove {
namespace {

GLenum get_raster_format(RasterDepth depth) {
    switch (depth) {
    case RasterDepth::float32:
        return GL_DEPTH_COMPONENT32F;
    case RasterDepth::unorm24:
        return GL_DEPTH_COMPONENT24;
    case RasterDepth::unorm16:
        break;
    }
    return GL_DEPTH_COMPONENT16;
}

GLenum get_format(const ChannelInfo& info, const Precision& precision) {
    if (info.channel == Channel::eye_depth && precision.eye_depth == EyeDepth::float16) {
        return GL_R16F;
    }
    if (info.channel == Channel::motion && precision.motion == MotionPrecision::float32) {
        return GL_RGBA32F;
    }
    return info.format;
}

} // namespace

GBuffer::GBuffer(const gl::Functions& gl, ImageSize size, ChannelSet channels,
                 const Precision& precision, int samples)
    : m_size(size), m_channels(channels), m_precision(precision), m_samples(samples) {
    if (samples > 1 && precision.eye_depth == EyeDepth::from_raster) {
        throw InputError("multisampling", "eye depth cannot be rebuilt a sample",
                         "eye_depth=raster", "eye_depth=32F or 16F");
    }
    const auto make_texture = [&](GLenum format) {
        return samples > 1 ? gl::Texture(gl, format, size, samples) : gl::Texture(gl, format, size);
    };
    m_raster_depth = make_texture(get_raster_format(precision.raster_depth));
    std::vector<const gl::Texture*> targets;
    std::vector<const gl::Texture*> still_targets;
    for (const ChannelInfo& info : kChannels) {
        if (!channels.contains(info.channel)) {
            continue;
        }
        gl::Texture& texture = m_textures.at(static_cast<std::size_t>(info.channel));
        texture = make_texture(get_format(info, precision));
        targets.push_back(&texture);
        if (info.channel != Channel::motion) {
            still_targets.push_back(&texture);
            m_still_channels.add(info.channel);
        }
    }
    m_framebuffer = gl::create_framebuffer(gl, std::span(targets), &m_raster_depth);
    m_still_framebuffer = gl::create_framebuffer(gl, std::span(still_targets), &m_raster_depth);
    if (precision.eye_depth == EyeDepth::from_raster && channels.contains(Channel::eye_depth)) {
        m_rebuild_framebuffer = gl::create_framebuffer(gl, {&texture(Channel::eye_depth)});
    }
}

const gl::Texture& GBuffer::texture(Channel channel) const {
    ALCOVE_ASSERT(m_channels.contains(channel), "a channel that was asked for");
    return m_textures.at(static_cast<std::size_t>(channel));
}

} // namespace alcove
