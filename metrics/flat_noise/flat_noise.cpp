#include "metrics/flat_noise/flat_noise.hpp"

#include "metrics/common/box_mean.hpp"
#include "metrics/common/pooled_region.hpp"
#include "metrics/common/test_images.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alcove {
namespace {

/// Windows of 5 x 5, and those two pixels to each side of them.
constexpr int kWindow = 5;
constexpr int kReach = 2;
constexpr int kMargin = 2 * kReach;
constexpr int kSmallestSide = 2 * kMargin + 1;

/// White noise loses 1/25 of its variance with its mean over the window.
constexpr double kGain = 25.0 / 24.0;

struct FlatNoiseParams {
    double flatness = 0.02;
};

ParameterTable describe() {
    return describe_parameters(
        "flat_noise",
        {real(&FlatNoiseParams::flatness, "flatness")
             .range(0.0, 1.0)
             .unit("value")
             .meaning("How far the reference's means over 5 x 5 pixels may lie apart, "
                      "here and two pixels to each side, where it is flat.")
             .source("ours")});
}

/// 1 where the reference is flat: its means, for it has noise of its own.
Image find_flat(const Image& reference, double flatness) {
    const Image means = compute_box_means(reference, kWindow, kReach);
    Image flat(reference.size(), 1);
    for (int y = kMargin; y < reference.height() - kMargin; ++y) {
        for (int x = kMargin; x < reference.width() - kMargin; ++x) {
            const auto [low, high] =
                std::minmax({means.at(x, y), means.at(x - kReach, y), means.at(x + kReach, y),
                             means.at(x, y - kReach), means.at(x, y + kReach)});
            flat.at(x, y) =
                static_cast<double>(high) - static_cast<double>(low) <= flatness ? 1.0f : 0.0f;
        }
    }
    return flat;
}

Image multiply_masks(const Image& flat, const Image* mask) {
    Image both = flat;
    for (std::size_t i = 0; mask != nullptr && i < both.values().size(); ++i) {
        both.values()[i] *= mask->values()[i];
    }
    return both;
}

/// The error without its mean over the window.
Image compute_residual(const Image& test, const Image& reference) {
    const Image error = subtract_images(test, reference);
    return subtract_images(error, compute_box_means(error, kWindow, kReach));
}

/// Mean of a b over the region.
double compute_mean_product(const Image& a, const Image& b, const PooledRegion& region) {
    double sum = 0.0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            if (region.is_counted(x, y)) {
                sum += static_cast<double>(a.at(x, y)) * static_cast<double>(b.at(x, y));
            }
        }
    }
    return sum / static_cast<double>(region.count());
}

double take_root(double mean_square) {
    return std::sqrt(kGain * std::max(0.0, mean_square));
}

class FlatNoise final : public Metric {
  public:
    explicit FlatNoise(const FlatNoiseParams& params) : m_params(params) {}

    MetricResult evaluate(const MetricInput& input) const override {
        check_metric_input(input, "flat_noise", kSmallestSide);
        ALCOVE_ASSERT(input.test.channels() == 1, "luma");
        const Image flat = find_flat(input.reference, m_params.flatness);
        const Image counted = multiply_masks(flat, input.mask);
        const PooledRegion all(&flat, flat.size());
        const PooledRegion region(&counted, flat.size());
        MetricResult result;
        if (input.mask != nullptr) {
            result.counted_pixels = region.count();
            result.ignored_pixels = all.count() - region.count();
        }
        if (region.count() == 0) {
            result.undefined_reason = all.count() == 0 ? "the reference is flat nowhere"
                                                       : "the mask counts none of the flat pixels";
            if (input.mask != nullptr && all.count() == 0) {
                result.undefined_reason += ", whatever the mask";
            }
            return result;
        }
        const Image residual = compute_residual(input.test, input.reference);
        result.value = take_root(compute_mean_product(residual, residual, region));
        result.map = Image(flat.size(), 1);
        for (std::size_t i = 0; i < flat.values().size(); ++i) {
            result.map->values()[i] = std::abs(residual.values()[i]) * flat.values()[i];
        }
        if (input.reference_a != nullptr) {
            const Image a = compute_residual(input.test, *input.reference_a);
            const Image b = compute_residual(input.test, *input.reference_b);
            const Image noise = subtract_images(a, b);
            result.debiased = take_root(compute_mean_product(a, b, region));
            result.floor = take_root(0.25 * compute_mean_product(noise, noise, region));
        }
        result.extras = {{"flat_share", static_cast<double>(all.count()) /
                                            static_cast<double>(flat.size().pixel_count())}};
        return result;
    }

  private:
    FlatNoiseParams m_params;
};

/// Rises by 0.001 a pixel to the right.
Image make_gentle_ramp(ImageSize size) {
    Image image(size, 1);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            image.at(x, y) = 0.4f + 0.001f * static_cast<float>(x);
        }
    }
    return image;
}

/// +-amount, alternating.
Image add_checks(const Image& reference, float amount) {
    Image image = reference;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            image.at(x, y) += (x + y) % 2 == 0 ? amount : -amount;
        }
    }
    return image;
}

} // namespace

MetricUnit flat_noise_unit() {
    MetricUnit unit;
    unit.name = "flat_noise";
    unit.title = "Noise on flat patches";
    unit.unit = "value";
    unit.definition =
        "Ours. A pixel is flat where the reference's means over 5 x 5 pixels, here and two pixels "
        "left, right, up and down, lie within `flatness`; e = test - reference; h = e minus its "
        "mean over 5 x 5; sqrt(25/24 mean h^2) over flat pixels, which is the standard deviation "
        "of white noise. With two halves A, B: debiased = sqrt(max(0, 25/24 mean h_A h_B)), floor "
        "= sqrt(25/24 mean ((h_A - h_B) / 2)^2). flat_share: flat pixels over all.";
    unit.blind_to = "noise where the reference has detail, blotches wider than five pixels, and "
                    "any error that varies slowly.";
    unit.luma = true;
    unit.on_demand = true;
    unit.smallest_side = kSmallestSide;
    unit.maximum = std::numeric_limits<double>::infinity();
    unit.best = 0.0;
    unit.parameters = describe();
    unit.canary = MetricCanary{make_gentle_ramp, add_checks};
    unit.checks = {
        {"checkerboard, its mean", make_checkerboard,
         [] {
             return Image({64, 64}, 1, 0.5f);
         },
         0.5 * std::sqrt(0.96), 1e-7,
         "by hand: +-0.5 less a mean of +-0.5 / 25, times sqrt(25/24)"},
        {"constants 100 and 151", [] { return make_constant(100); },
         [] { return make_constant(151); }, 0.0, 1e-7, "by hand: the error is its own mean"},
    };
    unit.create = [table = unit.parameters](const ResolvedParameters& parameters) {
        return std::make_unique<FlatNoise>(table.bind<FlatNoiseParams>(parameters));
    };
    return unit;
}

} // namespace alcove
