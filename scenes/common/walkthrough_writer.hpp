#pragma once
// walkthrough.json (see walkthrough_file.hpp) of a walkthrough: one pose a frame.

#include "core/contract/scene.hpp"

#include <string>

namespace alcove {

/// The text of a file that parse_walkthrough reads back: cameras within a few units of the last
/// place, cuts, events and tracks as they are. The format has one near and one far plane: the
/// nearest and the farthest of all cameras.
[[nodiscard]] std::string write_walkthrough(const Walkthrough& walkthrough);

} // namespace alcove
