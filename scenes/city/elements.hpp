#pragma once
// The elements of the city, one source file each. All add closed solids to the kit.

#include "scenes/city/movers.hpp"
#include "scenes/city/plan.hpp"
#include "scenes/city/style.hpp"

#include <vector>

namespace alcove::city {

void add_ground(Kit& kit, const Plan& plan); ///< ground.cpp: carriageways, rails, pavements, lawns
/// houses.cpp: walls, roofs with chimneys, dormers
void add_houses(Kit& kit, const Plan& plan, const std::vector<Style>& styles);
/// facades.cpp: relief of the walls within reach
void add_facades(Kit& kit, const Plan& plan, const std::vector<Style>& styles);
void add_church(Kit& kit, const Plan& plan);    ///< church.cpp: on the square
void add_trees(Kit& kit, const Plan& plan);     ///< trees.cpp: along streets, in parks and courts
void add_furniture(Kit& kit, const Plan& plan); ///< furniture.cpp: lamps, bollards, benches
void add_vehicles(Kit& kit, Movers& movers);    ///< vehicles.cpp: traffic and parked cars
void add_figures(Kit& kit, Movers& movers);     ///< figures.cpp: pedestrians

} // namespace alcove::city
