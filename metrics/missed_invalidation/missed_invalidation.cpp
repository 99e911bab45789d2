#include "metrics/missed_invalidation/missed_invalidation.hpp"

#include "metrics/common/invalidation.hpp"

#include <algorithm>
#include <memory>

namespace alcove {
namespace {

struct MissedParameters {
    double change = 0.02;
    int least_pixels = 64;
};

ParameterTable describe_missed_parameters() {
    return describe_parameters(
        "missed_invalidation",
        {real(&MissedParameters::change, "change")
             .range(0.0001, 1.0)
             .log_scale()
             .unit("value")
             .meaning(
                 "How much truth must have changed at a point that was visible; with halves of the "
                 "reference more than 4 times its noise, and each half by half as much, the same "
                 "way.")
             .source("ours"),
         integer(&MissedParameters::least_pixels, "least_pixels")
             .range(1, 1e6)
             .log_scale()
             .unit("px")
             .meaning("With fewer changed pixels the value is undefined: a few are the "
                      "reference's noise.")
             .source("ours")});
}

class MissedInvalidation final : public TemporalMetric {
  public:
    explicit MissedInvalidation(const MissedParameters& parameters) : m_parameters(parameters) {}

    void reset() override {}

    std::optional<MetricResult> add(const TemporalFrame& frame) override {
        TruthThresholds thresholds;
        thresholds.changed = m_parameters.change;
        thresholds.least_pixels = m_parameters.least_pixels;
        thresholds.unchanged = std::min(thresholds.unchanged, thresholds.changed);
        return measure_history_share(frame, "missed_invalidation", thresholds, Truth::changed,
                                     true);
    }

  private:
    MissedParameters m_parameters;
};

} // namespace

MetricUnit missed_invalidation_unit() {
    MetricUnit unit;
    unit.name = "missed_invalidation";
    unit.title = "Stale history that was kept";
    unit.unit = "1";
    unit.definition =
        "Share of the surface pixels where truth has changed whose history was kept (cause "
        "`kept`). "
        "Changed: not visible one frame ago, or ref_t farther than `change` from the range of the "
        "3 x 3 pixels of warp(ref_(t-1)) around it and, with "
        "halves of the reference, above 4 times the noise of the difference and both halves of one "
        "sign and above half of it. Pixels without history (cause `no_history`) are left out. No "
        "result on a first frame and for methods "
        "without a history state; undefined where truth changes at fewer than `least_pixels` "
        "pixels. History that is kept in "
        "part counts as lost, as its cause says.";
    unit.blind_to =
        "whether the kept history did harm, changes of truth that are older than one frame, and "
        "history that is lost for no reason (false_invalidation).";
    unit.maximum = 1.0;
    unit.best = 0.0;
    unit.parameters = describe_missed_parameters();
    unit.temporal_checks = {{"rows kept, lost and without history", run_planted_invalidation,
                             3.0 / 8.0, 1e-12, "by hand: 3 of 8 rows with a history"}};
    unit.create_temporal = [table = unit.parameters](const ResolvedParameters& resolved) {
        return std::make_unique<MissedInvalidation>(table.bind<MissedParameters>(resolved));
    };
    return unit;
}

} // namespace alcove
