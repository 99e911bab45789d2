#include "metrics/flicker_ratio/flicker_ratio.hpp"

#include "metrics/common/error_step.hpp"
#include "metrics/common/planted_sequence.hpp"

#include <algorithm>
#include <cmath>

namespace alcove {
namespace {

class FlickerRatio final : public TemporalMetric {
  public:
    void reset() override { m_steps.reset(); }

    std::optional<MetricResult> add(const TemporalFrame& frame) override {
        check_temporal_frame(frame, "flicker_ratio");
        const std::optional<ErrorStep> step = m_steps.add(frame);
        if (!step) {
            return std::nullopt;
        }
        MetricResult result;
        const double square = step->plain.now + step->plain.earlier;
        if (step->pixels == 0) {
            result.undefined_reason = "no surface point was visible one frame ago";
        } else if (square == 0.0) {
            result.undefined_reason = "there is no error that could change";
        } else if (step->noise && step->debiased->now <= step->noise->now &&
                   step->debiased->earlier <= step->noise->earlier) {
            result.undefined_reason = "the error is under the reference's floor in both frames";
        } else {
            result.value = std::sqrt(step->plain.change / square);
            // One of the two terms is above its noise; the other may be negative by chance.
            const double debiased =
                step->debiased ? step->debiased->now + step->debiased->earlier : 0.0;
            if (debiased > 0.0) {
                result.debiased = std::sqrt(std::max(0.0, step->debiased->change) / debiased);
            }
        }
        return result;
    }

  private:
    ErrorSteps m_steps;
};

/// 27648 pixels: the ratio of one frame scatters by 1 / sqrt(27648) = 0.006 for white errors.
constexpr ImageSize kCheckSize{192, 144};

double run_white(TemporalMetric& metric, PlantedMotion motion) {
    return get_last_planted_value(metric, plant_errors(kCheckSize, motion, 3, 0.1, [](int t) {
                                      return make_planted_noise(kCheckSize,
                                                                static_cast<std::uint32_t>(t));
                                  }));
}

double run_static(TemporalMetric& metric) {
    return get_last_planted_value(
        metric, plant_errors(kCheckSize, PlantedMotion::still, 3, 0.1,
                             [](int) { return make_planted_noise(kCheckSize, 1); }));
}

double run_alternating(TemporalMetric& metric) {
    return get_last_planted_value(
        metric, plant_errors(kCheckSize, PlantedMotion::still, 3, 0.1, [](int t) {
            Image error(kCheckSize, 1);
            add_scaled(error, make_planted_noise(kCheckSize, 1), t % 2 == 0 ? 1.0 : -1.0);
            return error;
        }));
}

double run_drift(TemporalMetric& metric) {
    constexpr double kKept = 0.95;
    Image error = make_planted_noise(kCheckSize, 0);
    return get_last_planted_value(
        metric, plant_errors(kCheckSize, PlantedMotion::still, 12, 0.1, [&error](int t) {
            Image next(kCheckSize, 1);
            add_scaled(next, error, kKept);
            add_scaled(next, make_planted_noise(kCheckSize, static_cast<std::uint32_t>(t + 1)),
                       std::sqrt(1.0 - kKept * kKept));
            error = next;
            return error;
        }));
}

} // namespace

MetricUnit flicker_ratio_unit() {
    MetricUnit unit;
    unit.name = "flicker_ratio";
    unit.title = "Flicker ratio (share of the error that changes)";
    unit.unit = "1";
    unit.definition =
        "temporal_flicker / sqrt(mean e_t^2 + mean warp(e_(t-1))^2), all over surface pixels "
        "visible one frame ago: 0 sticks to the surface, 1 is white in time, sqrt 2 changes sign "
        "every frame. The denominator warps too, because a bilinear fetch lowers variance. With "
        "halves A, B of the reference: debiased = the same of the cross products of e_A and e_B. "
        "Undefined where there is no error, and where in both frames mean e_A e_B is not above "
        "the reference's own mean ((A - B) / 2)^2.";
    unit.blind_to = "how large the error is: read it beside temporal_flicker.";
    unit.maximum = std::sqrt(2.0);
    unit.parameters = describe_parameters("flicker_ratio", {});
    const auto white = [](PlantedMotion motion) {
        return [motion](TemporalMetric& metric) { return run_white(metric, motion); };
    };
    unit.temporal_checks = {
        {"static error, still camera", run_static, 0.0, 1e-6, "by definition"},
        {"white error, still camera", white(PlantedMotion::still), 1.0, 0.03, "theory"},
        {"white error, pan of a pixel", white(PlantedMotion::pan_one_pixel), 1.0, 0.03, "theory"},
        {"white error, pan of half a pixel", white(PlantedMotion::pan_half_pixel), 1.0, 0.03,
         "theory; dividing by sqrt 2 RMSE would give 0.87"},
        {"white error, rotating disc", white(PlantedMotion::rotating_disc), 1.0, 0.03, "theory"},
        {"error changing sign", run_alternating, std::sqrt(2.0), 1e-6, "by hand"},
        {"drift, AR(0.95)", run_drift, std::sqrt(1.0 - 0.95), 0.02,
         "theory: sqrt(1 - correlation of neighbouring frames)"},
    };
    unit.create_temporal = [](const ResolvedParameters&) {
        return std::make_unique<FlickerRatio>();
    };
    return unit;
}

} // namespace alcove
