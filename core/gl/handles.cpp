#include "core/gl/handles.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace alcove::gl {
namespace {

constexpr std::array<GLenum, 5> kPixelFormats{0, GL_RED, GL_RG, GL_RGB, GL_RGBA};

/// OpenGL's row 0 is at the bottom, ours on top.
void flip_rows(std::span<float> values, ImageSize size, int channels) {
    const auto row = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(channels);
    const auto height = static_cast<std::size_t>(size.height);
    for (std::size_t y = 0; y < height / 2; ++y) {
        const auto top = values.begin() + static_cast<std::ptrdiff_t>(y * row);
        const auto bottom = values.begin() + static_cast<std::ptrdiff_t>((height - 1 - y) * row);
        std::swap_ranges(top, top + static_cast<std::ptrdiff_t>(row), bottom);
    }
}

} // namespace

Texture::Texture(const Functions& gl, GLenum format, ImageSize size)
    : m_format(format), m_size(size) {
    ALCOVE_ASSERT(size.width > 0 && size.height > 0, "texture sizes are positive");
    GLuint name = 0;
    gl.CreateTextures(GL_TEXTURE_2D, 1, &name);
    m_handle = TextureHandle(gl, name);
    gl.TextureStorage2D(name, 1, format, size.width, size.height);
    gl.TextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.TextureParameteri(name, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TextureParameteri(name, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

Texture::Texture(const Functions& gl, GLenum format, ImageSize size, int samples)
    : m_format(format), m_size(size) {
    GLint most = 0;
    gl.GetIntegerv(GL_MAX_SAMPLES, &most);
    if (samples > most) {
        throw InputError("multisampling", "more samples than the device offers",
                         std::to_string(samples), "at most " + std::to_string(most));
    }
    GLuint name = 0;
    gl.CreateTextures(GL_TEXTURE_2D_MULTISAMPLE, 1, &name);
    m_handle = TextureHandle(gl, name);
    gl.TextureStorage2DMultisample(name, samples, format, size.width, size.height, GL_TRUE);
}

BufferHandle create_buffer(const Functions& gl, std::span<const std::byte> bytes,
                           GLbitfield flags) {
    ALCOVE_ASSERT(!bytes.empty(), "a buffer of some bytes");
    GLuint name = 0;
    gl.CreateBuffers(1, &name);
    BufferHandle buffer(gl, name);
    gl.NamedBufferStorage(name, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), flags);
    return buffer;
}

FramebufferHandle create_framebuffer(const Functions& gl,
                                     std::initializer_list<const Texture*> colors,
                                     const Texture* depth) {
    return create_framebuffer(gl, std::span(colors.begin(), colors.size()), depth);
}

FramebufferHandle create_framebuffer(const Functions& gl, std::span<const Texture* const> colors,
                                     const Texture* depth) {
    GLuint name = 0;
    gl.CreateFramebuffers(1, &name);
    FramebufferHandle framebuffer(gl, name);
    std::vector<GLenum> buffers;
    for (const Texture* color : colors) {
        const auto attachment = static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + buffers.size());
        gl.NamedFramebufferTexture(name, attachment, color->get(), 0);
        buffers.push_back(attachment);
    }
    if (depth != nullptr) {
        gl.NamedFramebufferTexture(name, GL_DEPTH_ATTACHMENT, depth->get(), 0);
    }
    gl.NamedFramebufferDrawBuffers(name, static_cast<GLsizei>(buffers.size()), buffers.data());
    const GLenum status = gl.CheckNamedFramebufferStatus(name, GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE) {
        throw FailureError("OpenGL", "framebuffer incomplete", std::to_string(status));
    }
    return framebuffer;
}

Image read_texture(const Functions& gl, const Texture& texture, int channels) {
    Image image(texture.size(), channels);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    if (texture.format() == GL_R32UI) {
        ALCOVE_ASSERT(channels == 1, "one channel of whole numbers");
        std::vector<GLuint> numbers(image.values().size());
        gl.GetTextureImage(texture.get(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT,
                           static_cast<GLsizei>(numbers.size() * sizeof(GLuint)), numbers.data());
        std::transform(numbers.begin(), numbers.end(), image.values().begin(),
                       [](GLuint number) { return static_cast<float>(number); });
        flip_rows(image.values(), image.size(), channels);
        return image;
    }
    gl.GetTextureImage(texture.get(), 0, kPixelFormats.at(static_cast<std::size_t>(channels)),
                       GL_FLOAT, static_cast<GLsizei>(image.values().size_bytes()),
                       image.values().data());
    flip_rows(image.values(), image.size(), channels);
    return image;
}

void write_texture(const Functions& gl, const Texture& texture, const Image& image) {
    ALCOVE_ASSERT(image.size() == texture.size(), "an image of the texture's size");
    Image flipped = image;
    flip_rows(flipped.values(), image.size(), image.channels());
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.TextureSubImage2D(texture.get(), 0, 0, 0, image.width(), image.height(),
                         kPixelFormats.at(static_cast<std::size_t>(image.channels())), GL_FLOAT,
                         flipped.values().data());
}

} // namespace alcove::gl
