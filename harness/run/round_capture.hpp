#pragma once
// The capture replay of a round (DESIGN 3.2): takes images, measures them against truth, and stores
// no time. Bursts are followed as sequences: metrics over time, histories, a film. Metrics over
// time look at one channel: visibility, or the luminance (Rec. 709, linear) of pictures.

#include "harness/run/metric_spec.hpp"
#include "harness/run/round_pictures.hpp"
#include "harness/run/round_reuse.hpp"
#include "harness/run/sequence_truth.hpp"
#include "harness/run/strata.hpp"

#include <filesystem>
#include <functional>

namespace alcove {

class RoundCapture {
  public:
    /// Rows and wall times go where they are told to; pictures below `run_folder`. Only what
    /// `reuse` wants is captured.
    RoundCapture(RoundStage& stage, const RoundReuse& reuse, std::vector<MetricRow>& rows,
                 RoundDone& done, std::filesystem::path run_folder);

    /// All frames cold, then the singles converged. `frame_done` is called after each cold frame.
    void run(const std::function<void()>& frame_done);

  private:
    /// `name` is the specification, which is the column's name.
    struct ImageMetric {
        std::string name;
        ResolvedMetric resolved;
        std::unique_ptr<Metric> metric;
    };
    struct SequenceMetric {
        std::string name;
        const MetricUnit* unit;
        std::unique_ptr<TemporalMetric> metric;
    };
    /// One cell's way through a sequence.
    struct CellSequence {
        std::vector<SequenceMetric> metrics;
        HistoryRecord history;
        std::vector<Image> flicker; ///< |D| of each frame of the film
        ProfileStrip profile;       ///< of the film
    };
    /// What a cell left for one frame.
    struct CellImages {
        Image measured; ///< RoundStage::read_measured
        std::optional<Image> history_state;
        std::string hash;
    };
    struct Stratum {
        std::string name;
        Image mask;
    };
    /// What is asked of a frame's surfaces beside the truth of sequences.
    struct Geometry {
        std::optional<Image> eye_depth; ///< for metrics that need it
        std::vector<Stratum> strata;    ///< those that the plan measures
    };
    /// A frame that is being captured, and with what state.
    struct Shot {
        const RoundFrame& frame;
        SampleState state;
        const Truth& truth;
        const Truth& luma; ///< of `truth`, one channel; the same object where that has one
        const Geometry& geometry;
        bool is_in_sequence;
        bool is_last; ///< of its sequence
        bool is_film;
        bool ends_film;
        bool keeps_pictures;
    };

    /// Which strata the plan's columns are over.
    void choose_strata();
    void capture_frame(std::size_t index);
    void capture_converged(const RoundFrame& single);
    [[nodiscard]] Truth get_truth(const FrameView& view);
    /// Of the stage's frame; `surfaces` where they have been read already.
    [[nodiscard]] Geometry make_geometry(const FrameView& view, const Truth& luma,
                                         const SurfaceImages* surfaces);
    [[nodiscard]] CellImages take_images(MethodCell& cell, MethodOutput& output);
    void measure_images(const MethodCell& cell, const CellImages& images, const Shot& shot);
    void measure_strata(const MethodCell& cell, const CellImages& images, const Shot& shot);
    /// One row: a metric's result under a column.
    void add_row(const MethodCell& cell, const CellImages& images, const Shot& shot,
                 const std::string& column, const MetricResult& result);
    void measure_sequence(const MethodCell& cell, const CellImages& images, const Shot& shot);
    void add_history_rows(const MethodCell& cell, const CellImages& images, const Shot& shot,
                          const Image* age);
    [[nodiscard]] MetricRow make_row(const MethodCell& cell, const CellImages& images,
                                     const Shot& shot, const std::string& metric) const;
    [[nodiscard]] bool is_single(const RoundFrame& frame) const;
    /// Is Geometry asked for?
    [[nodiscard]] bool needs_surfaces() const {
        return m_needs_depth || m_has_strata || !m_regions.empty();
    }
    [[nodiscard]] bool takes_part(const MethodCell& cell) const;

    RoundStage& m_stage;
    const RoundReuse& m_reuse;
    std::vector<MetricRow>& m_rows;
    RoundDone& m_done;
    RoundPictures m_pictures;
    std::unique_ptr<TruthSource> m_truth;
    SequenceTruth m_sequence;
    std::vector<ImageMetric> m_metrics;
    std::vector<CellSequence> m_cells; ///< one a cell of the stage
    ProfileStrip m_truth_profile;
    bool m_has_singles;
    bool m_needs_depth = false;
    bool m_has_strata = false;          ///< those of list_strata
    std::vector<std::string> m_regions; ///< objects that are strata of their own
};

} // namespace alcove
