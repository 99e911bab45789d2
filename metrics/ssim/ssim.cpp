// This work is based on: Wang, Bovik, Sheikh, Simoncelli. Image quality assessment: from error
// visibility to structural similarity. 2004.
#include "metrics/ssim/ssim.hpp"

#include "metrics/common/test_images.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace alcove {
namespace {

constexpr int kRadius = 5;          // 11 taps
constexpr double kC1 = 0.01 * 0.01; // (K1 L)^2 with L = 1
constexpr double kC2 = 0.03 * 0.03; // (K2 L)^2

/// Half of the symmetric window: weight of the centre, then of both taps at distance 1..5.
/// Normalised in double: a kernel rounded to six digits biases the variances by 4e-6 mu^2.
std::array<double, kRadius + 1> make_window() {
    constexpr double kSigma = 1.5;
    std::array<double, kRadius + 1> window{};
    double sum = 0.0;
    for (int i = 0; i <= kRadius; ++i) {
        window[static_cast<std::size_t>(i)] = std::exp(-0.5 * i * i / (kSigma * kSigma));
        sum += (i == 0 ? 1.0 : 2.0) * window[static_cast<std::size_t>(i)];
    }
    for (double& weight : window) {
        weight /= sum;
    }
    return window;
}

constexpr std::size_t kTaps = 2 * kRadius + 1;
using Window = std::array<double, kRadius + 1>;

/// What is averaged over the window: x, y, x^2 + y^2 and x y. The two variances are needed in their
/// sum alone.
constexpr std::size_t kMoments = 4;
using Moments = std::array<std::vector<double>, kMoments>;

/// The window's sum over 11 rows of numbers: of neighbouring columns or of neighbouring rows. `out`
/// overlaps none of them.
void sum_taps(const std::array<const double*, kTaps>& taps, const Window& window, std::size_t count,
              double* __restrict out) {
    const auto [a5, a4, a3, a2, a1, c, b1, b2, b3, b4, b5] = taps;
    const auto [w0, w1, w2, w3, w4, w5] = window;
    for (std::size_t i = 0; i < count; ++i) {
        out[i] = w0 * c[i] + w1 * (a1[i] + b1[i]) + w2 * (a2[i] + b2[i]) + w3 * (a3[i] + b3[i]) +
                 w4 * (a4[i] + b4[i]) + w5 * (a5[i] + b5[i]);
    }
}

/// The moments of one input row, summed over 11 neighbouring columns.
void sum_columns(const MetricInput& input, int row, const Window& window, Moments& products,
                 Moments& out) {
    const auto width = static_cast<std::size_t>(input.test.width());
    const float* test = input.test.values().data() + static_cast<std::size_t>(row) * width;
    const float* reference =
        input.reference.values().data() + static_cast<std::size_t>(row) * width;
    double* __restrict xs = products[0].data();
    double* __restrict ys = products[1].data();
    double* __restrict squares = products[2].data();
    double* __restrict crosses = products[3].data();
    for (std::size_t i = 0; i < width; ++i) {
        const double x = static_cast<double>(test[i]);
        const double y = static_cast<double>(reference[i]);
        xs[i] = x;
        ys[i] = y;
        squares[i] = x * x + y * y;
        crosses[i] = x * y;
    }
    for (std::size_t m = 0; m < kMoments; ++m) {
        std::array<const double*, kTaps> taps{};
        for (std::size_t k = 0; k < kTaps; ++k) {
            taps.at(k) = products.at(m).data() + k;
        }
        sum_taps(taps, window, out.at(m).size(), out.at(m).data());
    }
}

/// SSIM of each pixel of one row from its four windowed means.
void compute_row(const Moments& means, std::vector<double>& values) {
    const double* const xs = means[0].data();
    const double* const ys = means[1].data();
    const double* const squares = means[2].data();
    const double* const crosses = means[3].data();
    double* __restrict out = values.data();
    const std::size_t count = values.size();
    for (std::size_t i = 0; i < count; ++i) {
        const double product = xs[i] * ys[i];
        const double sum = xs[i] * xs[i] + ys[i] * ys[i];
        out[i] = (2.0 * product + kC1) * (2.0 * (crosses[i] - product) + kC2) /
                 ((sum + kC1) * (squares[i] - sum + kC2));
    }
}

Moments make_moments(std::size_t width) {
    Moments moments;
    moments.fill(std::vector<double>(width));
    return moments;
}

class Ssim final : public Metric {
  public:
    MetricResult evaluate(const MetricInput& input) const override {
        check_metric_input(input, "ssim", 2 * kRadius + 1);
        ALCOVE_ASSERT(input.test.channels() == 1, "luma");
        const Window window = make_window();
        const ImageSize valid{input.test.width() - 2 * kRadius, input.test.height() - 2 * kRadius};
        const auto width = static_cast<std::size_t>(valid.width);
        MetricResult result;
        result.map = Image(valid, 1);
        result.map_offset = kRadius;
        Moments products = make_moments(static_cast<std::size_t>(input.test.width()));
        // The last 11 input rows, row y in place y mod 11.
        std::array<Moments, kTaps> rows;
        rows.fill(make_moments(width));
        Moments means = make_moments(width);
        std::vector<double> values(width);
        double sum = 0.0;
        for (int row = 0; row < input.test.height(); ++row) {
            const auto newest = static_cast<std::size_t>(row) % kTaps;
            sum_columns(input, row, window, products, rows.at(newest));
            const int y = row - 2 * kRadius;
            if (y < 0) {
                continue;
            }
            for (std::size_t m = 0; m < kMoments; ++m) {
                std::array<const double*, kTaps> taps{};
                for (std::size_t k = 0; k < kTaps; ++k) {
                    taps.at(k) = rows.at((newest + 1 + k) % kTaps).at(m).data();
                }
                sum_taps(taps, window, width, means.at(m).data());
            }
            compute_row(means, values);
            for (int x = 0; x < valid.width; ++x) {
                const double value = values[static_cast<std::size_t>(x)];
                result.map->at(x, y) = static_cast<float>(value);
                sum += value;
            }
        }
        result.value = sum / static_cast<double>(valid.pixel_count());
        return result;
    }
};

} // namespace

