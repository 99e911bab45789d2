#include "metrics/energy_ratio/energy_ratio.hpp"

#include "metrics/common/pooled_region.hpp"
#include "metrics/common/test_images.hpp"

#include <cmath>
#include <limits>

namespace alcove {
namespace {

class EnergyRatio final : public Metric {
  public:
    MetricResult evaluate(const MetricInput& input) const override {
        check_metric_input(input, "energy_ratio");
        ALCOVE_ASSERT(input.test.channels() == 1, "luma");
        const PooledRegion region(input.mask, input.test.size());
        MetricResult result;
        region.report(result);
        if (region.count() == 0) {
            return result;
        }
        const double test = region.compute_mean(input.test);
        const double reference = region.compute_mean(input.reference);
        if (!(test > 0.0) || !(reference > 0.0)) {
            result.undefined_reason =
                std::string("no light in the ") + (reference > 0.0 ? "test image" : "reference");
            return result;
        }
        const double stops = std::log2(test / reference);
        result.value = std::abs(stops);
        result.extras = {{"stops", stops}};
        if (input.reference_a != nullptr) {
            const double a = region.compute_mean(*input.reference_a);
            const double b = region.compute_mean(*input.reference_b);
            if (a > 0.0 && b > 0.0) {
                result.floor = 0.5 * std::abs(std::log2(a / b));
            }
        }
        return result;
    }
};

/// Between 0.2 and 0.6.
Image make_waves(ImageSize size) {
    Image image(size, 1);
    for (std::size_t i = 0; i < image.values().size(); ++i) {
        image.values()[i] = 0.2f + 0.004f * static_cast<float>((i * 37) % 101);
    }
    return image;
}

Image dim(const Image& reference, float amount) {
    Image image = reference;
    for (float& value : image.values()) {
        value *= 1.0f - amount;
    }
    return image;
}

} // namespace

MetricUnit energy_ratio_unit() {
    MetricUnit unit;
    unit.name = "energy_ratio";
    unit.title = "Energy against the reference";
    unit.unit = "stops";
    unit.definition =
        "|log2(mean test / mean reference)| of Rec. 709 luminance in linear light: 1 "
        "is twice or half the light. stops: the same with its sign, above 0 where "
        "the test is brighter. Over a mask or a region its own light. With two halves "
        "A, B of the reference: floor = the same of A over B, halved. Undefined where "
        "one of the images has no light.";
    unit.blind_to =
        "where light lies and which colour it has: light that is too much here makes up "
        "for light that lacks there.";
    unit.domain = MetricDomain::linear;
    unit.luma = true;
    unit.on_demand = true;
    unit.is_of_pictures = true;
    unit.maximum = std::numeric_limits<double>::infinity();
    unit.best = 0.0;
    unit.parameters = describe_parameters("energy_ratio", {});
    unit.canary = MetricCanary{make_waves, dim};
    unit.checks = {
        {"a checkerboard against white", make_checkerboard, [] { return make_constant(255); }, 1.0,
         1e-9, "by hand: half the light"},
        {"white against a checkerboard", [] { return make_constant(255); }, make_checkerboard, 1.0,
         1e-9, "by hand: twice the light"},
        {"code 51 against white", [] { return make_constant(51); },
         [] { return make_constant(255); }, 2.321928, 1e-6, "by hand: log2 of 51 / 255"},
    };
    unit.create = [](const ResolvedParameters&) { return std::make_unique<EnergyRatio>(); };
    return unit;
}

} // namespace alcove
