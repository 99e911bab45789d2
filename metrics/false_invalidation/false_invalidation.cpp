#include "metrics/false_invalidation/false_invalidation.hpp"

#include "metrics/common/invalidation.hpp"

#include <algorithm>
#include <memory>

namespace alcove {
namespace {

struct FalseParameters {
    double change = 0.01;
};

ParameterTable describe_false_parameters() {
    return describe_parameters(
        "false_invalidation",
        {real(&FalseParameters::change, "change")
             .range(0.0001, 1.0)
             .log_scale()
             .unit("value")
             .meaning("How much truth may have changed for the history to be still good.")
             .source("ours")});
}

class FalseInvalidation final : public TemporalMetric {
  public:
    explicit FalseInvalidation(const FalseParameters& parameters) : m_parameters(parameters) {}

    void reset() override {}

    std::optional<MetricResult> add(const TemporalFrame& frame) override {
        TruthThresholds thresholds;
        thresholds.unchanged = m_parameters.change;
        thresholds.changed = std::max(thresholds.changed, thresholds.unchanged);
        return measure_history_share(frame, "false_invalidation", thresholds, Truth::unchanged,
                                     false);
    }

  private:
    FalseParameters m_parameters;
};

} // namespace

MetricUnit false_invalidation_unit() {
    MetricUnit unit;
    unit.name = "false_invalidation";
    unit.title = "Good history that was lost";
    unit.unit = "1";
    unit.definition =
        "Share of the surface pixels where truth has not changed whose history was not kept (a "
        "cause other than `kept`). Not changed: visible one frame ago and |ref_t - "
        "warp(ref_(t-1))| "
        "under `change`. Pixels without history (cause `no_history`) are left out. No result on a "
        "first frame and for methods without a history state; undefined where truth changes "
        "everywhere. The reference's noise makes the set smaller, not the share.";
    unit.blind_to =
        "what the lost history would have been worth, how much of it was lost, and stale history "
        "that is kept (missed_invalidation).";
    unit.maximum = 1.0;
    unit.best = 0.0;
    unit.parameters = describe_false_parameters();
    unit.temporal_checks = {{"rows kept, lost and without history", run_planted_invalidation,
                             5.0 / 8.0, 1e-12, "by hand: 5 of 8 rows with a history"}};
    unit.create_temporal = [table = unit.parameters](const ResolvedParameters& resolved) {
        return std::make_unique<FalseInvalidation>(table.bind<FalseParameters>(resolved));
    };
    return unit;
}

} // namespace alcove