MetricUnit ssim_unit() {
    MetricUnit unit;
    unit.name = "ssim";
    unit.title = "Structural similarity";
    unit.unit = "1";
    unit.definition = "Wang et al. 2004 on the view (sRGB codes in [0,1]; Rec. 709 luma of "
                      "colour): 11 x 11 Gaussian window, sigma 1.5, "
                      "normalised in double; K1 0.01, K2 0.03, L 1; population variances; mean "
                      "over the valid region (W - 10)(H - 10); "
                      "no downsampling (scale = 1).";
    unit.blind_to = "absolute level in bright areas; over-sensitive in dark ones (codes 0 and 8 "
                    "give 0.09); says nothing of "
                    "where an error is seen.";
    unit.direction = Direction::higher_is_better;
    unit.domain = MetricDomain::view;
    unit.luma = true;
    unit.smallest_side = 2 * kRadius + 1;
    unit.minimum = -1.0;
    unit.maximum = 1.0;
    unit.best = 1.0;
    unit.parameters = describe_parameters("ssim", {});
    unit.checks = {
        {"ramp against noise", make_noisy_ramp, make_ramp, 0.725787, 1e-6,
         "check vector of the definition in double"},
        {"ramp against ramp + 10",
         [] { return make_changed_ramp([](int code, int, int) { return code + 10; }); }, make_ramp,
         0.993531, 1e-6, "check vector of the definition in double"},
        {"ramp against half contrast",
         [] { return make_changed_ramp([](int code, int, int) { return 64 + code / 2; }); },
         make_ramp, 0.957260, 1e-6, "check vector of the definition in double"},
        {"constants 0 and 1", [] { return make_constant(0); }, [] { return make_constant(1); },
         0.8667, 5e-5, "by hand: C1 / (1 / 255^2 + C1)"},
        {"constants 128 and 136", [] { return make_constant(128); },
         [] { return make_constant(136); }, 0.9982, 5e-5, "by hand: luminance term alone"},
    };
    unit.create = [](const ResolvedParameters&) { return std::make_unique<Ssim>(); };
    return unit;
}

} // namespace alcove
