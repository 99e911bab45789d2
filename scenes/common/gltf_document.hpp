#pragma once
// A glTF 2.0 file of anybody's, checked before and after the parser sees it. Everything in the file
// is hostile.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace tinygltf {
class Model;
} // namespace tinygltf

namespace alcove {

struct GltfDocument {
    std::string file; ///< what errors call it
    std::shared_ptr<const tinygltf::Model> model;

    /// "file: list[index]"
    [[nodiscard]] std::string name(const char* list, std::int64_t index) const;
};

/// Reads .gltf or .glb (by content) with its buffers; images are left alone. Throws InputError
/// naming file and element on truncated or malformed containers, JSON nested deeper than 256
/// levels, versions other than 2, buffer URIs that are absolute, have a scheme other than `data:`
/// or leave the file's folder, files beyond 1 GiB, and any extension that is required.
[[nodiscard]] GltfDocument load_gltf(const std::filesystem::path& path);

} // namespace alcove
