#include "scenes/city/plan.hpp"

#include <utility>

namespace alcove::city {
namespace {

BlockUse get_use(int column, int row) {
    if (column == 5 && row == 4) {
        return BlockUse::square;
    }
    const bool is_park = (column == 2 && row == 7) || (column == 7 && row == 2) ||
                         (column == 8 && row == 6) || (column == 1 && row == 2);
    return is_park ? BlockUse::park : BlockUse::houses;
}

void add_row(const Kit& kit, const Block& block, std::uint64_t block_salt, int quarter_turns,
             std::vector<Lot>& lots) {
    constexpr int kLots = 4; // four fronts and the depth of the next row's first house fill a side
    static_assert(kLots * kLotWidth + kLotDepth == 2.0 * kHalfBlock);
    const glm::dmat4 row = make_frame(block.middle, quarter_turns);
    for (int i = 0; i < kLots; ++i) {
        Lot lot;
        lot.salt = (block_salt * 4 + static_cast<std::uint64_t>(quarter_turns)) * kLots +
                   static_cast<std::uint64_t>(i);
        SplitMix random = kit.make_random(lot.salt);
        lot.storeys = kLowestHouse + random.draw_index(kHighestHouse - kLowestHouse + 1);
        lot.style = random.draw_index(kStyles);
        lot.is_corner = i == 0;
        const double setback = i % 2 == 0 ? 0.0 : 0.14;
        lot.lift = i % 2 == 0 ? 0.0 : 0.22;
        lot.frame =
            shift(row, {-kHalfBlock + kLotWidth * (i + 0.5), kPavement, kHalfBlock - setback});
        lot.distance_m = measure_distance_to_route(glm::dvec3(lot.frame[3]));
        lots.push_back(lot);
    }
}

} // namespace

Plan make_plan(const Kit& kit) {
    Plan plan;
    for (int row = 0; row < kBlocks; ++row) {
        for (int column = 0; column < kBlocks; ++column) {
            Block block;
            block.middle = {kPitch * (column - 0.5 * (kBlocks - 1)), 0.0,
                            kPitch * (row - 0.5 * (kBlocks - 1))};
            block.use = get_use(column, row);
            if (block.use == BlockUse::houses) {
                for (int turns = 0; turns < 4; ++turns) {
                    add_row(kit, block, plan.blocks.size(), turns, plan.lots);
                }
            }
            plan.blocks.push_back(block);
        }
    }
    return plan;
}

} // namespace alcove::city
