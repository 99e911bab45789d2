#include "metrics/gradient_error/gradient_error.hpp"

#include "metrics/common/pooled_region.hpp"
#include "metrics/common/test_images.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alcove {
namespace {

/// One forward difference.
constexpr int kSmallestSide = 2;

struct Gradient {
    double x = 0.0;
    double y = 0.0;
};

Gradient operator-(Gradient a, Gradient b) {
    return {a.x - b.x, a.y - b.y};
}

double dot(Gradient a, Gradient b) {
    return a.x * b.x + a.y * b.y;
}

Gradient take_gradient(const Image& image, int x, int y) {
    const auto here = static_cast<double>(image.at(x, y));
    return {static_cast<double>(image.at(x + 1, y)) - here,
            static_cast<double>(image.at(x, y + 1)) - here};
}

struct GradientSums {
    double error = 0.0;    ///< |t - r|^2
    double debiased = 0.0; ///< (t - a) . (t - b)
    double noise = 0.0;    ///< |a - b|^2 / 4
    double kept = 0.0;     ///< t . r
    double detail = 0.0;   ///< r . r, or a . b with halves
};

GradientSums sum_gradients(const MetricInput& input, const PooledRegion& region, Image& map) {
    GradientSums sums;
    for (int y = 0; y < region.size().height; ++y) {
        for (int x = 0; x < region.size().width; ++x) {
            const Gradient t = take_gradient(input.test, x, y);
            const Gradient r = take_gradient(input.reference, x, y);
            const double square = dot(t - r, t - r);
            map.at(x, y) = static_cast<float>(std::sqrt(square));
            if (!region.is_counted(x, y)) {
                continue;
            }
            sums.error += square;
            sums.kept += dot(t, r);
            if (input.reference_a == nullptr) {
                sums.detail += dot(r, r);
                continue;
            }
            const Gradient a = take_gradient(*input.reference_a, x, y);
            const Gradient b = take_gradient(*input.reference_b, x, y);
            sums.debiased += dot(t - a, t - b);
            sums.noise += 0.25 * dot(a - b, a - b);
            sums.detail += dot(a, b);
        }
    }
    return sums;
}

class GradientError final : public Metric {
  public:
    MetricResult evaluate(const MetricInput& input) const override {
        check_metric_input(input, "gradient_error", kSmallestSide);
        ALCOVE_ASSERT(input.test.channels() == 1, "luma");
        const ImageSize size{input.test.width() - 1, input.test.height() - 1};
        const PooledRegion region(input.mask, size);
        MetricResult result;
        region.report(result);
        result.map = Image(input.test.size(), 1);
        const GradientSums sums = sum_gradients(input, region, *result.map);
        if (region.count() == 0) {
            return result;
        }
        const auto count = static_cast<double>(region.count());
        result.value = std::sqrt(sums.error / count);
        if (input.reference_a != nullptr) {
            result.debiased = std::sqrt(std::max(0.0, sums.debiased / count));
            result.floor = std::sqrt(sums.noise / count);
        }
        // A reference without detail has none to keep.
        if (sums.detail > 0.0) {
            result.extras = {{"kept_detail", sums.kept / sums.detail}};
        }
        return result;
    }
};

} // namespace

MetricUnit gradient_error_unit() {
    MetricUnit unit;
    unit.name = "gradient_error";
    unit.title = "Gradient error";
    unit.unit = "value/px";
    unit.definition =
        "Ours. g = forward differences (right, down) over the (W - 1)(H - 1) pixels that have "
        "both; sqrt(mean |g_t - g_r|^2). kept_detail = sum g_t . g_r / sum g_r . g_r, the slope "
        "of the test's gradients on the reference's: 1 keeps all detail, 0 none. With two halves "
        "A, B of the reference: debiased = sqrt(max(0, mean (g_t - g_A) . (g_t - g_B))), floor = "
        "sqrt(mean |g_A - g_B|^2) / 2, and g_A . g_B below kept_detail.";
    unit.blind_to = "a constant bias and all that varies slowly; and whether detail was lost or "
                    "noise was added, which kept_detail tells apart.";
    unit.luma = true;
    unit.on_demand = true;
    unit.smallest_side = kSmallestSide;
    unit.maximum = std::numeric_limits<double>::infinity();
    unit.best = 0.0;
    unit.parameters = describe_parameters("gradient_error", {});
    unit.checks = {
        {"constant, step of 1", [] { return make_constant(0); }, [] { return make_step(32); },
         std::sqrt(1.0 / 63.0), 1e-12, "by hand: 63 of 63 x 63 pixels have a difference of 1"},
        {"constants 0 and 255", [] { return make_constant(0); }, [] { return make_constant(255); },
         0.0, 1e-12, "by hand: neither has a gradient"},
        {"checkerboard, constant", make_checkerboard, [] { return make_constant(128); },
         std::sqrt(2.0), 1e-12, "by hand: differences of 1 to the right and down everywhere"},
    };
    unit.create = [](const ResolvedParameters&) { return std::make_unique<GradientError>(); };
    return unit;
}

} // namespace alcove
