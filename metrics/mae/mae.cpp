#include "metrics/mae/mae.hpp"

#include "metrics/common/absolute_error.hpp"
#include "metrics/common/test_images.hpp"

#include <algorithm>
#include <limits>

namespace alcove {
namespace {

double compute_mean(const std::vector<float>& values) {
    double sum = 0.0;
    for (const float value : values) {
        sum += static_cast<double>(value);
    }
    return sum / static_cast<double>(values.size());
}

class Mae final : public Metric {
  public:
    MetricResult evaluate(const MetricInput& input) const override {
        check_metric_input(input, "mae");
        return pool_absolute_error(input, compute_mean);
    }
};

} // namespace

MetricUnit mae_unit() {
    MetricUnit unit;
    unit.name = "mae";
    unit.title = "Mean absolute error";
    unit.unit = "value";
    unit.definition =
        "Mean over all pixels and channels of |test - reference|, on the values that mse runs on, "
        "summed in double. With two halves A, B of the reference: floor = mean |A - B| / 2.";
    unit.blind_to = "where errors lie, whether they are seen, and their spread: a faint veil "
                    "weighs as much as a few wrong pixels.";
    unit.on_demand = true;
    unit.maximum = std::numeric_limits<double>::infinity();
    unit.best = 0.0;
    unit.parameters = describe_parameters("mae", {});
    unit.checks = {
        {"constants 100 and 151", [] { return make_constant(100); },
         [] { return make_constant(151); }, 0.2, 1e-7, "by hand: 51 / 255"},
        {"ramp against half contrast",
         [] { return make_changed_ramp([](int code, int, int) { return 64 + code / 2; }); },
         make_ramp, 1398016.0 / (65536.0 * 255.0), 1e-8,
         "by hand: sum over codes k of |64 + floor(k / 2) - k| times the pixels of code k"},
    };
    unit.create = [](const ResolvedParameters&) { return std::make_unique<Mae>(); };
    return unit;
}

} // namespace alcove
