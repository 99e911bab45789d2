#pragma once
// Anybody's glTF 2.0 file as a static scene.

#include "core/contract/scene.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace alcove {

struct GltfOptions {
    /// Radius of interest in metres, > 0; by default 5 % of the diagonal of the bounding box.
    std::optional<double> ao_radius_m;
};

/// Opens the default scene of a .gltf or .glb file: one Mesh a primitive, one Object a node and
/// primitive, so that instances stay instances; a mirroring node gets a mesh of its own with turned
/// winding. Triangles, strips and fans; indices of 8, 16 or 32 bits or none; missing normals are
/// the faces' (glTF 2.0, 3.7.2.1); the base colour factor is the albedo. Each perspective camera of
/// the scene is looked through for 60 frames, with a cut between two; without one the walkthrough
/// circles the bounding box in 120 frames. Lights are Alcove's default.
///
/// `warnings`, if given, gets a line for everything in the file that was ignored or made up.
///
/// Throws InputError naming file and element: everything load_gltf and the readers throw
/// (gltf_document.hpp), nodes that are reached twice or lie deeper than 256, transforms that are
/// not affine or not finite, coordinates beyond 1e9 m, more than 64 M vertices over all objects or
/// a million objects, and files without a triangle.
[[nodiscard]] std::unique_ptr<Scene> open_gltf_scene(const std::filesystem::path& path,
                                                     const GltfOptions& options = {},
                                                     std::vector<std::string>* warnings = nullptr);

} // namespace alcove
