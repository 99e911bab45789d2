#pragma once
// The meshes of a glTF scene on its nodes.

#include "scenes/common/animated_scene.hpp"
#include "scenes/common/bounds.hpp"
#include "scenes/common/gltf_animation.hpp"
#include "scenes/common/gltf_document.hpp"
#include "scenes/common/gltf_nodes.hpp"

#include <vector>

namespace alcove {

/// Meshes, textures, skins and objects of the tree and the weights of its morph targets: one Mesh a
/// primitive, one Object a node and primitive. `world` is where the nodes are at time 0: it decides
/// which objects are mirrored, and so have meshes of their own with turned triangles. Throws
/// InputError on more than 64 M vertices or a million objects, and without a triangle.
[[nodiscard]] AnimatedSceneContent place_objects(const GltfDocument& document, const GltfTree& tree,
                                                 const GltfClip& clip,
                                                 const std::vector<glm::dmat4>& world,
                                                 GltfWarnings& warnings);

/// What the objects reach over a clip, at 16 times of it (one for a scene at rest), with
/// `content.nodes` set. Throws InputError naming the node of an object beyond 1e9 m.
[[nodiscard]] Bounds measure_bounds(const GltfDocument& document, const GltfTree& tree,
                                    const AnimatedSceneContent& content, double duration_s);

} // namespace alcove
