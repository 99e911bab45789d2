#pragma once
// The tracks of a walkthrough over the objects of a scene.

#include "core/contract/scene.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace alcove {

/// Which track moves each object. A track of an object that the scene lacks moves nothing:
/// check_scene refuses it.
class ObjectTracks {
  public:
    ObjectTracks() = default;
    /// Asserts tracks with keys.
    ObjectTracks(const Walkthrough& walkthrough, std::span<const Object> objects);

    /// True if the object's track has two places.
    [[nodiscard]] bool moves(std::size_t object) const { return m_moves[object]; }
    [[nodiscard]] bool move_any() const;

    /// Puts the motion of the tracks (compute_motion) in front of the transforms, at frame time_s /
    /// step_s. A time within 1e-9 frames of a frame counts as that frame, since f * step_s / step_s
    /// may miss f by a bit.
    void apply(const Walkthrough& walkthrough, double time_s,
               std::span<glm::dmat4> object_to_scene) const;

  private:
    struct Tracked {
        std::size_t object;
        std::size_t track; ///< of the walkthrough
    };
    std::vector<Tracked> m_tracked;
    std::vector<bool> m_moves;
};

/// Puts frame 0 among the cuts if it is missing, and moves the cameras by `origin`: from what an
/// author writes to what a scene returns.
void place_walkthrough(Walkthrough& walkthrough, const glm::dvec3& origin);

} // namespace alcove
