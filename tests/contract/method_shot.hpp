#pragma once
// Renders frames of a scene through one method, as the runner does, and keeps what it leaves.

#include "core/contract/method.hpp"

#include <string>
#include <vector>

namespace alcove {

/// What the last frame left behind.
struct Shot {
    Image visibility;
    Image radiance;      ///< empty if the method leaves none
    Image history_state; ///< empty unless it was asked for and the method has one
    std::vector<std::string> passes;
};

struct ShotSettings {
    ImageSize size{128, 96};
    std::vector<int> frames{0, 1}; ///< in order, so that histories take part
    Method* between = nullptr; ///< rendered before the method in every frame, e.g. a hostile one
    bool wants_history_state = false;
};

/// Resizes the method first. Throws FailureError if it made a GL error.
[[nodiscard]] Shot shoot(gl::Context& context, Method& method, const Scene& scene,
                         const ShotSettings& settings = {});

} // namespace alcove
