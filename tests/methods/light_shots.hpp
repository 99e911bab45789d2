#pragma once
// Frames of a scene in its light through methods that give radiance.

#include "core/contract/method.hpp"
#include "core/contract/method_gbuffers.hpp"
#include "tests/core/gl/test_context.hpp"

#include <string>

namespace alcove {

struct LightShot {
    Image radiance;                  ///< what the method gives
    Image direct;                    ///< the G-buffer's
    Image albedo;                    ///< the G-buffer's
    Image eye_depth;                 ///< infinite on the background
    Image normal;                    ///< view space
    Image visibility;                ///< what the method gives on demand
    std::vector<std::string> passes; ///< without those on demand
};

class LightShotTest : public GlTest {
  protected:
    /// "key=value,..." over the unit's defaults with the scene's radius.
    [[nodiscard]] static LightShot shoot(const MethodUnit& unit, const std::string& settings,
                                         const Scene& scene, ImageSize size, int frame = 0);
};

/// A registered scene in other light: "colour_blocks", "environment=two_colour,sun=0", both as on
/// the command line. `own` are the scene's own settings.
[[nodiscard]] std::unique_ptr<Scene> open_lit_scene(const std::string& name, const std::string& own,
                                                    const std::string& lighting);

} // namespace alcove
