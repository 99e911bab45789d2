#pragma once
// A glTF 2.0 file of anybody's, checked before and after the parser sees it. Everything in the file
// is hostile.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <string_view>

namespace tinygltf {
class Model;
} // namespace tinygltf

namespace alcove {

/// What was ignored or made up, a line each.
using GltfWarnings = std::set<std::string>;

struct GltfDocument {
    std::string file; ///< what errors call it
    std::filesystem::path path;
    std::shared_ptr<const tinygltf::Model> model;
    bool is_quantised = false;              ///< KHR_mesh_quantization is used
    std::shared_ptr<std::size_t> allowance; ///< bytes that reading may still allocate

    /// "file: list[index]"
    [[nodiscard]] std::string name(const char* list, std::int64_t index) const;
    /// Books memory that the file makes us allocate. Throws InputError naming `where` beyond 1 GiB
    /// and 16 times the file's size in all.
    void charge(std::size_t bytes, const std::string& where) const;
};

/// KHR_mesh_quantization, KHR_texture_transform, KHR_lights_punctual: what may be required.
[[nodiscard]] bool is_known_gltf_extension(std::string_view name);

/// Reads .gltf or .glb (by content) with its buffers; images are kept encoded. Throws InputError
/// naming file and element on truncated or malformed containers, JSON nested deeper than 256
/// levels, versions other than 2, buffer URIs that are absolute, have a scheme other than `data:`
/// or leave the file's folder, files beyond 1 GiB, and unknown extensions that are required.
[[nodiscard]] GltfDocument load_gltf(const std::filesystem::path& path);

} // namespace alcove
