#pragma once
// A skeleton of closed bones, a rigid mesh a limb.

#include "core/contract/scene.hpp"
#include "scenes/common/gait.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace alcove {

/// Metres; about 1.75 high.
[[nodiscard]] const WalkerBody& get_skeleton_body();

struct SkeletonMeshes {
    std::vector<Mesh> meshes; ///< each of several closed solids, in the limb's space
    std::array<std::size_t, kLimbs> of_limb{};
};
/// `thickness_m` is the diameter of the shafts of the long bones; ribs, vertebrae and fingers
/// follow it. `detail` scales the number of vertices.
[[nodiscard]] SkeletonMeshes make_skeleton(double thickness_m, double detail);

} // namespace alcove
