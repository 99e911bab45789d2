#include "metrics/common/lag_fit.hpp"

#include "metrics/common/planted_sequence.hpp"
#include "metrics/common/truth_change.hpp"

#include <algorithm>
#include <cmath>

namespace alcove {
namespace {

/// Sums over the common pixels for one step, with x = warp(ref_(t-k)) - ref_t and
/// y = test_t - ref_t.
struct Sums {
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
};

struct StepSums {
    Sums plain;
    Sums debiased; ///< 0 without halves
};

struct Pixels {
    const float* test;
    const float* reference;
    const float* a; ///< null without halves
    const float* b;
};

/// Pixels that are surface, valid at every step, and where truth changed over any of them: one set
/// for all steps, because residuals over different sets cannot be compared.
std::vector<std::size_t> choose_pixels(const TemporalFrame& frame, float threshold) {
    const std::size_t count = frame.test.values().size();
    const float* surface = frame.surface.values().data();
    const float* reference = frame.reference.values().data();
    std::array<const float*, kEarlierSteps.size()> valid{};
    std::array<const float*, kEarlierSteps.size()> then{};
    for (std::size_t k = 0; k < kEarlierSteps.size(); ++k) {
        valid.at(k) = frame.earlier[k].correspondence.valid.values().data();
        then.at(k) = frame.earlier[k].reference.values().data();
    }
    std::vector<std::size_t> pixels;
    pixels.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        bool all_valid = surface[i] != 0.0f;
        bool any_changed = false;
        for (std::size_t k = 0; k < kEarlierSteps.size(); ++k) {
            all_valid = all_valid && valid[k][i] != 0.0f;
            any_changed = any_changed || std::abs(then[k][i] - reference[i]) > threshold;
        }
        if (all_valid && any_changed) {
            pixels.push_back(i);
        }
    }
    return pixels;
}

StepSums sum_step(const Pixels& now, const EarlierFrame& earlier,
                  const std::vector<std::size_t>& chosen) {
    const bool halves = now.a != nullptr && earlier.reference_a.has_value();
    const float* then = earlier.reference.values().data();
    const float* then_a = halves ? earlier.reference_a->values().data() : nullptr;
    const float* then_b = halves ? earlier.reference_b->values().data() : nullptr;
    StepSums sums;
    for (const std::size_t i : chosen) {
        const auto x = static_cast<double>(then[i] - now.reference[i]);
        const auto y = static_cast<double>(now.test[i] - now.reference[i]);
        sums.plain.xx += x * x;
        sums.plain.xy += x * y;
        sums.plain.yy += y * y;
        if (halves) {
            const auto x_a = static_cast<double>(then_a[i] - now.a[i]);
            const auto x_b = static_cast<double>(then_b[i] - now.b[i]);
            const auto y_a = static_cast<double>(now.test[i] - now.a[i]);
            const auto y_b = static_cast<double>(now.test[i] - now.b[i]);
            sums.debiased.xx += x_a * x_b;
            sums.debiased.xy += 0.5 * (x_a * y_b + x_b * y_a);
            sums.debiased.yy += y_a * y_b;
        }
    }
    return sums;
}

/// A step's change of truth must be at least as large as the noise in it, or the share means
/// nothing: debiased xx over plain xx.
constexpr double kLeastReliability = 0.5;

/// The step of the least residual, yy - xy^2 / xx: yy is that of the common pixels, so the same for
/// all. Of equal ones the shortest. Nothing where no step has a change above noise.
std::optional<Lag> choose_step(const std::array<StepSums, kEarlierSteps.size()>& steps,
                               Sums StepSums::*which, bool halves, std::size_t pixels,
                               const LagParameters& parameters) {
    std::optional<Lag> best;
    double explained = 0.0;
    for (std::size_t k = 0; k < steps.size(); ++k) {
        const Sums& sums = steps.at(k).*which;
        const bool is_noise =
            halves && steps.at(k).debiased.xx < kLeastReliability * steps.at(k).plain.xx;
        if (sums.xx <= 0.0 || is_noise) {
            continue;
        }
        if (const double own = sums.xy * sums.xy / sums.xx; !best || own > explained) {
            explained = own;
            Lag lag{kEarlierSteps.at(k), sums.xy / sums.xx, false};
            // The residual with the reference's noise in it: that scatters the share too.
            const Sums& plain = steps.at(k).plain;
            const double residual =
                plain.yy - 2.0 * lag.share * plain.xy + lag.share * lag.share * plain.xx;
            const double error =
                std::sqrt(std::max(0.0, residual) / static_cast<double>(pixels) / sums.xx);
            lag.is_late = lag.share > std::max(parameters.least_share, 3.0 * error);
            best = lag;
        }
    }
    return best;
}

} // namespace

