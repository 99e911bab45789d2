#pragma once
// A round's scene, G-buffers and living methods: what its timing and its capture share.

#include "core/frame/scene_renderer.hpp"
#include "harness/run/method_cell.hpp"

#include <map>
#include <vector>

namespace alcove {

/// One frame of one segment.
struct RoundFrame {
    int segment = 0;
    FrameView view;
    /// Histories are converged on this pose before the frame is shown (RoundRecord::warm).
    bool is_warmed = false;
};

/// Cells whose G-buffers are alike share one.
struct GBufferKey {
    ChannelSet channels;
    Border border;
    friend auto operator<=>(const GBufferKey&, const GBufferKey&) = default;
};

/// The G-buffer that every run rasterises.
inline constexpr GBufferKey kBaseGBuffer{kBaseChannels, {}};

class RoundStage {
  public:
    /// Everything passed by reference must outlive the stage.
    RoundStage(gl::Context& context, gl::TimerMode timer_mode, const Units& units,
               const PlanRecord& plan, const RoundRecord& round, const Scene& scene);

    [[nodiscard]] gl::Context& context() const { return m_context; }
    [[nodiscard]] const gl::Functions& gl() const { return m_context.functions(); }
    [[nodiscard]] gl::IntervalTimer& timer() { return m_timer; }
    [[nodiscard]] const Units& units() const { return m_units; }
    [[nodiscard]] const PlanRecord& plan() const { return m_plan; }
    [[nodiscard]] const RoundRecord& round() const { return m_round; }
    [[nodiscard]] const Scene& scene() const { return m_scene; }
    [[nodiscard]] ImageSize size() const { return m_size; }
    [[nodiscard]] const std::vector<RoundFrame>& frames() const { return m_frames; }
    [[nodiscard]] std::vector<RoundFrame> list_singles() const;
    [[nodiscard]] std::vector<MethodCell>& cells() { return m_cells; }
    /// Of the base and of all cells, the base first.
    [[nodiscard]] std::vector<GBufferKey> list_gbuffers() const;

    /// Poses the scene. Every later call speaks of this frame.
    void set_frame(const FrameView& view);
    /// Makes a G-buffer in the round's precision, unless it is there.
    void add_gbuffer(const GBufferKey& key);
    /// Resets GL state, waits for the device, and draws, timed if asked for.
    void render_gbuffer(const GBufferKey& key, PassTiming timing = PassTiming::none);
    void render_gbuffers();

    [[nodiscard]] const GBuffer& get_gbuffer(const GBufferKey& key) const {
        return m_gbuffers.at(key);
    }
    [[nodiscard]] static GBufferKey get_key(const MethodCell& cell) {
        return {cell.channels(), cell.border()};
    }
    [[nodiscard]] MethodInputs make_inputs(const MethodCell& cell) const;
    /// What a frame asks for before it is shown: histories forgotten at a segment's start and at a
    /// cut, and converged where the frame is warmed.
    void prepare_histories(const RoundFrame& frame);
    /// Forgets the cell's history and renders it for its warm_frames() with the frame held, which
    /// stays set, with its G-buffer.
    void warm_up(MethodCell& cell, const FrameView& view);
    /// The shaded picture of a method's output, in m_compose's texture.
    void compose(const MethodOutput& output, PassTiming timing);
    [[nodiscard]] const gl::Texture& picture() const { return m_compose.picture(); }
    /// Draws the frame into a G-buffer of the caller's, without border.
    void draw(const GBuffer& gbuffer);

  private:
    gl::Context& m_context;
    const Units& m_units;
    const PlanRecord& m_plan;
    const RoundRecord& m_round;
    const Scene& m_scene;
    gl::IntervalTimer m_timer;
    ImageSize m_size;
    SceneRenderer m_renderer;
    Compose m_compose;
    Precision m_precision;
    std::map<GBufferKey, GBuffer> m_gbuffers;
    std::map<Border, FrameView> m_views; ///< this frame, extended by each border
    std::vector<MethodCell> m_cells;
    std::vector<RoundFrame> m_frames;
    PosedGeometry m_geometry;
};

} // namespace alcove
