// This work is based on: Lai, Huang, Wang, Shechtman, Yumer, Yang. Learning Blind Video Temporal
// Consistency. 2018, equation (8).
#include "metrics/warping_error/warping_error.hpp"

#include "core/contract/temporal_metric.hpp"
#include "metrics/common/planted_sequence.hpp"

#include <cmath>
#include <limits>

namespace alcove {
namespace {

class WarpingError final : public TemporalMetric {
  public:
    void reset() override { m_previous.reset(); }

    std::optional<MetricResult> add(const TemporalFrame& frame) override {
        check_temporal_frame(frame, "warping_error");
        std::optional<MetricResult> result;
        if (!frame.earlier.empty()) {
            ALCOVE_ASSERT(m_previous.has_value() && frame.earlier.front().steps == 1,
                          "the frame before was added too");
            result = compare(frame, frame.earlier.front());
        }
        m_previous = frame.test;
        return result;
    }

  private:
    [[nodiscard]] MetricResult compare(const TemporalFrame& frame,
                                       const EarlierFrame& earlier) const {
        const Image warped = warp_image(*m_previous, earlier.correspondence);
        MetricResult result;
        result.map = Image(frame.test.size(), 1);
        std::size_t pixels = 0;
        double sum = 0.0;
        double truth = 0.0;
        for (std::size_t i = 0; i < warped.values().size(); ++i) {
            if (earlier.correspondence.valid.values()[i] == 0.0f ||
                frame.surface.values()[i] == 0.0f) {
                continue;
            }
            ++pixels;
            const auto change = static_cast<double>(frame.test.values()[i]) -
                                static_cast<double>(warped.values()[i]);
            const auto of_truth = static_cast<double>(frame.reference.values()[i]) -
                                  static_cast<double>(earlier.reference.values()[i]);
            sum += change * change;
            truth += of_truth * of_truth;
            result.map->values()[i] = static_cast<float>(std::abs(change));
        }
        if (pixels == 0) {
            result.undefined_reason = "no surface point was visible one frame ago";
            return result;
        }
        result.value = sum / static_cast<double>(pixels);
        result.extras = {{"of_truth", truth / static_cast<double>(pixels)}};
        return result;
    }

    std::optional<Image> m_previous;
};

constexpr ImageSize kCheckSize{96, 72};

double run_black(TemporalMetric& metric) {
    std::vector<PlantedFrame> frames(3, make_planted_frame(kCheckSize, PlantedMotion::still));
    for (std::size_t t = 0; t < frames.size(); ++t) {
        frames[t].test = Image(kCheckSize, 1);
        frames[t].reference = make_planted_noise(kCheckSize, static_cast<std::uint32_t>(t));
    }
    return get_last_planted_value(metric, frames);
}

double run_alternating(TemporalMetric& metric) {
    return get_last_planted_value(metric,
                                  plant_errors(kCheckSize, PlantedMotion::still, 3, 0.1, [](int t) {
                                      return Image(kCheckSize, 1, t % 2 == 0 ? 1.0f : -1.0f);
                                  }));
}

} // namespace

MetricUnit warping_error_unit() {
    MetricUnit unit;
    unit.name = "warping_error";
    unit.title = "Warping error (the test's own change)";
    unit.unit = "value^2";
    unit.definition =
        "Lai et al. 2018: mean (t_t - warp(t_(t-1)))^2 over surface pixels visible one frame ago, "
        "on linear visibility. Warped along the surfaces' own motion, exact, where the paper has "
        "to estimate flow and occlusion. of_truth: the same of truth, which is not 0 where "
        "occlusion changes. Nothing on a first frame.";
    unit.blind_to = "truth: a test that is black throughout scores 0, one that follows a moving "
                    "shadow does not. Read temporal_flicker, which takes truth's change out.";
    unit.on_demand = true;
    unit.ignores_reference = true;
    unit.maximum = std::numeric_limits<double>::infinity();
    unit.parameters = describe_parameters("warping_error", {});
    unit.temporal_checks = {
        {"black throughout, truth changes", run_black, 0.0, 0.0, "by definition: it is blind"},
        {"error of 0.1 changing sign", run_alternating, 0.04, 1e-7, "by hand: (0.1 - (-0.1))^2"},
    };
    unit.create_temporal = [](const ResolvedParameters&) {
        return std::make_unique<WarpingError>();
    };
    return unit;
}

} // namespace alcove
