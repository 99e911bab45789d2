#include "core/contract/metric.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <utility>

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

void check_mask(const MetricInput& input, std::string_view metric) {
    const Image& mask = *input.mask;
    if (mask.size() != input.test.size() || mask.channels() != 1) {
        throw InputError(metric, "the mask is not the images' size with one channel",
                         describe_shape(mask), describe_shape(input.test));
    }
    for (int y = 0; y < mask.height(); ++y) {
        for (int x = 0; x < mask.width(); ++x) {
            const float value = mask.at(x, y);
            if (value != 0.0f && value != 1.0f) {
                throw InputError(metric,
                                 "the mask holds another value at pixel (" + std::to_string(x) +
                                     ", " + std::to_string(y) + ")",
                                 std::to_string(value), "1 (counted) or 0 (ignored)");
            }
        }
    }
}

void check_depth(const MetricInput& input, std::string_view metric) {
    const Image& depth = *input.depth;
    if (depth.size() != input.test.size() || depth.channels() != 1) {
        throw InputError(metric, "the depth is not the images' size with one channel",
                         describe_shape(depth), describe_shape(input.test));
    }
    for (const float value : depth.values()) {
        if (!(value > 0.0f)) {
            throw InputError(metric, "the depth holds a value that is no distance",
                             std::to_string(value), "metres over 0, inf on the background");
        }
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
    if (input.mask != nullptr) {
        check_mask(input, metric);
    }
    if (input.depth != nullptr) {
        check_depth(input, metric);
    }
}

MetricResult evaluate_check(const Metric& metric, const MetricCheck& check) {
    const Image test = check.make_test();
    const Image reference = check.make_reference();
    std::optional<Image> depth;
    if (check.make_depth) {
        depth = check.make_depth();
    }
    return metric.evaluate({test, reference, nullptr, nullptr, nullptr, depth ? &*depth : nullptr});
}

Image convert_for_unit(const MetricUnit& unit, const Image& image, Domain from,
                       MetricDomain wanted) {
    Image converted = convert_for_metric(image, from, wanted);
    return unit.luma ? compute_luma(converted) : converted;
}

std::optional<MetricResult> refuse_small_image(const MetricUnit& unit, ImageSize size) {
    if (std::min(size.width, size.height) >= unit.smallest_side) {
        return std::nullopt;
    }
    MetricResult result;
    result.undefined_reason = "image smaller than the metric's window, " +
                              std::to_string(unit.smallest_side) + " pixels a side";
    return result;
}

MetricResult evaluate_in_domain(const MetricUnit& unit, const Metric& metric,
                                const MetricInput& input, Domain domain, MetricDomain wanted) {
    // Before conversion: it clamps, and would hide an infinite value.
    check_metric_input(input, unit.name);
    if (std::optional<MetricResult> refusal = refuse_small_image(unit, input.test.size())) {
        return std::move(*refusal);
    }
    const auto convert = [&](const Image& image) {
        return convert_for_unit(unit, image, domain, wanted);
    };
    const Image test = convert(input.test);
    const Image reference = convert(input.reference);
    if (input.reference_a == nullptr) {
        return metric.evaluate({test, reference, nullptr, nullptr, input.mask, input.depth});
    }
    const Image a = convert(*input.reference_a);
    const Image b = convert(*input.reference_b);
    return metric.evaluate({test, reference, &a, &b, input.mask, input.depth});
}

} // namespace alcove
