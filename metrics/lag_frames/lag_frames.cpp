#include "metrics/lag_frames/lag_frames.hpp"

#include "metrics/common/lag_fit.hpp"

namespace alcove {
namespace {

class LagFrames final : public TemporalMetric {
  public:
    explicit LagFrames(const LagParameters& parameters) : m_parameters(parameters) {}

    void reset() override {}

    std::optional<MetricResult> add(const TemporalFrame& frame) override {
        check_temporal_frame(frame, "lag_frames");
        const std::optional<LagFit> fit = fit_lag(frame, m_parameters);
        if (!fit) {
            return std::nullopt;
        }
        MetricResult result;
        result.undefined_reason = fit->undefined_reason;
        if (fit->plain) {
            result.value = count_frames(*fit->plain);
        }
        if (fit->debiased) {
            result.debiased = count_frames(*fit->debiased);
        }
        return result;
    }

  private:
    static double count_frames(const Lag& lag) { return lag.is_late ? lag.steps : 0; }

    LagParameters m_parameters;
};

} // namespace

MetricUnit lag_frames_unit() {
    MetricUnit unit;
    unit.name = "lag_frames";
    unit.title = "Lag of the test image behind truth";
    unit.unit = "frames";
    unit.definition =
        "The k in {1, 2, 4, 8} for which test_t = (1 - a) ref_t + a warp(ref_(t-k)) leaves the "
        "least residual, a by least squares for each k, over one set of pixels: surface, visible "
        "all along, and with |warp(ref_(t-k)) - ref_t| above `change` for any k. 0 where a is not "
        "above `least_share` and three of its standard errors, sqrt(residual / n / sum x^2). With "
        "halves of the reference: `change` is at least four standard deviations of the noise, and "
        "debiased is the same from cross products, sum x_A x_B for sum x^2 and so on; steps "
        "with sum x_A x_B under half of sum x^2 are left out. Nothing before frame 8; undefined "
        "with fewer than `least_pixels` pixels or without a step.";
    unit.blind_to = "how much of the old truth is mixed in (lag_share), lags between the steps, "
                    "and, where truth changes evenly in time, the difference between a small "
                    "share of an old truth and a large share of a newer one.";
    unit.maximum = kEarlierSteps.back();
    unit.best = 0.0;
    unit.parameters = describe_lag_parameters("lag_frames");
    unit.temporal_checks = {
        {"0.4 of truth 4 frames ago",
         [](TemporalMetric& metric) { return run_planted_lag(metric, 0.4, 4); }, 4.0, 0.0,
         "by hand"},
        {"0.7 of truth 1 frame ago",
         [](TemporalMetric& metric) { return run_planted_lag(metric, 0.7, 1); }, 1.0, 0.0,
         "by hand"},
        {"all of truth 8 frames ago",
         [](TemporalMetric& metric) { return run_planted_lag(metric, 1.0, 8); }, 8.0, 0.0,
         "by hand"},
        {"truth", [](TemporalMetric& metric) { return run_planted_lag(metric, 0.0, 1); }, 0.0, 0.0,
         "by definition"},
    };
    unit.create_temporal = [table = unit.parameters](const ResolvedParameters& resolved) {
        return std::make_unique<LagFrames>(table.bind<LagParameters>(resolved));
    };
    return unit;
}

} // namespace alcove
