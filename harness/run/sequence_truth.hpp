#pragma once
// What metrics over time know of a sequence beside the method's images: truth some frames ago as
// seen from now, along the surfaces' motion from the full-precision G-buffer.

#include "core/contract/temporal_metric.hpp"
#include "core/frame/reprojection.hpp"
#include "harness/run/truth.hpp"

#include <deque>

namespace alcove {

class SequenceTruth {
  public:
    explicit SequenceTruth(RoundStage& stage);

    /// Forgets the sequence; at each cut.
    void reset();
    /// The stage's frame, with its truth.
    void add(const FrameView& view, const Truth& truth);

    [[nodiscard]] std::span<const EarlierFrame> earlier() const { return m_earlier; }
    /// Of the stage's frame, whether or not it was added.
    [[nodiscard]] SurfaceImages read_surfaces();
    /// Of the frame that was added last; asserts that there is one.
    [[nodiscard]] const SurfaceImages& surfaces() const;
    /// 1 where the pixel shows a surface.
    [[nodiscard]] const Image& surface() const { return m_surface; }
    /// 1 where the object under the pixel has moved since the last frame.
    [[nodiscard]] const Image& moves() const { return m_moves; }

  private:
    /// Truth of one earlier frame and the ways back from it.
    struct Past {
        Truth truth;
        std::array<std::optional<Correspondence>, kEarlierSteps.size()> back;
    };

    RoundStage& m_stage;
    GBuffer m_gbuffer; ///< full precision, whatever the methods see
    std::optional<SurfaceImages> m_newest;
    std::deque<Past> m_past; ///< the newest last; as many as the longest step
    std::vector<EarlierFrame> m_earlier;
    Image m_surface;
    Image m_moves;
};

} // namespace alcove
