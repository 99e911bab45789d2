#include "metrics/temporal_flicker/temporal_flicker.hpp"

#include "metrics/common/error_step.hpp"
#include "metrics/common/planted_sequence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alcove {
namespace {

class TemporalFlicker final : public TemporalMetric {
  public:
    void reset() override { m_steps.reset(); }

    std::optional<MetricResult> add(const TemporalFrame& frame) override {
        check_temporal_frame(frame, "temporal_flicker");
        std::optional<ErrorStep> step = m_steps.add(frame);
        if (!step) {
            return std::nullopt;
        }
        MetricResult result;
        result.map = std::move(step->change_map);
        if (step->pixels == 0) {
            result.undefined_reason = "no surface point was visible one frame ago";
            return result;
        }
        result.value = std::sqrt(step->plain.change);
        if (step->debiased) {
            // Its expectation is the true square; by chance it may fall below 0, which reads as 0.
            result.debiased = std::sqrt(std::max(0.0, step->debiased->change));
            result.floor = std::sqrt(step->noise->change);
        }
        return result;
    }

  private:
    ErrorSteps m_steps;
};

constexpr ImageSize kCheckSize{96, 72};

/// Grows by 0.001 a pixel along the surface, which a bilinear fetch gives back exactly.
Image make_ramp_on_surface(PlantedMotion motion, int frame) {
    Image image(kCheckSize, 1);
    for (int y = 0; y < kCheckSize.height; ++y) {
        for (int x = 0; x < kCheckSize.width; ++x) {
            const PlantedPoint point = find_planted_point(kCheckSize, motion, frame, x, y);
            image.at(x, y) = static_cast<float>(0.001 * (point.x + point.y));
        }
    }
    return image;
}

double run_static(TemporalMetric& metric, PlantedMotion motion) {
    return get_last_planted_value(metric, plant_errors(kCheckSize, motion, 4, 1.0, [=](int t) {
                                      return make_ramp_on_surface(motion, t);
                                  }));
}

double run_alternating(TemporalMetric& metric) {
    return get_last_planted_value(metric,
                                  plant_errors(kCheckSize, PlantedMotion::still, 3, 0.1, [](int t) {
                                      return Image(kCheckSize, 1, t % 2 == 0 ? 1.0f : -1.0f);
                                  }));
}

double run_white(TemporalMetric& metric) {
    return get_last_planted_value(
        metric, plant_errors(kCheckSize, PlantedMotion::still, 3, 0.1, [](int t) {
            return make_planted_noise(kCheckSize, static_cast<std::uint32_t>(t));
        }));
}

} // namespace

MetricUnit temporal_flicker_unit() {
    MetricUnit unit;
    unit.name = "temporal_flicker";
    unit.title = "Temporal flicker (change of the error)";
    unit.unit = "value";
    unit.definition =
        "sqrt(mean D^2) over surface pixels visible one frame ago, D = e_t - warp(e_(t-1)), e = "
        "test - reference, warp = bilinear along the surfaces' own motion: change of the test "
        "minus change of truth, so that a bias that sticks to surfaces and a change that truth "
        "makes too count nothing. With halves A, B of the reference: debiased = sqrt(max(0, mean "
        "D_A D_B)), floor = sqrt(mean ((D_A - D_B) / 2)^2). Nothing on a first frame.";
    unit.blind_to = "any error that moves with its surface, pixels that come into view, how "
                    "fast changes follow each other, and whether anybody sees them.";
    unit.maximum = std::numeric_limits<double>::infinity();
    unit.best = 0.0;
    unit.parameters = describe_parameters("temporal_flicker", {});
    unit.temporal_checks = {
        {"static error, still camera",
         [](TemporalMetric& metric) { return run_static(metric, PlantedMotion::still); }, 0.0, 1e-6,
         "by definition"},
        {"static error, pan of half a pixel",
         [](TemporalMetric& metric) { return run_static(metric, PlantedMotion::pan_half_pixel); },
         0.0, 1e-6, "by definition: bilinear is exact on a ramp"},
        {"static error, rotating disc",
         [](TemporalMetric& metric) { return run_static(metric, PlantedMotion::rotating_disc); },
         0.0, 1e-6, "by definition: bilinear is exact on a ramp"},
        {"error of 0.1 changing sign", run_alternating, 0.2, 1e-6, "by hand: 0.1 - (-0.1)"},
        {"white error of 0.1", run_white, 0.1 * std::sqrt(2.0), 0.004,
         "theory: variances add; 4 standard errors of 6912 pixels"},
    };
    unit.create_temporal = [](const ResolvedParameters&) {
        return std::make_unique<TemporalFlicker>();
    };
    return unit;
}

} // namespace alcove
