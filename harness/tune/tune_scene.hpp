#pragma once
// A scene's single frames with their truth, on which any setting of a method can be judged.

#include "harness/run/round_stage.hpp"
#include "harness/run/truth.hpp"

#include <memory>
#include <string>
#include <vector>

namespace alcove {

/// What tuning measures with: the metric as it was named, and its instance.
struct TuneMetric {
    std::string text;
    const MetricUnit* unit = nullptr;
    MetricDomain domain = MetricDomain::values;
    std::unique_ptr<Metric> metric;
    /// Small is good, whatever the metric's direction.
    [[nodiscard]] double compute_cost(double value) const {
        return unit->direction == Direction::lower_is_better ? value : -value;
    }
};

class TuneScene {
  public:
    /// `experiment` has one scene, one method, one target and one size. Traces the truth of the
    /// default single frames. Throws as make_plan does; InputError for a walkthrough without
    /// singles. `context` and `units` must outlive it.
    TuneScene(gl::Context& context, const Units& units, const Experiment& experiment);

    [[nodiscard]] const std::string& name() const noexcept { return round().scene; }
    [[nodiscard]] std::size_t frame_count() const noexcept { return m_frames.size(); }
    [[nodiscard]] int frame_index(std::size_t i) const { return m_frames[i].view.index; }
    [[nodiscard]] double target_radius_m() const;
    /// The method of the experiment as its specification says: what is there before tuning.
    [[nodiscard]] CellRecord make_cell(const MethodSpec& spec) const;

    /// The image of a method on one frame, from a fresh start, converged if it has a history.
    /// Cells that come one after the other keep their living method.
    [[nodiscard]] Image render(const CellRecord& cell, std::size_t frame);
    /// Debiased where the metric gives that. Throws InputError where it has no value.
    [[nodiscard]] double measure(const TuneMetric& metric, const Image& image, std::size_t frame);

  private:
    [[nodiscard]] const RoundRecord& round() const { return m_plan.rounds.front(); }

    const Units& m_units;
    PlanRecord m_plan;
    std::unique_ptr<Scene> m_scene;
    std::unique_ptr<RoundStage> m_stage;
    std::vector<RoundFrame> m_frames;
    std::vector<Truth> m_truths;
    /// The last cell that was rendered, and its method, which refers to it.
    std::unique_ptr<CellRecord> m_record;
    std::unique_ptr<MethodCell> m_cell;
};

} // namespace alcove
