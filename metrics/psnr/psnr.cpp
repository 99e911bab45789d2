#include "metrics/psnr/psnr.hpp"

#include "metrics/common/squared_error.hpp"
#include "metrics/common/test_images.hpp"

#include <cmath>
#include <limits>

namespace alcove {
namespace {

class Psnr final : public Metric {
  public:
    MetricResult evaluate(const MetricInput& input) const override {
        check_metric_input(input, "psnr");
        const PooledRegion region(input.mask, input.test.size());
        MetricResult result;
        region.report(result);
        if (region.count() == 0) {
            return result;
        }
        const SquaredError error = compute_squared_error(input, region);
        if (error.mean > 0.0) {
            result.value = -10.0 * std::log10(error.mean);
        } else {
            result.undefined_reason = "the images are equal: infinite";
        }
        if (error.debiased && *error.debiased > 0.0) {
            result.debiased = -10.0 * std::log10(*error.debiased);
        }
        return result;
    }
};

} // namespace

MetricUnit psnr_unit() {
    MetricUnit unit;
    unit.name = "psnr";
    unit.title = "Peak signal-to-noise ratio";
    unit.unit = "dB";
    unit.definition = "10 log10(1 / mse), peak 1, on the values that mse runs on. Equal images "
                      "have none (infinite).";
    unit.blind_to = "all that mse is blind to.";
    unit.direction = Direction::higher_is_better;
    unit.minimum = -std::numeric_limits<double>::infinity();
    unit.maximum = std::numeric_limits<double>::infinity();
    unit.parameters = describe_parameters("psnr", {});
    unit.checks = {
        {"ramp against noise", make_noisy_ramp, make_ramp, 34.3278, 5e-5,
         "published check vector: 34.3278 dB"},
        {"ramp against ramp + 10",
         [] { return make_changed_ramp([](int code, int, int) { return code + 10; }); }, make_ramp,
         28.1378, 5e-5, "published check vector: 28.1378 dB"},
        {"ramp against half contrast",
         [] { return make_changed_ramp([](int code, int, int) { return 64 + code / 2; }); },
         make_ramp, 19.7882, 5e-5, "published check vector: 19.7882 dB"},
    };
    unit.create = [](const ResolvedParameters&) { return std::make_unique<Psnr>(); };
    return unit;
}

} // namespace alcove
