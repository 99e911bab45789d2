#pragma once
// A floor that meets a wall along one axis of the image, seen square on: everything is the same
// along that axis, so that any line across it is the method's own.

#include "core/contract/scene.hpp"

#include <memory>

namespace alcove {

enum class GrooveAxis { horizontal, vertical };

/// The edge runs along the image's `axis` through its centre, 4 m from the camera, without ends in
/// sight; radius 0.5 m.
[[nodiscard]] std::unique_ptr<Scene> make_groove_case(GrooveAxis axis);

} // namespace alcove
