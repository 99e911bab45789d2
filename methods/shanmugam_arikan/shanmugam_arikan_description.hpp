#pragma once
// What shanmugam_arikan declares: its parameters and its presets.

#include "core/contract/method.hpp"

namespace alcove {

[[nodiscard]] ParameterTable make_shanmugam_arikan_table();
[[nodiscard]] std::vector<Preset> make_shanmugam_arikan_presets();

} // namespace alcove
