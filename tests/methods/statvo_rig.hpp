#pragma once
// Depth images for statvo, with a second layer.

#include "methods/statvo/statvo.hpp"
#include "tests/methods/depth_image_rig.hpp"

namespace alcove {

/// Prime: the last samples of a row and a column are cut at any size of samples.
inline constexpr ImageSize kStatvoSize{41, 31};

struct StatvoScene {
    DepthImage visible;
    Image hidden; ///< depths of the second layer
};

/// A rough floor and wall, a post and a block before them, open background behind a window; every
/// pixel with a depth of its own, so that hardly one lies at the mean of its layer. Behind post and
/// block floor and wall go on.
[[nodiscard]] StatvoScene make_statvo_scene(ImageSize size);

class StatvoRig : public DepthImageTest {
  protected:
    using Overrides = std::vector<std::pair<std::string, std::string>>;
    /// With the second layer for those who ask for it.
    RigResult run_peeled(const MethodUnit& unit, const ResolvedParameters& resolved,
                         const DepthImage& visible, const Image& hidden);
    [[nodiscard]] static std::string describe(const Overrides& settings);
    const MethodUnit m_unit = statvo_unit();
};

} // namespace alcove
