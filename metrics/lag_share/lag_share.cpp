#include "metrics/lag_share/lag_share.hpp"

#include "metrics/common/lag_fit.hpp"

#include <limits>

namespace alcove {
namespace {

class LagShare final : public TemporalMetric {
  public:
    explicit LagShare(const LagParameters& parameters) : m_parameters(parameters) {}

    void reset() override {}

    std::optional<MetricResult> add(const TemporalFrame& frame) override {
        check_temporal_frame(frame, "lag_share");
        const std::optional<LagFit> fit = fit_lag(frame, m_parameters);
        if (!fit) {
            return std::nullopt;
        }
        MetricResult result;
        result.undefined_reason = fit->undefined_reason;
        if (fit->plain) {
            result.value = fit->plain->share;
        }
        if (fit->debiased) {
            result.debiased = fit->debiased->share;
        }
        return result;
    }

  private:
    LagParameters m_parameters;
};

} // namespace

MetricUnit lag_share_unit() {
    MetricUnit unit;
    unit.name = "lag_share";
    unit.title = "Share of an older truth in the test image";
    unit.unit = "1";
    unit.definition =
        "The a of test_t = (1 - a) ref_t + a warp(ref_(t-k)) by least squares at the k in {1, 2, "
        "4, 8} that leaves the least residual (see lag_frames, which gives k and is found with "
        "the same pixels); not clamped: below 0 the test runs ahead of truth. With halves of the "
        "reference: debiased = sum (x_A y_B + x_B y_A) / 2 / sum x_A x_B with x = warp(ref_(t-k)) "
        "- ref_t, y = test_t - ref_t: noise in x alone would make the share smaller, noise that x "
        "and y have in common larger. Nothing before frame 8; undefined with fewer than "
        "`least_pixels` pixels.";
    unit.blind_to = "errors that are no older truth, and how old it is (lag_frames).";
    unit.minimum = -std::numeric_limits<double>::infinity();
    unit.maximum = std::numeric_limits<double>::infinity();
    unit.best = 0.0;
    unit.parameters = describe_lag_parameters("lag_share");
    unit.temporal_checks = {
        {"0.4 of truth 4 frames ago",
         [](TemporalMetric& metric) { return run_planted_lag(metric, 0.4, 4); }, 0.4, 1e-5,
         "by hand"},
        {"0.7 of truth 1 frame ago",
         [](TemporalMetric& metric) { return run_planted_lag(metric, 0.7, 1); }, 0.7, 1e-5,
         "by hand"},
        {"0.2 ahead of truth 2 frames ago",
         [](TemporalMetric& metric) { return run_planted_lag(metric, -0.2, 2); }, -0.2, 1e-5,
         "by hand"},
        {"truth", [](TemporalMetric& metric) { return run_planted_lag(metric, 0.0, 1); }, 0.0, 1e-6,
         "by definition"},
    };
    unit.create_temporal = [table = unit.parameters](const ResolvedParameters& resolved) {
        return std::make_unique<LagShare>(table.bind<LagParameters>(resolved));
    };
    return unit;
}

} // namespace alcove
