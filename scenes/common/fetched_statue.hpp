#pragma once
// Statues that `alcove scene fetch` has brought (get_fetched_scenes_folder).

#include "core/contract/scene.hpp"

#include <string>

namespace alcove {

/// <name>/<name>.off, scaled to `height_m` along +Y, standing on y = 0 with the middle of its
/// bounding box over the origin. Throws InputError with the command that fetches it if it is not
/// there, and as parse_off does.
[[nodiscard]] Mesh read_fetched_statue(const std::string& name, double height_m);

} // namespace alcove
