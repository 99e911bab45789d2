#pragma once
// tssao fed with depth, normal and motion images frame by frame: no scene, no rasteriser.

#include "methods/tssao/tssao_renderer.hpp"
#include "tests/core/gl/test_context.hpp"
#include "tests/methods/depth_image_rig.hpp"

#include <memory>
#include <optional>
#include <string>

namespace alcove {

/// What one frame left.
struct TssaoFrame {
    Image visibility;
    Image history; ///< occlusion, count, index, eye depth
    Image state;   ///< HistoryChannel
    std::vector<std::string> passes;
};

class TssaoTest : public GlTest {
  protected:
    /// A method of that preset under "name=value,..." settings; scene_radius is 0.5 m.
    void make(ImageSize size, const std::string& settings, const std::string& preset = "default");
    /// The next frame. `motion`: 3 channels or nothing for 0. The camera of `image` is this
    /// frame's; the one before is that of the last call.
    TssaoFrame render(const DepthImage& image, const Image* motion = nullptr);
    /// Writes four channels into the history at one pixel, row 0 on top.
    void plant(int x, int y, const std::array<float, 4>& values);

    [[nodiscard]] const TssaoParams& params() const { return m_params; }

  private:
    TssaoParams m_params;
    ImageSize m_size;
    std::unique_ptr<TssaoRenderer> m_method;
    std::optional<GBuffer> m_gbuffer;
    std::optional<Camera> m_previous_camera;
    int m_frame = 0;
};

} // namespace alcove
