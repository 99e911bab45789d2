#pragma once
// One animation clip of a glTF file.

#include "scenes/common/gltf_document.hpp"
#include "scenes/common/gltf_nodes.hpp"

#include <cstddef>
#include <map>
#include <optional>

namespace alcove {

struct GltfClip {
    double duration_s = 0.0;                  ///< until the last key; 0 without one
    std::map<std::size_t, Keyframes> weights; ///< of morph targets, by node of the tree
};

/// Reads clip `index` and puts its keys on the nodes of the tree. If none is named: all clips
/// together where no two of them move the same thing (exporters of old wrote a clip a bone), else
/// the first. Channels that cannot be played, and other clips, are named in `warnings`. Throws
/// InputError on an index out of range, times that do not ascend from 0 or more, values that are
/// not finite or too few, and two channels of one target.
[[nodiscard]] GltfClip read_clip(const GltfDocument& document, std::optional<int> index,
                                 GltfTree& tree, GltfWarnings& warnings);

} // namespace alcove
