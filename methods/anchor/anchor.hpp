#pragma once
// The yardstick of every time: one pass, 32 fetches of eye depth at fixed offsets. Times of
// different rounds and runs are compared only through their ratio to it.

#include "core/contract/method.hpp"

namespace alcove {

/// Raised whenever anchor.frag.glsl changes; times against different versions are never compared.
inline constexpr const char* kAnchorVersion = "1";

[[nodiscard]] MethodUnit anchor_unit();

} // namespace alcove
