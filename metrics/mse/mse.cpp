#include "metrics/mse/mse.hpp"

#include "metrics/common/squared_error.hpp"
#include "metrics/common/test_images.hpp"

#include <limits>

namespace alcove {
namespace {

class Mse final : public Metric {
  public:
    MetricResult evaluate(const MetricInput& input) const override {
        check_metric_input(input, "mse");
        const PooledRegion region(input.mask, input.test.size());
        MetricResult result;
        region.report(result);
        result.map = make_squared_error_map(input);
        if (region.count() == 0) {
            return result;
        }
        const SquaredError error = compute_squared_error(input, region);
        result.value = error.mean;
        result.debiased = error.debiased;
        result.floor = error.noise;
        return result;
    }
};

} // namespace

MetricUnit mse_unit() {
    MetricUnit unit;
    unit.name = "mse";
    unit.title = "Mean squared error";
    unit.unit = "value^2";
    unit.definition = "Mean over all pixels and channels of (test - reference)^2, on linear "
                      "visibility or linear radiance, summed in "
                      "double, peak 1. With two halves A, B of the reference: debiased = mean (t - "
                      "A)(t - B), floor = mean (A - B)^2 / 4.";
    unit.blind_to =
        "where errors lie and whether they are seen: a faint veil weighs as much as a wrong edge.";
    unit.maximum = std::numeric_limits<double>::infinity();
    unit.best = 0.0;
    unit.parameters = describe_parameters("mse", {});
    const double codes = 255.0 * 255.0;
    // Codes / 255 are rounded to float, 6e-8 relative; their differences of some codes lose up to a
    // digit more.
    constexpr double kTolerance = 1e-6;
    unit.checks = {
        {"ramp against noise", make_noisy_ramp, make_ramp, 24.004959 / codes,
         kTolerance * 24.0 / codes, "published check vector: 24.004959 in codes squared"},
        {"ramp against ramp + 10",
         [] { return make_changed_ramp([](int code, int, int) { return code + 10; }); }, make_ramp,
         99.838028 / codes, kTolerance * 99.8 / codes,
         "published check vector: 99.838028 in codes squared"},
        {"ramp against half contrast",
         [] { return make_changed_ramp([](int code, int, int) { return 64 + code / 2; }); },
         make_ramp, 682.75 / codes, kTolerance * 682.8 / codes,
         "published check vector: 682.75 in codes squared"},
    };
    unit.create = [](const ResolvedParameters&) { return std::make_unique<Mse>(); };
    return unit;
}

} // namespace alcove
