#pragma once
// Pictures of surfaces as the files that scenes carry: PNG and JPEG in, PNG out.

#include "core/contract/scene.hpp"

#include <cstddef>
#include <span>
#include <string>

namespace alcove {

/// Reads an image of at most 8192x8192; `where` is what errors call it. Grey becomes RGB, alpha is
/// left out, 16 bits are rounded to 8. Throws InputError on other formats, damaged files and larger
/// sizes, which are known before pixels are decoded.
[[nodiscard]] Texture decode_texture(std::span<const unsigned char> bytes,
                                     const std::string& where);

/// An 8-bit RGB PNG. Throws FailureError.
[[nodiscard]] std::string encode_texture(const Texture& texture);

} // namespace alcove
