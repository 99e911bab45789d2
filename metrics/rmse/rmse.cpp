#include "metrics/rmse/rmse.hpp"

#include "metrics/common/squared_error.hpp"
#include "metrics/common/test_images.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alcove {
namespace {

class Rmse final : public Metric {
  public:
    MetricResult evaluate(const MetricInput& input) const override {
        check_metric_input(input, "rmse");
        const PooledRegion region(input.mask, input.test.size());
        MetricResult result;
        region.report(result);
        result.map = make_squared_error_map(input);
        for (float& value : result.map->values()) {
            value = std::sqrt(value);
        }
        if (region.count() == 0) {
            return result;
        }
        const SquaredError error = compute_squared_error(input, region);
        result.value = std::sqrt(error.mean);
        if (error.debiased) {
            // Its expectation is the true squared error; by chance it may fall below 0, which then
            // reads as 0.
            result.debiased = std::sqrt(std::max(0.0, *error.debiased));
            result.floor = std::sqrt(*error.noise);
        }
        return result;
    }
};

} // namespace

MetricUnit rmse_unit() {
    MetricUnit unit;
    unit.name = "rmse";
    unit.title = "Root mean squared error";
    unit.unit = "value";
    unit.definition = "Square root of mse. With two halves A, B of the reference: debiased = "
                      "sqrt(max(0, mean (t - A)(t - B))), "
                      "floor = RMS(A - B) / 2, the reference's own standard error.";
    unit.blind_to = "where errors lie and whether they are seen.";
    unit.maximum = std::numeric_limits<double>::infinity();
    unit.best = 0.0;
    unit.parameters = describe_parameters("rmse", {});
    unit.checks = {
        {"constants 100 and 151", [] { return make_constant(100); },
         [] { return make_constant(151); }, 0.2, 1e-7, "by hand: 51 / 255"},
        {"ramp against noise", make_noisy_ramp, make_ramp, std::sqrt(24.004959) / 255.0, 1e-8,
         "square root of mse's check vector"},
    };
    unit.create = [](const ResolvedParameters&) { return std::make_unique<Rmse>(); };
    return unit;
}

} // namespace alcove
