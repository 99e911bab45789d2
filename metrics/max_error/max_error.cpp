#include "metrics/max_error/max_error.hpp"

#include "metrics/common/absolute_error.hpp"
#include "metrics/common/test_images.hpp"

#include <algorithm>
#include <limits>

namespace alcove {
namespace {

double find_largest(const std::vector<float>& values) {
    return static_cast<double>(*std::max_element(values.begin(), values.end()));
}

class MaxError final : public Metric {
  public:
    MetricResult evaluate(const MetricInput& input) const override {
        check_metric_input(input, "max_error");
        return pool_absolute_error(input, find_largest);
    }
};

} // namespace

MetricUnit max_error_unit() {
    MetricUnit unit;
    unit.name = "max_error";
    unit.title = "Largest absolute error";
    unit.unit = "value";
    unit.definition =
        "Largest |test - reference| over all pixels and channels, on the values that mse runs on. "
        "With two halves A, B of the reference: floor = largest |A - B| / 2.";
    unit.blind_to = "everything but one value of one pixel.";
    unit.on_demand = true;
    unit.maximum = std::numeric_limits<double>::infinity();
    unit.best = 0.0;
    unit.parameters = describe_parameters("max_error", {});
    unit.checks = {
        {"constants 100 and 151", [] { return make_constant(100); },
         [] { return make_constant(151); }, 0.2, 1e-7, "by hand: 51 / 255"},
        {"ramp against half contrast",
         [] { return make_changed_ramp([](int code, int, int) { return 64 + code / 2; }); },
         make_ramp, 64.0 / 255.0, 1e-7, "by hand: 64 at code 0 and |191 - 255| at code 255"},
    };
    unit.create = [](const ResolvedParameters&) { return std::make_unique<MaxError>(); };
    return unit;
}

} // namespace alcove
