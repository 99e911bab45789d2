#pragma once
// A scene's pictures on the GPU: sRGB, repeated, with all mip levels.

#include "core/contract/scene.hpp"
#include "core/gl/handles.hpp"

#include <vector>

namespace alcove {

/// One texture each, in the order of Scene::get_textures; trilinear.
[[nodiscard]] std::vector<gl::TextureHandle> upload_textures(const gl::Functions& gl,
                                                             std::span<const Texture> textures);

} // namespace alcove
