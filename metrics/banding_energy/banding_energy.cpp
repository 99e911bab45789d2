#include "metrics/banding_energy/banding_energy.hpp"

#include "metrics/common/box_mean.hpp"
#include "metrics/common/pooled_region.hpp"
#include "metrics/common/test_images.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace alcove {
namespace {

/// A step between two plateaus of three pixels each. With two each, one of a hundred pairs of
/// white noise looks like a step, with three one of ten thousand.
constexpr int kPlateau = 3;
constexpr int kSmallestSide = 2 * kPlateau;
/// Of the step: how uneven a plateau may be, and how much of the step may be the reference's own.
constexpr double kEvenness = 1.0 / 8.0;
constexpr double kOwnShare = 1.0 / 4.0;
/// Tiled noise and interleaved sampling mostly repeat every four pixels.
constexpr int kTile = 4;

struct BandingEnergyParams {
    double least_step = 0.006; ///< 1.5 / 255
};

ParameterTable describe() {
    return describe_parameters(
        "banding_energy",
        {real(&BandingEnergyParams::least_step, "least_step")
             .range(0.0001, 1.0)
             .log_scale()
             .unit("code")
             .meaning("The lowest step that counts; above the quantisation of files of 8 bits.")
             .source("ours")});
}

/// The false step between a pixel and its neighbour along (dx, dy), or 0; the run of pixels must
/// lie inside.
double find_step(const MetricInput& input, int x, int y, int dx, int dy, double least_step) {
    const auto difference = [&](const Image& image, int k) {
        return static_cast<double>(image.at(x + (k + 1) * dx, y + (k + 1) * dy)) -
               static_cast<double>(image.at(x + k * dx, y + k * dy));
    };
    const double step = std::abs(difference(input.test, 0));
    if (step < least_step || std::abs(difference(input.reference, 0)) > kOwnShare * step) {
        return 0.0;
    }
    for (int k = 1; k < kPlateau; ++k) {
        if (std::abs(difference(input.test, k)) > kEvenness * step ||
            std::abs(difference(input.test, -k)) > kEvenness * step) {
            return 0.0;
        }
    }
    return step;
}

/// s^2 of the steps to the right and down of each pixel.
Image square_steps(const MetricInput& input, double least_step) {
    Image squares(input.test.size(), 1);
    const int width = squares.width();
    const int height = squares.height();
    const auto fits = [](int position, int side) {
        return position >= kPlateau - 1 && position + kPlateau < side;
    };
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double across = fits(x, width) ? find_step(input, x, y, 1, 0, least_step) : 0.0;
            const double down = fits(y, height) ? find_step(input, x, y, 0, 1, least_step) : 0.0;
            squares.at(x, y) = static_cast<float>(across * across + down * down);
        }
    }
    return squares;
}

/// Deviation of the means, by place in a 4 x 4 tile, of the error less its mean over one tile
/// around; nothing where a place has no pixel.
std::optional<double> measure_pattern(const MetricInput& input, const PooledRegion& region) {
    const Image error = subtract_images(input.test, input.reference);
    const Image fine = subtract_images(error, compute_box_means(error, kTile, 1));
    std::array<double, kTile * kTile> sums{};
    std::array<double, kTile * kTile> counts{};
    for (int y = 1; y + kTile - 1 <= fine.height(); ++y) {
        for (int x = 1; x + kTile - 1 <= fine.width(); ++x) {
            if (region.is_counted(x, y)) {
                const auto place = static_cast<std::size_t>(kTile * (y % kTile) + x % kTile);
                sums.at(place) += static_cast<double>(fine.at(x, y));
                counts.at(place) += 1.0;
            }
        }
    }
    double mean = 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        if (counts.at(i) == 0.0) {
            return std::nullopt;
        }
        const double value = sums.at(i) / counts.at(i);
        mean += value / static_cast<double>(sums.size());
        squares += value * value / static_cast<double>(sums.size());
    }
    return std::sqrt(std::max(0.0, squares - mean * mean));
}

class BandingEnergy final : public Metric {
  public:
    explicit BandingEnergy(const BandingEnergyParams& params) : m_params(params) {}

