#pragma once
// Anybody's glTF 2.0 file as a scene.

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
    /// The clip that is played over and over; by default the first, if there is one.
    std::optional<int> animation;
    /// A walkthrough_file in the coordinates of the file, in place of its cameras; its tracks move
    /// the objects named below.
    std::optional<std::filesystem::path> walkthrough;
};

/// Opens the default scene of a .gltf or .glb file: one Mesh a primitive, one Object a node and
/// primitive, called "<node's name>.<primitive>", so that instances stay instances; a mirroring
/// node gets a mesh of its own with turned winding.
///
/// Geometry: triangles, strips and fans; indices of 8, 16 or 32 bits or none; sparse, normalised
/// and quantised accessors (KHR_mesh_quantization); missing normals are the faces' (glTF 2.0,
/// 3.7.2.1). Surfaces: base colour factor and texture (PNG or JPEG, KHR_texture_transform) and
/// COLOR_0. Motion: one clip of node, skin and morph target animation. Lights: directional ones
/// (KHR_lights_punctual), else Alcove's default. Each perspective camera of the scene is looked
/// through for 60 frames or the length of the clip, with a cut between two; without one the
/// walkthrough circles the bounding box in 120 frames or as long.
///
/// `warnings`, if given, gets a line for everything in the file that was ignored or made up.
///
/// Throws InputError naming file and element: everything load_gltf and the readers throw
/// (gltf_document.hpp), nodes that are reached twice or lie deeper than 256, transforms that are
/// not affine or not finite, coordinates beyond 1e9 m, more than 64 M vertices over all objects or
/// a million objects, files without a triangle, and options that the file cannot fulfil.
[[nodiscard]] std::unique_ptr<Scene> open_gltf_scene(const std::filesystem::path& path,
                                                     const GltfOptions& options = {},
                                                     std::vector<std::string>* warnings = nullptr);

} // namespace alcove
