#pragma once
// Light from all around as a set of directional lights of about equal energy: each stands for a run
// of texels of the octahedral map and keeps that run's energy, colour and mean direction exactly.

#include "core/contract/scene.hpp"

#include <vector>

namespace alcove {

/// At most `count` lights that cast shadows; in the map's own axes, before the environment is
/// turned (turn_environment_lights).
[[nodiscard]] std::vector<DirectionalLight> gather_environment_lights(const Lights& lights,
                                                                      int count);
/// The same in world axes.
void turn_environment_lights(std::vector<DirectionalLight>& around, double turn_radians);

} // namespace alcove
