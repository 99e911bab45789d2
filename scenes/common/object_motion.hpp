#pragma once
// Where a track puts its object: rigid motion, linear between keys.

#include "core/contract/scene.hpp"

namespace alcove {

/// translate(translation) * rotate(degrees about the axis through the pivot): what stands in front
/// of the object's transform at rest, relative to the scene's origin. `frame` may lie between two
/// frames; before the first key and after the last one it is that key's. Asserts that there is a
/// key.
[[nodiscard]] glm::dmat4 compute_motion(const ObjectTrack& track, double frame);

/// True if the keys do not all name one place. Asserts that there is a key.
[[nodiscard]] bool has_two_places(const ObjectTrack& track);

} // namespace alcove
