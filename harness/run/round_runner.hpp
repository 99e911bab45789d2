#pragma once
// One round (DESIGN 3.1 to 3.5): R timing replays in which all cells share every frame in shuffled
// order, then one capture replay that takes images and stores no time.

#include "core/frame/scene_renderer.hpp"
#include "harness/run/method_cell.hpp"
#include "harness/run/reference_store.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <optional>

namespace alcove {

struct RoundResult {
    std::vector<SampleRow> samples;
    std::vector<MetricRow> metrics;
    RoundDone done;
};

/// What the caller hears from a round while it runs.
struct RoundEvents {
    /// After each frame of each replay: frames done and frames in all.
    std::function<void(std::size_t, std::size_t)> progress = [](std::size_t, std::size_t) {};
    /// After each timing replay, with all samples so far and the repeats that are finished.
    std::function<void(const std::vector<SampleRow>&, int)> repeat_done =
        [](const std::vector<SampleRow>&, int) {};
};

class RoundRunner {
  public:
    /// Everything passed by reference must outlive the runner. `run_folder` is where pictures go.
    RoundRunner(gl::Context& context, gl::TimerMode timer_mode, const Units& units,
                const PlanRecord& plan, const RoundRecord& round, const Scene& scene,
                std::filesystem::path run_folder);

    [[nodiscard]] RoundResult run(const RoundEvents& events);

  private:
    struct Frame {
        int segment;
        FrameView view;
    };
    void time_repeat(int repeat, const RoundEvents& events);
    void time_frame(const Frame& frame, int repeat);
    void time_converged(int repeat);
    void capture(const RoundEvents& events);
    void capture_frame(const Frame& frame, SampleState state);
    void capture_cell(MethodCell& cell, const Frame& frame, SampleState state,
                      const ReferencePair& reference, const Image& reference_mean,
                      bool keeps_images);
    void render_gbuffers(const Frame& frame, std::optional<int> repeat);
    void reset_histories();
    void warm_up(const Frame& frame);
    [[nodiscard]] MethodInputs make_inputs(const MethodCell& cell, const FrameView& view) const;
    [[nodiscard]] const GBuffer& get_gbuffer(const MethodCell& cell) const;
    void compose(const MethodInputs& inputs, const MethodOutput& output, PassTiming timing);
    void add_cell_samples(const MethodCell& cell, const Frame& frame, int repeat, SampleState state,
                          PassTiming timing, const CellTimes& times);
    void add_sample(const std::string& cell, const Frame& frame, int repeat, SampleKind kind,
                    SampleState state, const std::string& pass, std::int64_t time_ns);
    void write_picture(const std::string& cell, int frame, const char* picture, const Image& codes);
    [[nodiscard]] std::vector<Frame> list_singles() const;

    gl::Context& m_context;
    const gl::Functions& m_gl;
    const Units& m_units;
    const PlanRecord& m_plan;
    const RoundRecord& m_round;
    const Scene& m_scene;
    std::filesystem::path m_run_folder;
    gl::IntervalTimer m_timer;
    ImageSize m_size;
    Target m_target;
    SceneRenderer m_renderer;
    Compose m_compose;
    ReferenceStore m_references;
    std::map<ChannelSet, GBuffer> m_gbuffers; ///< the base and each set beyond it
    std::vector<MethodCell> m_cells;
    std::vector<std::pair<const MetricUnit*, std::unique_ptr<Metric>>> m_metrics;
    std::vector<Frame> m_frames;
    PosedGeometry m_geometry;
    RoundResult m_result;
    std::size_t m_frames_done = 0;
};

} // namespace alcove
