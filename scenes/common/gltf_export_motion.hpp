#pragma once
// What moves in an exported scene.

#include "core/contract/scene.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include <glm/gtc/quaternion.hpp>

namespace alcove {

class GlbBuilder;

/// A transform as nodes of a glTF file animate it.
struct NodePlace {
    glm::dvec3 translation{0.0};
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
    glm::dvec3 scale{1.0};
};

/// Nothing if the matrix shears by more than 1e-9 or has no volume.
[[nodiscard]] std::optional<NodePlace> split_transform(const glm::dmat4& matrix);

/// Adds an animation with keys at every frame and one after the last, over nodes that were given
/// their places frame by frame.
class MotionExporter {
  public:
    /// One key a frame: frames, seconds between two.
    MotionExporter(GlbBuilder& glb, std::size_t frames, double step_s);
    ~MotionExporter();
    MotionExporter(const MotionExporter&) = delete;
    MotionExporter& operator=(const MotionExporter&) = delete;

    /// Asserts one place a frame.
    void add(std::size_t node, const std::vector<NodePlace>& places);
    /// Writes the animation if a node was added.
    void finish();

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace alcove
