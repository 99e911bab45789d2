#pragma once
// What of a glTF material Alcove shows: the base colour.

#include "scenes/common/gltf_document.hpp"
#include "scenes/common/gltf_texture.hpp"

#include <cstddef>
#include <optional>
#include <string>

#include <glm/mat3x2.hpp>
#include <glm/vec3.hpp>

namespace alcove {

struct GltfMaterial {
    glm::vec3 albedo{1.0f};
    std::optional<std::size_t> texture; ///< into GltfTextures::take
    int coordinate_set = 0;             ///< TEXCOORD_n
    /// Texture coordinate (u, v, 1) to where the texture is looked up (KHR_texture_transform).
    glm::dmat3x2 transform{1.0};
    bool repeats = true; ///< false: the sampler clamps or mirrors, which is not shown
};

/// Material `index` of a primitive called `user`; the default one for -1. Alpha, emission and other
/// textures than the base colour's are named in `warnings`. Throws InputError.
[[nodiscard]] GltfMaterial read_material(const GltfDocument& document, int index,
                                         const std::string& user, GltfTextures& textures,
                                         GltfWarnings& warnings);

} // namespace alcove