    MetricResult evaluate(const MetricInput& input) const override {
        check_metric_input(input, "banding_energy", kSmallestSide);
        ALCOVE_ASSERT(input.test.channels() == 1, "luma");
        const PooledRegion region(input.mask, input.test.size());
        MetricResult result;
        region.report(result);
        result.map = square_steps(input, m_params.least_step);
        if (region.count() > 0) {
            std::vector<double> rows;
            for (int y = 0; y < result.map->height(); ++y) {
                rows.push_back(region.sum_row(
                    y, &result.map->values()[static_cast<std::size_t>(y) *
                                             static_cast<std::size_t>(result.map->width())]));
            }
            result.value = std::sqrt(region.compute_mean(rows));
            if (const std::optional<double> pattern = measure_pattern(input, region)) {
                result.extras = {{"pattern_4x4", *pattern}};
            }
        }
        for (float& value : result.map->values()) {
            value = std::sqrt(value);
        }
        return result;
    }

  private:
    BandingEnergyParams m_params;
};

constexpr int kLevel = 16; ///< codes of a level: 16 levels of 256 codes

Image make_quantised_ramp() {
    return make_changed_ramp([](int code, int, int) { return code / kLevel * (kLevel + 1); });
}

/// Of the ramp floor((x + y) / 2), pairs to the right of which one begins a level: x + y + 1 is a
/// multiple of 2 kLevel, and both plateaus lie inside. As many pairs lie below each other.
double compute_ramp_by_hand() {
    constexpr int kSide = 256;
    int pairs = 0;
    for (int x = kPlateau - 1; x < kSide - kPlateau; ++x) {
        for (int y = 0; y < kSide; ++y) {
            pairs += (x + y + 1) % (2 * kLevel) == 0 ? 1 : 0;
        }
    }
    const double step = (kLevel + 1) / 255.0;
    return step * std::sqrt(2.0 * pairs / (kSide * kSide));
}

/// Rises from 0.2 by 0.6 over the diagonal.
Image make_smooth(ImageSize size) {
    Image image(size, 1);
    const auto diagonal = static_cast<float>(size.width + size.height);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            image.at(x, y) = 0.2f + 0.6f * static_cast<float>(x + y) / diagonal;
        }
    }
    return image;
}

/// Levels that lie `amount` apart.
Image quantise(const Image& reference, float amount) {
    Image image = reference;
    for (float& value : image.values()) {
        value = amount * std::floor(value / amount);
    }
    return image;
}

} // namespace

MetricUnit banding_energy_unit() {
    MetricUnit unit;
    unit.name = "banding_energy";
    unit.title = "Banding energy";
    unit.unit = "code";
    unit.definition =
        "Ours, on the view (sRGB codes in [0,1]; Rec. 709 luma of colour). A false step of s lies "
        "between two neighbours (to the right, or down) that differ by s >= least_step in the "
        "test and by s / 4 at most in the reference, where the three test pixels on each side "
        "differ by s / 8 at most from one to the next. sqrt(sum s^2 / pixels). pattern_4x4: of "
        "e = test - reference less its mean over 4 x 4, the standard deviation of the 16 means by "
        "place in a tile of 4 x 4: what tiled noise leaves.";
    unit.blind_to = "steps below least_step, bands under three pixels wide, steps that noise "
                    "covers, and edges of the reference that the test has lost or moved onto its "
                    "own.";
    unit.domain = MetricDomain::view;
    unit.luma = true;
    unit.on_demand = true;
    unit.smallest_side = kSmallestSide;
    unit.maximum = std::numeric_limits<double>::infinity();
    unit.best = 0.0;
    unit.parameters = describe();
    unit.canary = MetricCanary{make_smooth, quantise};
    unit.checks = {
        {"ramp in 16 levels", make_quantised_ramp, make_ramp, compute_ramp_by_hand(), 1e-7,
         "by hand: steps of 17 / 255 where x + y + 1 is a multiple of 32"},
        {"noisy ramp", make_noisy_ramp, make_ramp, 0.0, 1e-3,
         "by design: noise has no plateaus; 5 % of its deviation at most"},
        {"equal steps", [] { return make_step(32); }, [] { return make_step(32); }, 0.0, 1e-12,
         "by design: the reference has the edge too"},
    };
    unit.create = [table = unit.parameters](const ResolvedParameters& parameters) {
        return std::make_unique<BandingEnergy>(table.bind<BandingEnergyParams>(parameters));
    };
    return unit;
}

} // namespace alcove
