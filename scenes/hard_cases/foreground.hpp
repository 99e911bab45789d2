#pragma once
// A post before a wall: seen from the front it covers part of the wall, and is too far from it to
// block any of it.

#include "core/contract/scene.hpp"

#include <memory>

namespace alcove {

/// The wall is 10 m away, the post 0.2 m wide with `gap_m` > 0 of air behind it; radius 0.5 m.
[[nodiscard]] std::unique_ptr<Scene> make_foreground_case(double gap_m);

/// The same wall seen through a slit of 0.2 m between two plates 0.3 m before it: of the directions
/// at the wall nearly all are blocked.
[[nodiscard]] std::unique_ptr<Scene> make_slit_case();

} // namespace alcove
