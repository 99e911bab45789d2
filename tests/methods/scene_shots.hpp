#pragma once
// Frames of a registered scene through any method, one after the other, as the runner shows them.

#include "harness/stability/scene_rig.hpp"
#include "tests/core/gl/test_context.hpp"

#include <memory>
#include <optional>
#include <string>

namespace alcove {

/// A scene with its renderer and the frame that is shown.
class SceneShots {
  public:
    /// "key=value,..." are the scene's settings. Asserts that the scene can be opened.
    SceneShots(gl::Context& context, const std::string& scene, const std::string& settings,
               ImageSize size);

    [[nodiscard]] const Scene& scene() const { return *m_scene; }
    /// "METHOD[@PRESET][:key=value,...]" with the scene's radius.
    [[nodiscard]] std::unique_ptr<Method> make_method(const std::string& specification) const;

    [[nodiscard]] FrameView get_view(int frame, bool starts_segment = false) const {
        return m_rig.get_view(frame, starts_segment);
    }
    using Shot = RigShot; ///< with the history state
    [[nodiscard]] Shot shoot(Method& method, const FrameView& view, std::uint32_t seed = 1);
    /// `frames` frames of the held pose behind a fresh start; the last one is kept.
    [[nodiscard]] Shot converge(Method& method, int frame, int frames);
    [[nodiscard]] Image read_depth(const FrameView& view) { return m_rig.read_depth(view); }

  private:
    gl::Context& m_context;
    ImageSize m_size;
    std::unique_ptr<Scene> m_scene;
    SceneRig m_rig;
};

/// Root mean square of a - b over the pixels where `mask` is not 0; over all without a mask.
[[nodiscard]] double compute_rms(const Image& a, const Image& b, const Image* mask = nullptr);

} // namespace alcove
