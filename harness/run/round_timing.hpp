#pragma once
// The timing replays of a round (DESIGN 3.1 to 3.5): all cells share every frame in shuffled order,
// nothing is read back, every sample is kept.

#include "harness/run/round_stage.hpp"

#include <functional>
#include <memory>

namespace alcove {

class RoundTiming {
  public:
    /// Rows and wall times go where they are told to; all must outlive it.
    RoundTiming(RoundStage& stage, std::vector<SampleRow>& samples, RoundDone& done)
        : m_stage(stage), m_samples(samples), m_done(done) {}

    /// One frame of everything, of which nothing is kept: compilation and first use are timed
    /// apart.
    void warm_up();
    /// All frames cold, then the converged frames of methods with a history. `frame_done` is called
    /// after each cold frame.
    void time_repeat(int repeat, const std::function<void()>& frame_done);
    /// After the last repeat: leaves the round's G-buffers and their times in the cache.
    void store_gbuffers();

  private:
    /// A method of its own that holds its converged history over all repeats, so that it is warmed
    /// up once.
    struct ConvergedCell {
        RoundFrame frame;
        std::unique_ptr<MethodCell> cell;
    };

    /// What drawing a G-buffer costs: now, or in the run that left it in the cache.
    struct InputTime {
        std::int64_t ns = 0;
        bool is_cached = false;
    };

    [[nodiscard]] std::optional<InputTime> time_gbuffer(const GBufferKey& key,
                                                        const RoundFrame& frame, int repeat);
    void time_gbuffers(const RoundFrame& frame, int repeat);
    void time_frame(const RoundFrame& frame, int repeat);
    void time_converged(int repeat);
    void warm_converged_cells();
    void add_cell_samples(const MethodCell& cell, const RoundFrame& frame, int repeat,
                          SampleState state, PassTiming timing, const CellTimes& times);
    void add_sample(const std::string& cell, const RoundFrame& frame, int repeat, SampleKind kind,
                    SampleState state, const std::string& pass, std::int64_t time_ns);

    RoundStage& m_stage;
    std::vector<SampleRow>& m_samples;
    RoundDone& m_done;
    std::vector<ConvergedCell> m_converged;
    RoundStage::GBufferTimes m_gbuffer_times; ///< of what was drawn
};

} // namespace alcove
