#pragma once
// A round's scene, G-buffers and living methods: what its timing and its capture share.

#include "harness/run/method_cell.hpp"
#include "harness/run/round_gbuffers.hpp"

#include <map>
#include <optional>
#include <span>
#include <vector>

namespace alcove {

/// Seed of methods' noise; one for all runs, so that images are comparable between them.
inline constexpr std::uint32_t kRoundNoiseSeed = 1;

/// One frame of one segment.
struct RoundFrame {
    int segment = 0;
    FrameView view;
    /// Histories are converged on this pose before the frame is shown (RoundRecord::warm).
    bool is_warmed = false;
};

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
    [[nodiscard]] const Target& target() const { return m_target; }
    /// Are pictures measured (the target is radiance), not visibility?
    [[nodiscard]] bool measures_pictures() const {
        return m_target.output == TargetOutput::radiance;
    }
    /// Of the images that are measured: pictures are linear light for a display.
    [[nodiscard]] Domain measured_domain() const {
        return measures_pictures() ? Domain::linear : Domain::visibility;
    }
    [[nodiscard]] const std::vector<RoundFrame>& frames() const { return m_frames; }
    [[nodiscard]] std::vector<RoundFrame> list_singles() const;
    [[nodiscard]] std::vector<MethodCell>& cells() { return m_cells; }
    /// Of the base and of all cells, the base first.
    [[nodiscard]] std::vector<GBufferKey> list_gbuffers() const;

    /// Poses the scene. Every later call speaks of this frame.
    void set_frame(const FrameView& view);
    /// One of frames(), whose stored times can then be asked for.
    void set_frame(const RoundFrame& frame);
    /// Makes G-buffers in the round's precision, unless they are there.
    void add_gbuffers(const std::vector<GBufferKey>& keys);
    /// Resets GL state, waits for the device, and draws, timed; for `time_ns`, or, where every
    /// G-buffer of the round is in the cache, loads and returns nothing.
    std::optional<std::int64_t> time_gbuffer(const GBufferKey& key);
    /// Draws whatever the cache has; nanoseconds.
    [[nodiscard]] std::int64_t draw_gbuffer_timed(const GBufferKey& key);
    /// The same untimed: loads what the cache has, draws what it has not.
    void render_gbuffer(const GBufferKey& key);
    void render_gbuffers(const std::vector<GBufferKey>& keys);
    /// What drawing the frame's G-buffer has cost, one time a repeat; empty unless it was loaded.
    [[nodiscard]] std::span<const std::int64_t> find_stored_times(const GBufferKey& key) const;
    /// Once times are taken: puts the frames' G-buffers into the cache with `times_ns`, which maps
    /// a frame's place in frames() and a key to one time a repeat; audits those that were there.
    using GBufferTimes = std::map<std::pair<std::size_t, GBufferKey>, std::vector<std::int64_t>>;
    void store_gbuffers(const GBufferTimes& times_ns);

    [[nodiscard]] const GBuffer& get_gbuffer(const GBufferKey& key) const {
        return m_gbuffers.get(key);
    }
    [[nodiscard]] const RoundGBuffers& gbuffers() const { return m_gbuffers; }
    /// What the cell's method declares: its ordinary G-buffer first, then its parts in order.
    [[nodiscard]] static std::vector<GBufferKey> list_keys(const MethodCell& cell);
    /// For a timed frame, or one whose image nobody looks at.
    [[nodiscard]] MethodInputs make_inputs(const MethodCell& cell);
    /// The same for an image that is measured: a method that gives radiance is asked for its
    /// visibility too where the target is visibility.
    [[nodiscard]] MethodInputs make_measured_inputs(const MethodCell& cell);
    /// The image that is measured, from the output of the stage's frame: visibility, one channel;
    /// or the shaded picture behind tone_map, three. The base G-buffer must be that of the frame
    /// where pictures are measured. Throws InputError if the method leaves no visibility where that
    /// is measured, FailureError on GL errors.
    [[nodiscard]] Image read_measured(const MethodCell& cell, const MethodOutput& output);
    /// What a frame asks for before it is shown: histories forgotten at a segment's start and at a
    /// cut, and converged where the frame is warmed.
    void prepare_histories(const RoundFrame& frame);
    /// Forgets the cell's history and renders it for its warm_frames() with the frame held, which
    /// stays set, with its G-buffers and the base.
    void warm_up(MethodCell& cell, const FrameView& view);
    /// The shaded picture of a method's output (of its radiance, where it gives both), in
    /// m_compose's texture, with as many samples a pixel as the cell's method declares; of one
    /// sample without a cell.
    void compose(const MethodCell* cell, const MethodOutput& output, PassTiming timing);
    [[nodiscard]] const gl::Texture& picture() const { return m_compose.picture(); }
    /// Draws the frame into a G-buffer of the caller's, without border.
    void draw(const GBuffer& gbuffer);

  private:
    /// For a cell that need not be one of the stage's.
    void set_frame_of(const MethodCell& cell, const FrameView& view);
    /// All frames as they are drawn: as replayed, and held where histories converge.
    [[nodiscard]] std::vector<FrameView> list_views() const;
    [[nodiscard]] bool find_all_stored();

    gl::Context& m_context;
    const Units& m_units;
    const PlanRecord& m_plan;
    const RoundRecord& m_round;
    const Scene& m_scene;
    gl::IntervalTimer m_timer;
    ImageSize m_size;
    Target m_target;
    Compose m_compose;
    Surroundings m_surroundings;
    RoundGBuffers m_gbuffers;
    std::map<GBufferKey, FrameView> m_views; ///< this frame, as each G-buffer shows it
    std::vector<MethodCell> m_cells;
    std::vector<RoundFrame> m_frames;
    Lights m_lights; ///< of this frame
    PosedGeometry m_geometry;
    /// Every G-buffer of the round was in the cache, with its times, when the round began.
    bool m_loads_gbuffers = false;
    GBufferTimes m_stored_times;
    std::optional<std::size_t> m_frame; ///< place in m_frames of the frame that is set
};

} // namespace alcove
