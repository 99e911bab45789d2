// This work is based on: Andersson, Nilsson, Shirley, Akenine-Moller. Visualizing Errors in
// Rendered High Dynamic Range Images. 2021; version 1.6.
#include "metrics/hdr_flip/hdr_flip.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "metrics/common/flip_map.hpp"
#include "metrics/common/flip_pooling.hpp"
#include "metrics/common/flip_viewing.hpp"
#include "metrics/hdr_flip/tone_mapping.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alcove {
namespace {

constexpr double kAutomatic = std::numeric_limits<double>::infinity();

struct HdrFlipParams : FlipViewing {
    ToneMapper tone_mapper = ToneMapper::aces;
    double start_exposure = kAutomatic;
    double stop_exposure = kAutomatic;
};

class HdrFlip final : public Metric {
  public:
    explicit HdrFlip(const HdrFlipParams& params) : m_params(params) {}

    MetricResult evaluate(const MetricInput& input) const override {
        check_metric_input(input, "hdr_flip");
        const ExposureRange range = choose_range(input.reference);
        const std::vector<double> exposures = list_exposures(range);
        Image worst(input.test.size(), 1);
        for (const double exposure : exposures) {
            const Image map =
                compute_flip_map(input.test, input.reference, m_params.ppd,
                                 [&](const std::array<float*, 3>& planes, std::size_t count) {
                                     map_tones(planes, count, exposure, m_params.tone_mapper);
                                 });
            for (std::size_t i = 0; i < worst.values().size(); ++i) {
                worst.values()[i] = std::max(worst.values()[i], map.values()[i]);
            }
        }
        MetricResult result = pool_flip_map(std::move(worst), input.mask);
        if (result.value) {
            result.extras.push_back({"start_exposure", range.start});
            result.extras.push_back({"stop_exposure", range.stop});
            result.extras.push_back({"exposures", static_cast<double>(exposures.size())});
        }
        return result;
    }

  private:
    [[nodiscard]] ExposureRange choose_range(const Image& reference) const {
        ExposureRange range = find_exposures(reference, m_params.tone_mapper);
        if (m_params.start_exposure != kAutomatic) {
            range.start = m_params.start_exposure;
        }
        if (m_params.stop_exposure != kAutomatic) {
            range.stop = m_params.stop_exposure;
        }
        if (range.start > range.stop) {
            throw InputError("hdr_flip", "start_exposure is above stop_exposure",
                             format_rounded(range.start) + " and " + format_rounded(range.stop),
                             "start_exposure <= stop_exposure");
        }
        return range;
    }

    HdrFlipParams m_params;
};

/// v = 2^((x - 64) / 8), colour (v, v / 2, v / 4 (y + 1) / 64), 128 x 64; in the test times 1.25
/// where x xor y is odd, else times 0.8.
Image make_radiance(bool is_test) {
    Image image({128, 64}, 3);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const double factor = !is_test ? 1.0 : ((x ^ y) & 1) != 0 ? 1.25 : 0.8;
            const double v = factor * std::exp2((x - 64) / 8.0);
            image.at(x, y, 0) = static_cast<float>(v);
            image.at(x, y, 1) = static_cast<float>(v / 2.0);
            image.at(x, y, 2) = static_cast<float>(v / 4.0 * (y + 1) / 64.0);
        }
    }
    return image;
}

ParameterBuilder declare_exposure(double HdrFlipParams::*field, const char* name,
                                  const char* meaning) {
    return real(field, name)
        .range(-64.0, 64.0)
        .may_be_infinite()
        .unit("stops")
        .meaning(meaning)
        .source("Andersson et al. 2021, section 4.2");
}

std::vector<MetricCheck> list_checks() {
    const char* const source = "NVIDIA FLIP.h 1.6, g++ -O2, 67.020645 pixels a degree";
    // Means of the published implementation moved by up to 1.4e-5 between its own builds.
    constexpr double kTolerance = 2e-5;
    // Constants whose second derivative rounding alone keeps from being 0: FLIP takes its square
    // root, so that the last bit of the tone-mapped value moves the mean by up to 8e-5.
    constexpr double kRoundingTolerance = 4e-5;
    const auto ramp = [&](const std::string& mapper, double expected) {
        return MetricCheck{"ramp of radiance, +25 % and -20 %, " + mapper,
                           [] { return make_radiance(true); },
                           [] { return make_radiance(false); },
                           expected,
                           kTolerance,
                           source,
                           {{"tone_mapper", mapper, Provenance::command_line}}};
    };
    return {
        ramp("aces", 0.058384),
        ramp("hable", 0.051980),
        ramp("reinhard", 0.046705),
        {"0.89990234 against 0.099975586",
         [] {
             return Image({64, 64}, 3, 0.89990234f);
         },
         [] {
             return Image({64, 64}, 3, 0.099975586f);
         },
         0.204462, kRoundingTolerance,
         std::string(source) + "; OpenImageIO's test suite: 0.2045; exact arithmetic 0.204427"}};
}

} // namespace

MetricUnit hdr_flip_unit() {
    MetricUnit unit;
    unit.name = "hdr_flip";
    unit.title = "HDR-FLIP (difference seen at the worst exposure)";
    unit.unit = "1";
    unit.definition =
        "Andersson et al. 2021, version 1.6, on linear radiance: of each pixel the largest FLIP "
        "over "
        "max(2, ceil(stop - start)) evenly spaced exposures, tone-mapped and clamped to [0,1]; "
        "start "
        "and stop bring the reference's largest and median luminance to 0.85 unless they are "
        "given. "
        "Mean over pixels, summed in double. Extras: those of flip, start_exposure, stop_exposure, "
        "exposures.";
    unit.blind_to =
        "what flip is blind to but for clipping; it asks how bad the worst exposure is, "
        "which nobody may choose; automatic exposures differ from frame to frame: pin "
        "them for a sequence.";
    unit.domain = MetricDomain::linear;
    unit.on_demand = true;
    unit.minimum = 0.0;
    unit.maximum = 1.0;
    unit.best = 0.0;
    unit.parameters = describe_parameters(
        "hdr_flip",
        {declare_distance<HdrFlipParams>(), declare_monitor_width<HdrFlipParams>(),
         declare_monitor_pixels<HdrFlipParams>(), declare_ppd<HdrFlipParams>(),
         choice(&HdrFlipParams::tone_mapper, "tone_mapper", {"aces", "hable", "reinhard"})
             .meaning("Curve from radiance to what a display shows.")
             .source("Andersson et al. 2021, section 4.1"),
         declare_exposure(&HdrFlipParams::start_exposure, "start_exposure",
                          "First exposure; inf: from the reference."),
         declare_exposure(&HdrFlipParams::stop_exposure, "stop_exposure",
                          "Last exposure; inf: from the reference.")});
    unit.checks = list_checks();
    unit.create = [table = unit.parameters](const ResolvedParameters& resolved) {
        return std::make_unique<HdrFlip>(table.bind<HdrFlipParams>(resolved));
    };
    return unit;
}

} // namespace alcove
