#pragma once
// Cuts large meshes into clusters that culling keeps or leaves out. No OpenGL.

#include "core/contract/scene.hpp"

namespace alcove {

/// Sorts the triangles of a mesh of more than 1024 into clusters of at most 256 that lie together
/// and face alike, with boxes and cones; smaller meshes and those that have clusters stay as they
/// are. Positions, normals and the set of triangles do not change, nor does the result from call to
/// call. Clusters are those of meshoptimizer (A. Kapoulkine), by its scan for meshlets.
void build_clusters(Mesh& mesh);

} // namespace alcove
