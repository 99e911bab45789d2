#pragma once
// The relief of one storey's wall as meshes: what facades.cpp puts on houses. Drawn like openings,
// y from the storey's floor, x from -bays/2 to bays/2 bays.

#include "scenes/city/kit.hpp"
#include "scenes/city/style.hpp"

#include <cstddef>
#include <vector>

namespace alcove::city {

enum class StoreyKind {
    ground, ///< shop windows and, in the front's third bay, a door; rusticated piers
    noble,  ///< the first upper storey: pediments
    upper,  ///< hoods
    court,  ///< plain
};

/// Adds the meshes of a storey: wall with holes, glass and, but for courts, trim. To be placed
/// together. `steps` as Kit::steps: of the mouldings.
[[nodiscard]] std::vector<std::size_t> add_storey(Kit& kit, const Style& style, StoreyKind kind,
                                                  int bays, int steps);
/// Below the eaves, y from the top of the wall.
[[nodiscard]] std::size_t add_cornice(Kit& kit, const Style& style, int bays);
/// Two bays wide, around x = 0.
[[nodiscard]] std::size_t add_balcony(Kit& kit, const Style& style);
/// At the house's edge, from the pavement to the wall's top.
[[nodiscard]] std::size_t add_quoin(Kit& kit, const Style& style, int storeys);

} // namespace alcove::city
