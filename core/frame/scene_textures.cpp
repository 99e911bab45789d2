#include "core/frame/scene_textures.hpp"

#include <algorithm>
#include <bit>

namespace alcove {

std::vector<gl::TextureHandle> upload_textures(const gl::Functions& gl,
                                               std::span<const Texture> textures) {
    std::vector<gl::TextureHandle> uploaded;
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (const Texture& texture : textures) {
        const auto longest =
            static_cast<unsigned>(std::max(texture.size.width, texture.size.height));
        GLuint name = 0;
        gl.CreateTextures(GL_TEXTURE_2D, 1, &name);
        uploaded.emplace_back(gl, name);
        gl.TextureStorage2D(name, std::bit_width(longest), GL_SRGB8_ALPHA8, texture.size.width,
                            texture.size.height);
        gl.TextureSubImage2D(name, 0, 0, 0, texture.size.width, texture.size.height, GL_RGB,
                             GL_UNSIGNED_BYTE, texture.rgb.data());
        gl.GenerateTextureMipmap(name);
        gl.TextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
        gl.TextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    }
    return uploaded;
}

} // namespace alcove
