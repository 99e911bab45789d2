#include "core/contract/metric.hpp"

#include "core/base/error.hpp"

#include <algorithm>

namespace alcove {
namespace {

std::string describe_shape(const Image& image) {
    return std::to_string(image.width()) + "x" + std::to_string(image.height()) + "x" +
           std::to_string(image.channels());
}

void check_finite(const Image& image, std::string_view metric, std::string_view which) {
    PixelPosition position;
    if (find_non_finite(image, position)) {
        throw InputError(metric,
                         std::string(which) + " image holds NaN or infinity at pixel (" +
                             std::to_string(position.x) + ", " + std::to_string(position.y) +
                             "), channel " + std::to_string(position.channel),
                         "", "finite values");
    }
}

} // namespace

void check_metric_input(const MetricInput& input, std::string_view metric, int smallest_side) {
    const auto same_shape = [&input](const Image* image) {
        return image == nullptr ||
               (image->size() == input.test.size() && image->channels() == input.test.channels());
    };
    if (!same_shape(&input.reference) || !same_shape(input.reference_a) ||
        !same_shape(input.reference_b)) {
        throw InputError(metric, "test and reference differ in size or channels",
                         describe_shape(input.test), describe_shape(input.reference));
    }
    ALCOVE_ASSERT((input.reference_a == nullptr) == (input.reference_b == nullptr),
                  "both halves of a reference or none");
    if (std::min(input.test.width(), input.test.height()) < smallest_side) {
        throw InputError(metric, "image too small", describe_shape(input.test),
                         "sides of " + std::to_string(smallest_side) + " pixels or more");
    }
    check_finite(input.test, metric, "test");
    check_finite(input.reference, metric, "reference");
    if (input.reference_a != nullptr) {
        check_finite(*input.reference_a, metric, "reference half A");
        check_finite(*input.reference_b, metric, "reference half B");
    }
}

MetricResult evaluate_in_domain(const MetricUnit& unit, const Metric& metric,
                                const MetricInput& input, Domain domain) {
    // Before conversion: it clamps, and would hide an infinite value.
    check_metric_input(input, unit.name);
    const auto convert = [&](const Image& image) {
        Image converted = convert_for_metric(image, domain, unit.domain);
        return unit.luma ? compute_luma(converted) : converted;
    };
    const Image test = convert(input.test);
    const Image reference = convert(input.reference);
    if (input.reference_a == nullptr) {
        return metric.evaluate({test, reference});
    }
    const Image a = convert(*input.reference_a);
    const Image b = convert(*input.reference_b);
    return metric.evaluate({test, reference, &a, &b});
}

} // namespace alcove
