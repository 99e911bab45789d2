#include "metrics/template_metric/template_metric.hpp"

#include "metrics/common/pooled_region.hpp"
#include "metrics/common/test_images.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alcove {
namespace {

class LargestDifference final : public Metric {
  public:
    MetricResult evaluate(const MetricInput& input) const override {
        check_metric_input(input, "template_metric");
        const PooledRegion region(input.mask, input.test.size());
        MetricResult result;
        region.report(result);
        if (region.count() == 0) {
            return result;
        }
        double largest = 0.0;
        for (int y = 0; y < input.test.height(); ++y) {
            for (int x = 0; x < input.test.width(); ++x) {
                for (int c = 0; c < input.test.channels() && region.is_counted(x, y); ++c) {
                    const float difference = input.test.at(x, y, c) - input.reference.at(x, y, c);
                    largest = std::max(largest, static_cast<double>(std::abs(difference)));
                }
            }
        }
        result.value = largest;
        return result;
    }
};

} // namespace

MetricUnit template_metric_unit() {
    MetricUnit unit;
    unit.name = "template_metric";
    unit.title = "Template: largest difference";
    unit.unit = "value";
    unit.definition = "Largest |test - reference| over all pixels and channels.";
    unit.blind_to = "everything but one value of one pixel.";
    unit.reported = false;
    unit.maximum = std::numeric_limits<double>::infinity();
    unit.best = 0.0;
    unit.parameters = describe_parameters("template_metric", {});
    unit.checks = {{"constants 100 and 151", [] { return make_constant(100); },
                    [] { return make_constant(151); }, 0.2, 1e-7, "by hand: 51 / 255"}};
    unit.create = [](const ResolvedParameters&) { return std::make_unique<LargestDifference>(); };
    return unit;
}

} // namespace alcove
