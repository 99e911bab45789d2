#pragma once
// Runs one method on depth and normal images that are written straight into a G-buffer: no scene,
// no rasteriser.

#include "core/contract/method.hpp"
#include "tests/core/gl/test_context.hpp"

#include <string>
#include <vector>

namespace alcove {

/// What a method sees: rows from the top. Background depth is infinite.
struct DepthImage {
    Image depth;
    Image normal; ///< 3 channels, view space
    Camera camera;
};

struct RigResult {
    Image visibility;
    Image normal; ///< as the half-float texture holds it
    std::vector<std::string> passes;
};

/// One channel, all `depth_m`, normals (0, 0, 1), a camera of 60 degrees.
[[nodiscard]] DepthImage make_wall_image(ImageSize size, float depth_m);

class DepthImageTest : public GlTest {
  protected:
    RigResult run(const MethodUnit& unit, const ResolvedParameters& resolved,
                  const DepthImage& input, std::uint32_t noise_seed = 1);
    /// The preset's parameters under `overrides` ("name", "value"); scene_radius is 0.5 m.
    static ResolvedParameters
    resolve(const MethodUnit& unit, const std::string& preset,
            const std::vector<std::pair<std::string, std::string>>& overrides);
};

} // namespace alcove
