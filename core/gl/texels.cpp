#include "core/gl/texels.hpp"

#include <array>

namespace alcove::gl {
namespace {

struct TexelFormat {
    GLenum internal;
    GLenum format;
    GLenum type;
    std::size_t bytes;
};

constexpr std::array kFormats{
    TexelFormat{GL_R32F, GL_RED, GL_FLOAT, 4},
    TexelFormat{GL_R16F, GL_RED, GL_HALF_FLOAT, 2},
    TexelFormat{GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT, 8},
    TexelFormat{GL_RGBA32F, GL_RGBA, GL_FLOAT, 16},
    TexelFormat{GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, 4},
};

const TexelFormat& find_format(GLenum internal) {
    for (const TexelFormat& format : kFormats) {
        if (format.internal == internal) {
            return format;
        }
    }
    ALCOVE_ASSERT(false, "a format that G-buffers use");
    return kFormats.front();
}

std::size_t count_bytes(const Texture& texture) {
    return static_cast<std::size_t>(texture.size().width) *
           static_cast<std::size_t>(texture.size().height) * find_format(texture.format()).bytes;
}

} // namespace

std::size_t get_texel_bytes(GLenum format) {
    return find_format(format).bytes;
}

std::vector<std::byte> read_texels(const Functions& gl, const Texture& texture) {
    const TexelFormat& format = find_format(texture.format());
    std::vector<std::byte> texels(count_bytes(texture));
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl.GetTextureImage(texture.get(), 0, format.format, format.type,
                       static_cast<GLsizei>(texels.size()), texels.data());
    return texels;
}

void write_texels(const Functions& gl, const Texture& texture, std::span<const std::byte> texels) {
    ALCOVE_ASSERT(texels.size() == count_bytes(texture), "as many bytes as the texture holds");
    const TexelFormat& format = find_format(texture.format());
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.TextureSubImage2D(texture.get(), 0, 0, 0, texture.size().width, texture.size().height,
                         format.format, format.type, texels.data());
}

} // namespace alcove::gl
