#pragma once
// The parameter table and the presets of crytek_ssao.

#include "methods/crytek_ssao/crytek_ssao.hpp"

namespace alcove {

[[nodiscard]] ParameterTable make_crytek_table();
[[nodiscard]] std::vector<Preset> make_crytek_presets();

} // namespace alcove
