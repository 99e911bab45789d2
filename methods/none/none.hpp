#pragma once
// No occlusion: visibility 1 and no pass. Its frame total is what the papers call "deferred".

#include "core/contract/method.hpp"

namespace alcove {

[[nodiscard]] MethodUnit none_unit();

} // namespace alcove
