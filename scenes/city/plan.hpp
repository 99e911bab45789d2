#pragma once
// Who stands where: blocks and lots. The same at every detail.

#include "scenes/city/kit.hpp"

#include <vector>

#include <glm/mat4x4.hpp>

namespace alcove::city {

inline constexpr int kStyles = 6;
inline constexpr int kLowestHouse = 3; ///< storeys, ground floor included
inline constexpr int kHighestHouse = 6;

enum class BlockUse { houses, park, square };

struct Block {
    glm::dvec3 middle{0.0}; ///< on the carriageway's level
    BlockUse use = BlockUse::houses;
};

/// A house in the row around a block. Rows run like the blades of a pinwheel, so that each corner
/// of the block belongs to one row's first house.
struct Lot {
    /// x along the front, z towards the street, zero on the pavement below the middle of the wall.
    glm::dmat4 frame{1.0};
    int storeys = kLowestHouse;
    int style = 0;
    bool is_corner = false; ///< its end at -x stands at a street
    /// How far its storeys and roof are raised: neighbours differ, so that no faces of theirs share
    /// a plane. Their fronts differ as well, within the frame.
    double lift = 0.0;
    double distance_m = 0.0; ///< to the route of the walkthroughs
    std::uint64_t salt = 0;  ///< for Kit::make_random
};

struct Plan {
    std::vector<Block> blocks;
    std::vector<Lot> lots;
};

[[nodiscard]] Plan make_plan(const Kit& kit);

/// Top of the wall above the lot's frame, without lift.
[[nodiscard]] constexpr double get_wall_height(int storeys) {
    return kGroundFloor + kStorey * (storeys - 1) + kAttic;
}

} // namespace alcove::city
