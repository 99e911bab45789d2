// This work is based on: Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild. FLIP: A
// Difference Evaluator for Alternating Images. 2020; version 1.6.
#include "metrics/flip/flip.hpp"

#include "metrics/common/flip_colour.hpp"
#include "metrics/common/flip_map.hpp"
#include "metrics/common/flip_pooling.hpp"
#include "metrics/common/flip_viewing.hpp"
#include "metrics/common/test_images.hpp"

namespace alcove {
namespace {

void decode_planes(const std::array<float*, 3>& planes, std::size_t count) {
    for (float* plane : planes) {
        if (plane != nullptr) {
            decode_codes(plane, count);
        }
    }
}

class Flip final : public Metric {
  public:
    explicit Flip(double ppd) : m_ppd(ppd) {}

    MetricResult evaluate(const MetricInput& input) const override {
        check_metric_input(input, "flip");
        return pool_flip_map(compute_flip_map(input.test, input.reference, m_ppd, decode_planes),
                             input.mask);
    }

  private:
    double m_ppd;
};

/// Means of the published implementation moved by up to 1.4e-5 between its own builds.
constexpr double kTolerance = 2e-5;

std::vector<MetricCheck> list_checks() {
    const char* const source = "NVIDIA FLIP.h 1.6, g++ -O2, 67.020645 pixels a degree";
    const auto constant = [](int r, int g, int b) { return [=] { return make_colour(r, g, b); }; };
    return {
        {"black, white", constant(0, 0, 0), constant(255, 255, 255), 0.967388, kTolerance, source},
        {"green, blue", constant(0, 255, 0), constant(0, 0, 255), 1.0, kTolerance,
         "by definition: the largest distance; and " + std::string(source)},
        {"red, green", constant(255, 0, 0), constant(0, 255, 0), 0.986665, kTolerance, source},
        {"codes 128, 136", constant(128, 128, 128), constant(136, 136, 136), 0.127591, kTolerance,
         source},
        {"codes 128, 129", constant(128, 128, 128), constant(129, 129, 129), 0.029863, kTolerance,
         source},
        {"codes 128, 136 of grey", [] { return make_constant(128); },
         [] { return make_constant(136); }, 0.127591, kTolerance, source},
        {"black, one white pixel", [] { return make_constant(0); }, make_firefly, 0.003493,
         kTolerance, source},
        {"step at 32, step at 33", [] { return make_step(32); }, [] { return make_step(33); },
         0.0517, 5e-5 + kTolerance, std::string(source) + ", printed to 4 digits"},
        {"checkerboard, code 188", make_checkerboard, [] { return make_constant(188); }, 0.019631,
         kTolerance, source},
        {"colour ramp against noise", make_colour_ramp, [] { return make_noisy_colour_ramp(8); },
         0.053097, kTolerance, source},
        {"0.099975586, 0.89990234 of linear light", [] { return make_encoded(0.099975586f); },
         [] { return make_encoded(0.89990234f); }, 0.951377, kTolerance,
         "NVIDIA FLIP.h 1.6 (0.951377) and OpenImageIO's test suite (0.9514)"},
    };
}

} // namespace

MetricUnit flip_unit() {
    MetricUnit unit;
    unit.name = "flip";
    unit.title = "FLIP (difference seen when flipping)";
    unit.unit = "1";
    unit.definition =
        "Andersson et al. 2020, version 1.6, on the view (sRGB codes in [0,1], decoded to linear "
        "light; grey = equal channels): contrast sensitivity filters in YCxCz, clamp to linear RGB "
        "in [0,1], Hunt-adjusted CIELab, HyAB^0.7 mapped so that 0.4 of the largest is 0.95; edges "
        "and points of luminance 0.082 degrees wide; colour error^(1 - feature error). Borders "
        "repeat. Mean over pixels, summed in double. Extras: weighted median and quartiles (100 "
        "bins), min, max.";
    unit.blind_to = "what stays below an eye's resolution at this distance, differences of "
                    "radiance that a display clips, and whatever moves; a mean hides few large "
                    "errors: see the weighted quartiles.";
    unit.domain = MetricDomain::view;
    unit.minimum = 0.0;
    unit.maximum = 1.0;
    unit.best = 0.0;
    unit.parameters = describe_parameters(
        "flip", {declare_distance<FlipViewing>(), declare_monitor_width<FlipViewing>(),
                 declare_monitor_pixels<FlipViewing>(), declare_ppd<FlipViewing>()});
    unit.checks = list_checks();
    unit.create = [table = unit.parameters](const ResolvedParameters& resolved) {
        return std::make_unique<Flip>(table.bind<FlipViewing>(resolved).ppd);
    };
    return unit;
}

} // namespace alcove
