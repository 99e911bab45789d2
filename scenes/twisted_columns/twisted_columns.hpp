#pragma once
// Twisted columns, a pink one hidden behind a white one. See README.md.

#include "core/contract/scene.hpp"

namespace alcove {

[[nodiscard]] SceneUnit twisted_columns_unit();

} // namespace alcove
