#pragma once
// The elements of the building, one source file each. All add closed solids to the kit.

#include "scenes/cathedral/kit.hpp"

namespace alcove::cathedral {

void add_walls(
    Kit& kit); ///< walls.cpp: floor, nave walls over the arcade, outer walls with niches, both ends
void add_windows(Kit& kit); ///< windows.cpp: tracery of clerestory and rose
void add_columns(Kit& kit); ///< columns.cpp: arcade columns, wall shafts, aisle responds
void add_vaults(Kit& kit);  ///< vaults.cpp: groin vaults of nave and aisles
void add_ribs(Kit& kit); ///< ribs.cpp: transverse, diagonal and wall ribs, bosses, arcade mouldings
void add_apse(Kit& kit); ///< apse.cpp: half-round wall with half dome, ribs, cornice, altar
void add_choir(Kit& kit);     ///< choir.cpp: raised floor, stairs, balustrades, west gallery
void add_furniture(Kit& kit); ///< furniture.cpp: pews, urns in the niches
/// aisle_furniture.cpp: above detail 8, chairs along the outer walls and stands of candles
void add_aisle_furniture(Kit& kit);

} // namespace alcove::cathedral
