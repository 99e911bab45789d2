#include "metrics/trail_energy/trail_energy.hpp"

#include "metrics/common/planted_sequence.hpp"
#include "metrics/common/truth_change.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alcove {
namespace {

struct TrailParameters {
    double change = 0.05;
};

ParameterTable describe_trail_parameters() {
    return describe_parameters(
        "trail_energy",
        {real(&TrailParameters::change, "change")
             .range(0.001, 1.0)
             .log_scale()
             .unit("value")
             .meaning("How much truth must have brightened for a pixel to count; raised to four "
                      "standard deviations of the reference's noise where that is more.")
             .source("ours")});
}

/// Adds to `rise` how much brighter truth is now than it was then, where that is more.
void raise(const TemporalFrame& frame, const EarlierFrame& earlier, Image& rise) {
    const float* valid = earlier.correspondence.valid.values().data();
    const float* then = earlier.reference.values().data();
    const float* now = frame.reference.values().data();
    float* out = rise.values().data();
    const std::size_t count = rise.values().size();
    for (std::size_t i = 0; i < count; ++i) {
        out[i] = valid[i] != 0.0f ? std::max(out[i], now[i] - then[i]) : out[i];
    }
}

class TrailEnergy final : public TemporalMetric {
  public:
    explicit TrailEnergy(const TrailParameters& parameters) : m_parameters(parameters) {}

    void reset() override {}

    std::optional<MetricResult> add(const TemporalFrame& frame) override {
        check_temporal_frame(frame, "trail_energy");
        if (frame.earlier.empty()) {
            return std::nullopt;
        }
        Image rise(frame.test.size(), 1);
        for (const EarlierFrame& earlier : frame.earlier) {
            raise(frame, earlier, rise);
        }
        return measure(frame, rise,
                       find_change_threshold(frame, frame.earlier, m_parameters.change));
    }

  private:
    static MetricResult measure(const TemporalFrame& frame, const Image& rise, float threshold) {
        MetricResult result;
        result.map = Image(frame.test.size(), 1);
        const bool halves = frame.reference_a != nullptr;
        const float* test = frame.test.values().data();
        const float* reference = frame.reference.values().data();
        const float* a = halves ? frame.reference_a->values().data() : reference;
        const float* b = halves ? frame.reference_b->values().data() : reference;
        const float* surface = frame.surface.values().data();
        const float* moves = frame.moves.values().data();
        double square = 0.0;
        double debiased = 0.0;
        double noise = 0.0;
        std::size_t pixels = 0;
        for (std::size_t i = 0; i < rise.values().size(); ++i) {
            if (rise.values()[i] <= threshold || surface[i] == 0.0f || moves[i] != 0.0f) {
                continue;
            }
            ++pixels;
            const auto error = static_cast<double>(test[i] - reference[i]);
            const auto half = 0.5 * static_cast<double>(a[i] - b[i]);
            square += error * error;
            debiased += static_cast<double>(test[i] - a[i]) * static_cast<double>(test[i] - b[i]);
            noise += half * half;
            result.map->values()[i] = static_cast<float>(std::abs(error));
        }
        if (pixels == 0) {
            result.undefined_reason = "truth brightens at no point that stands still";
            return result;
        }
        const auto count = static_cast<double>(pixels);
        result.value = std::sqrt(square / count);
        if (halves) {
            result.debiased = std::sqrt(std::max(0.0, debiased) / count);
            result.floor = std::sqrt(noise / count);
        }
        return result;
    }

    TrailParameters m_parameters;
};

constexpr ImageSize kCheckSize{48, 36};

/// A dark square, 12 x 12 pixels of truth 0.4 in 0.9, moves 3 pixels a frame to the right; the test
/// shows it where it was `late` frames ago.
double run_shadow(TemporalMetric& metric, int late) {
    constexpr int kFrames = 10;
    const auto make = [](int t) {
        Image image(kCheckSize, 1, 0.9f);
        for (int y = 12; y < 24; ++y) {
            for (int x = 3 * t; x < 3 * t + 12; ++x) {
                if (x >= 0 && x < kCheckSize.width) {
                    image.at(x, y) = 0.4f;
                }
            }
        }
        return image;
    };
    std::vector<PlantedFrame> frames(kFrames, make_planted_frame(kCheckSize, PlantedMotion::still));
    for (int t = 0; t < kFrames; ++t) {
        frames[static_cast<std::size_t>(t)].reference = make(t);
        frames[static_cast<std::size_t>(t)].test = make(t - late);
    }
    return get_last_planted_value(metric, frames);
}

} // namespace

MetricUnit trail_energy_unit() {
    MetricUnit unit;
    unit.name = "trail_energy";
    unit.title = "Error of trails where truth has brightened";
    unit.unit = "value";
    unit.definition =
        "sqrt(mean e^2), e = test - reference, over surface pixels of objects that have not moved "
        "since the last frame and where truth has brightened: ref_t - min warp(ref_(t-k)) above "
        "`change`, over the k in {1, 2, 4, 8} at which the point was visible. With halves A, B of "
        "the reference: `change` is at least four standard deviations of the noise, debiased = "
        "sqrt(max(0, mean e_A e_B)), floor = sqrt(mean ((A - B) / 2)^2). Nothing on a first frame; "
        "undefined where truth brightens nowhere.";
    unit.blind_to = "the sign (a trail is too dark; what overshoots to too bright counts alike), "
                    "errors that were there before truth brightened, trails older than 8 frames "
                    "or that fall between the steps, and bright trails where truth darkens.";
    unit.maximum = std::numeric_limits<double>::infinity();
    unit.best = 0.0;
    unit.parameters = describe_trail_parameters();
    unit.temporal_checks = {
        {"shadow 1 frame late", [](TemporalMetric& metric) { return run_shadow(metric, 1); },
         0.5 * std::sqrt(3.0 / 24.0), 1e-6,
         "by hand: columns 3 to 26 were dark 1, 2, 4 or 8 frames ago and are bright now; 3 of the "
         "24 show the late shadow"},
        {"shadow 2 frames late", [](TemporalMetric& metric) { return run_shadow(metric, 2); },
         0.5 * std::sqrt(6.0 / 24.0), 1e-6, "by hand: 6 of 24"},
        {"truth", [](TemporalMetric& metric) { return run_shadow(metric, 0); }, 0.0, 0.0,
         "by definition"},
    };
    unit.create_temporal = [table = unit.parameters](const ResolvedParameters& resolved) {
        return std::make_unique<TrailEnergy>(table.bind<TrailParameters>(resolved));
    };
    return unit;
}

} // namespace alcove
