// This work is based on: Wang, Bovik, Sheikh, Simoncelli. Image quality assessment: from error visibility to structural
// similarity. 2004.
#include "metrics/ssim/ssim.hpp"

#include "metrics/common/test_images.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace alcove {
namespace {

constexpr int kRadius = 5; // 11 taps
constexpr double kC1 = 0.01 * 0.01; // (K1 L)^2 with L = 1
constexpr double kC2 = 0.03 * 0.03; // (K2 L)^2

/// Half of the symmetric window: weight of the centre, then of both taps at distance 1..5. Normalised in double: a
/// kernel rounded to six digits biases the variances by 4e-6 mu^2.
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

/// The five windowed means of one output row: x, y, x^2, y^2, xy. Kept apart so that the inner loops vectorise.
using Moments = std::array<std::vector<double>, 5>;

/// Weighted sums of 11 rows, at every column.
void sum_columns(const MetricInput& input, int row, const std::array<double, kRadius + 1>& window,
                 Moments& columns) {
    const auto width = static_cast<std::size_t>(input.test.width());
    for (std::vector<double>& moment : columns) {
        moment.assign(width, 0.0);
    }
    for (int k = -kRadius; k <= kRadius; ++k) {
        const double weight = window[static_cast<std::size_t>(std::abs(k))];
        const std::size_t first = static_cast<std::size_t>(row + kRadius + k) * width;
        const float* test = input.test.values().data() + first;
        const float* reference = input.reference.values().data() + first;
        double* const mx = columns[0].data();
        double* const my = columns[1].data();
        double* const mxx = columns[2].data();
        double* const myy = columns[3].data();
        double* const mxy = columns[4].data();
        for (std::size_t i = 0; i < width; ++i) {
            const double x = static_cast<double>(test[i]);
            const double y = static_cast<double>(reference[i]);
            const double wx = weight * x;
            const double wy = weight * y;
            mx[i] += wx;
            my[i] += wy;
            mxx[i] += wx * x;
            myy[i] += wy * y;
            mxy[i] += wx * y;
        }
    }
}

/// Weighted sums of 11 neighbouring columns.
void sum_rows(const std::vector<double>& column, const std::array<double, kRadius + 1>& window,
              std::vector<double>& out) {
    const double* const in = column.data() + kRadius;
    double* const sums = out.data();
    const std::size_t count = out.size();
    for (std::size_t i = 0; i < count; ++i) {
        sums[i] = window[0] * in[i];
    }
    for (std::ptrdiff_t k = 1; k <= kRadius; ++k) {
        const double weight = window[static_cast<std::size_t>(k)];
        const double* const left = in - k;
        const double* const right = in + k;
        for (std::size_t i = 0; i < count; ++i) {
            sums[i] += weight * (left[i] + right[i]);
        }
    }
}

class Ssim final : public Metric {
  public:
    MetricResult evaluate(const MetricInput& input) const override {
        check_metric_input(input, "ssim", 2 * kRadius + 1);
        ALCOVE_ASSERT(input.test.channels() == 1, "luma");
        const std::array<double, kRadius + 1> window = make_window();
        const ImageSize valid{input.test.width() - 2 * kRadius, input.test.height() - 2 * kRadius};
        MetricResult result;
        result.map = Image(valid, 1);
        result.map_offset = kRadius;
        Moments columns;
        Moments rows;
        for (std::vector<double>& row : rows) {
            row.resize(static_cast<std::size_t>(valid.width));
        }
        double sum = 0.0;
        for (int y = 0; y < valid.height; ++y) {
            sum_columns(input, y, window, columns);
            for (std::size_t m = 0; m < rows.size(); ++m) {
                sum_rows(columns.at(m), window, rows.at(m));
            }
            for (int x = 0; x < valid.width; ++x) {
                const auto i = static_cast<std::size_t>(x);
                const double mx = rows[0][i];
                const double my = rows[1][i];
                const double variance_sum = rows[2][i] + rows[3][i] - mx * mx - my * my;
                const double covariance = rows[4][i] - mx * my;
                const double value = (2.0 * mx * my + kC1) * (2.0 * covariance + kC2) /
                                     ((mx * mx + my * my + kC1) * (variance_sum + kC2));
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
    unit.definition =
        "Wang et al. 2004 on the view (sRGB codes in [0,1]; Rec. 709 luma of colour): 11 x 11 Gaussian window, sigma 1.5, "
        "normalised in double; K1 0.01, K2 0.03, L 1; population variances; mean over the valid region (W - 10)(H - 10); "
        "no downsampling (scale = 1).";
    unit.blind_to = "absolute level in bright areas; over-sensitive in dark ones (codes 0 and 8 give 0.09); says nothing of "
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
