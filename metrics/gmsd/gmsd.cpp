// This work is based on: Xue, Zhang, Mou, Bovik. Gradient Magnitude Similarity Deviation: A Highly
// Efficient Perceptual Image Quality Index. 2014.
#include "metrics/gmsd/gmsd.hpp"

#include "metrics/common/pooled_region.hpp"
#include "metrics/common/test_images.hpp"

#include <cmath>

namespace alcove {
namespace {

/// c of equation 4, for values in [0,1]: 170 in 8-bit codes squared.
constexpr double kC = 170.0 / (255.0 * 255.0);

/// One whole Prewitt window after halving.
constexpr int kSmallestSide = 6;

/// Zero outside of the image, as the published script pads.
double get_padded(const Image& image, int x, int y) {
    const bool is_inside = x >= 0 && x < image.width() && y >= 0 && y < image.height();
    return is_inside ? static_cast<double>(image.at(x, y)) : 0.0;
}

/// Means of 2 x 2 pixels.
Image halve(const Image& image) {
    Image half({(image.width() + 1) / 2, (image.height() + 1) / 2}, 1);
    for (int y = 0; y < half.height(); ++y) {
        for (int x = 0; x < half.width(); ++x) {
            half.at(x, y) = static_cast<float>(
                0.25 *
                (get_padded(image, 2 * x, 2 * y) + get_padded(image, 2 * x + 1, 2 * y) +
                 get_padded(image, 2 * x, 2 * y + 1) + get_padded(image, 2 * x + 1, 2 * y + 1)));
        }
    }
    return half;
}

/// Squared gradient by Prewitt's filters, divided by 3.
double compute_square(const Image& image, int x, int y) {
    double across = 0.0;
    double down = 0.0;
    for (int k = -1; k <= 1; ++k) {
        across += get_padded(image, x + 1, y + k) - get_padded(image, x - 1, y + k);
        down += get_padded(image, x + k, y + 1) - get_padded(image, x + k, y - 1);
    }
    return (across * across + down * down) / 9.0;
}

/// Equation 4.
Image make_similarity(const Image& test, const Image& reference) {
    Image similarity(test.size(), 1);
    for (int y = 0; y < test.height(); ++y) {
        for (int x = 0; x < test.width(); ++x) {
            const double a = compute_square(test, x, y);
            const double b = compute_square(reference, x, y);
            similarity.at(x, y) = static_cast<float>((2.0 * std::sqrt(a * b) + kC) / (a + b + kC));
        }
    }
    return similarity;
}

/// Equation 6: the standard deviation, divided by N.
double compute_deviation(const std::vector<float>& values) {
    const auto count = static_cast<double>(values.size());
    double sum = 0.0;
    for (const float value : values) {
        sum += static_cast<double>(value);
    }
    const double mean = sum / count;
    double squares = 0.0;
    for (const float value : values) {
        const double difference = static_cast<double>(value) - mean;
        squares += difference * difference;
    }
    return std::sqrt(squares / count);
}

class Gmsd final : public Metric {
  public:
    MetricResult evaluate(const MetricInput& input) const override {
        check_metric_input(input, "gmsd", kSmallestSide);
        ALCOVE_ASSERT(input.test.channels() == 1, "luma");
        const Image similarity = make_similarity(halve(input.test), halve(input.reference));
        std::optional<Image> mask;
        if (input.mask != nullptr) {
            mask = halve_mask(*input.mask);
        }
        const PooledRegion region(mask ? &*mask : nullptr, similarity.size());
        MetricResult result;
        region.report(result);
        if (region.count() > 0) {
            result.value = compute_deviation(list_counted(similarity, region));
        }
        result.map = Image(input.test.size(), 1);
        for (int y = 0; y < input.test.height(); ++y) {
            for (int x = 0; x < input.test.width(); ++x) {
                result.map->at(x, y) = similarity.at(x / 2, y / 2);
            }
        }
        return result;
    }
};

/// Black with white pixels (32..33, 32..33), which is one pixel once it is halved.
Image make_dot() {
    Image image({64, 64}, 1);
    for (const int y : {32, 33}) {
        for (const int x : {32, 33}) {
            image.at(x, y) = 1.0f;
        }
    }
    return image;
}

/// A dot of height 1 against black: 4 of 32 x 32 pixels have a squared gradient of 1/9, 4 of 2/9,
/// and similarity c / (g^2 + c); all others 1.
double compute_dot_by_hand() {
    const double straight = 1.0 - kC / (1.0 / 9.0 + kC);
    const double diagonal = 1.0 - kC / (2.0 / 9.0 + kC);
    const double mean = 4.0 * (straight + diagonal) / 1024.0;
    const double squares = 4.0 * (straight * straight + diagonal * diagonal) / 1024.0;
    return std::sqrt(squares - mean * mean);
}

} // namespace

MetricUnit gmsd_unit() {
    MetricUnit unit;
    unit.name = "gmsd";
    unit.title = "Gradient magnitude similarity deviation";
    unit.unit = "1";
    unit.definition =
        "Xue et al. 2014 on the view (sRGB codes in [0,1]; Rec. 709 luma of colour): means of 2 x "
        "2 "
        "pixels, gradients g by Prewitt's filters over 3, zero outside; similarity "
        "(2 g_t g_r + c) / (g_t^2 + g_r^2 + c), c = 170 / 255^2; standard deviation of it over the "
        "halved image, divided by N. Map: the similarity, 2 x 2 pixels alike.";
    unit.blind_to = "any error that is the same everywhere, a changed level or a changed contrast "
                    "of smooth areas, and detail finer than two pixels.";
    unit.domain = MetricDomain::view;
    unit.luma = true;
    unit.on_demand = true;
    unit.smallest_side = kSmallestSide;
    unit.minimum = 0.0;
    unit.maximum = 1.0;
    unit.best = 0.0;
    unit.parameters = describe_parameters("gmsd", {});
    unit.checks = {
        {"black, one white dot", [] { return make_constant(0); }, make_dot, compute_dot_by_hand(),
         1e-7, "by hand: c / (g^2 + c) with g^2 = 1/9 at 4 and 2/9 at 4 of 1024 pixels"},
        {"equal ramps", make_ramp, make_ramp, 0.0, 1e-7, "by definition"},
    };
    unit.create = [](const ResolvedParameters&) { return std::make_unique<Gmsd>(); };
    return unit;
}

} // namespace alcove
