#include "metrics/p95_error/p95_error.hpp"

#include "metrics/common/absolute_error.hpp"

#include <algorithm>
#include <limits>

namespace alcove {
namespace {

constexpr std::size_t kPercent = 95;

/// Nearest rank: place ceil(0.95 n), counted from 1.
double find_percentile(std::vector<float>& values) {
    const std::size_t rank = (values.size() * kPercent + 99) / 100;
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(rank) - 1;
    std::nth_element(values.begin(), place, values.end());
    return static_cast<double>(*place);
}

Image make_all_errors() {
    Image image({20, 20}, 1);
    for (std::size_t i = 0; i < image.values().size(); ++i) {
        // 7 and 400 have no common factor: every error once, in a mixed order.
        image.values()[i] = static_cast<float>(1 + (7 * i) % 400) / 400.0f;
    }
    return image;
}

class P95Error final : public Metric {
  public:
    MetricResult evaluate(const MetricInput& input) const override {
        check_metric_input(input, "p95_error");
        return pool_absolute_error(input, find_percentile);
    }
};

} // namespace

MetricUnit p95_error_unit() {
    MetricUnit unit;
    unit.name = "p95_error";
    unit.title = "95th percentile of the absolute error";
    unit.unit = "value";
    unit.definition =
        "The smallest of the values |test - reference| (all pixels and channels) that at least 95 "
        "% of them do not exceed (nearest rank), on the values that mse runs on. With two halves "
        "A, B of the reference: floor = the same of |A - B| / 2.";
    unit.blind_to = "the worst 5 % and the rest below: where errors lie and whether they are seen.";
    unit.on_demand = true;
    unit.maximum = std::numeric_limits<double>::infinity();
    unit.best = 0.0;
    unit.parameters = describe_parameters("p95_error", {});
    unit.checks = {
        {"20 x 20, errors 1/400 to 400/400", make_all_errors,
         [] {
             return Image({20, 20}, 1);
         },
         0.95, 1e-7, "by hand: the 380th of 400"},
    };
    unit.create = [](const ResolvedParameters&) { return std::make_unique<P95Error>(); };
    return unit;
}

} // namespace alcove
