#pragma once
// Textures as the bytes they hold: for caches, exact to the bit.

#include "core/gl/handles.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace alcove::gl {

/// Bytes of one texel of a format that G-buffers use: R32F, R16F, RGBA16F, RGBA32F, R32UI. Asserts
/// on any other.
[[nodiscard]] std::size_t get_texel_bytes(GLenum format);

/// All texels in the texture's own row order, in its own format.
[[nodiscard]] std::vector<std::byte> read_texels(const Functions& gl, const Texture& texture);
/// The way back. Asserts that there are as many bytes as the texture holds.
void write_texels(const Functions& gl, const Texture& texture, std::span<const std::byte> texels);

} // namespace alcove::gl
