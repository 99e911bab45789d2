// This work is based on: Wang, Bovik, Sheikh, Simoncelli. Image quality assessment: from error
// visibility to structural similarity. 2004.
#include "metrics/ssim/ssim.hpp"

#include "metrics/common/structure.hpp"
#include "metrics/common/test_images.hpp"

namespace alcove {
namespace {

constexpr int kSmallestSide = 2 * kStructureRadius + 1;

class Ssim final : public Metric {
  public:
    MetricResult evaluate(const MetricInput& input) const override {
        check_metric_input(input, "ssim", kSmallestSide);
        ALCOVE_ASSERT(input.test.channels() == 1, "luma");
        const PooledRegion region = make_structure_region(input.mask, input.test.size());
        MetricResult result;
        region.report(result);
        if (region.count() == 0) {
            return result;
        }
        Image map;
        result.value =
            compute_structure(input.test, input.reference, StructureTerm::whole, region, &map);
        result.map = std::move(map);
        result.map_offset = kStructureRadius;
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
    unit.smallest_side = kSmallestSide;
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