ParameterTable describe_lag_parameters(const std::string& metric) {
    return describe_parameters(
        metric,
        {real(&LagParameters::change, "change")
             .range(0.001, 1.0)
             .log_scale()
             .unit("value")
             .meaning("Least change of truth over any of the steps for a pixel to count; raised to "
                      "four standard deviations of the reference's noise where that is more.")
             .source("ours"),
         integer(&LagParameters::least_pixels, "least_pixels")
             .range(2, 1000000)
             .log_scale()
             .unit("px")
             .meaning("With fewer pixels the value is undefined.")
             .source("ours"),
         real(&LagParameters::least_share, "least_share")
             .range(0.0, 1.0)
             .unit("1")
             .meaning("A share that is not above it, or not above three of its standard errors, "
                      "is no lag: 0 frames.")
             .source("ours")});
}

std::optional<LagFit> fit_lag(const TemporalFrame& frame, const LagParameters& parameters) {
    if (frame.earlier.size() < kEarlierSteps.size()) {
        return std::nullopt;
    }
    const float threshold = find_change_threshold(frame, frame.earlier, parameters.change);
    const std::vector<std::size_t> chosen = choose_pixels(frame, threshold);
    LagFit fit;
    if (chosen.size() < static_cast<std::size_t>(parameters.least_pixels)) {
        fit.undefined_reason = "truth changes in " + std::to_string(chosen.size()) +
                               " pixels that were visible all along; " +
                               std::to_string(parameters.least_pixels) + " are needed";
        return fit;
    }
    const bool halves = frame.reference_a != nullptr;
    const Pixels now{frame.test.values().data(), frame.reference.values().data(),
                     halves ? frame.reference_a->values().data() : nullptr,
                     halves ? frame.reference_b->values().data() : nullptr};
    std::array<StepSums, kEarlierSteps.size()> steps{};
    for (std::size_t k = 0; k < steps.size(); ++k) {
        ALCOVE_ASSERT(frame.earlier[k].steps == kEarlierSteps.at(k), "ascending steps");
        steps.at(k) = sum_step(now, frame.earlier[k], chosen);
    }
    fit.plain = choose_step(steps, &StepSums::plain, halves, chosen.size(), parameters);
    fit.debiased = choose_step(steps, &StepSums::debiased, halves, chosen.size(), parameters);
    if (!fit.plain) {
        fit.undefined_reason = "truth changes by less than the reference's noise at every step";
    }
    return fit;
}

double run_planted_lag(TemporalMetric& metric, double share, int steps) {
    constexpr ImageSize kSize{48, 36};
    constexpr int kFrames = 16;
    std::vector<PlantedFrame> frames(kFrames, make_planted_frame(kSize, PlantedMotion::still));
    for (int t = 0; t < kFrames; ++t) {
        // Each pixel swings with a phase and a speed of its own: no step looks like another.
        for (int y = 0; y < kSize.height; ++y) {
            for (int x = 0; x < kSize.width; ++x) {
                frames[static_cast<std::size_t>(t)].reference.at(x, y) =
                    static_cast<float>(0.5 + 0.3 * std::sin(0.4 * x + (0.2 + 0.02 * y) * t));
            }
        }
    }
    PlantedFrame& last = frames.back();
    last.test = Image(kSize, 1);
    add_scaled(last.test, last.reference, 1.0 - share);
    add_scaled(last.test, frames[static_cast<std::size_t>(kFrames - 1 - steps)].reference, share);
    return get_last_planted_value(metric, frames);
}

} // namespace alcove
