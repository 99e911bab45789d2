#pragma once
// Images of a glTF file, embedded or beside it.

#include "core/contract/scene.hpp"
#include "scenes/common/gltf_document.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace alcove {

/// Reads each image once, when it is first asked for.
class GltfTextures {
  public:
    GltfTextures(const GltfDocument& document, GltfWarnings& warnings)
        : m_document(document), m_warnings(warnings) {}

    /// Index of a texture's image in `textures`; nothing, with a warning, if the image is missing
    /// or cannot be read. `user` is what refers to it. Throws InputError if there is no such
    /// texture or image, if its URI leaves the file's folder, if it is larger than 8192x8192 and
    /// if all of them take more than 1 GiB.
    [[nodiscard]] std::optional<std::size_t> find(int texture, const std::string& user);

    [[nodiscard]] std::vector<Texture> take() { return std::move(m_textures); }

  private:
    [[nodiscard]] std::optional<Texture> read(int image);

    const GltfDocument& m_document;
    GltfWarnings& m_warnings;
    std::map<int, std::optional<std::size_t>> m_known; ///< by image
    std::vector<Texture> m_textures;
    std::size_t m_bytes = 0;
};

} // namespace alcove
