#include "metrics/band_profile/band_profile.hpp"

#include "metrics/common/pooled_region.hpp"
#include "metrics/common/test_images.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace alcove {
namespace {

constexpr int kLargestReach = 64;
/// Rows to each side of a kink, and to the next one.
constexpr std::size_t kSpan = 2;
constexpr std::size_t kApart = 3;

enum class Measure { ripple, bands, profile_error };

struct BandProfileParams {
    Measure measure = Measure::ripple;
    int reach = 6;
    double least_kink = 0.01;
};

ParameterTable describe() {
    using P = BandProfileParams;
    return describe_parameters(
        "band_profile",
        {choice(&P::measure, "measure", {"ripple", "bands", "profile_error"})
             .meaning("The value: the ripple, or one of the two others.")
             .source("ours"),
         integer(&P::reach, "reach")
             .range(1, kLargestReach)
             .unit("rows")
             .meaning("Rows to each side of which the mean is taken out of the profile: bands "
                      "wider than about twice that do not count.")
             .source("ours"),
         real(&P::least_kink, "least_kink")
             .range(1e-4, 1.0)
             .log_scale()
             .unit("value")
             .meaning("How much the profile's rise over two rows must change for `bands` to count "
                      "it.")
             .source("ours")});
}

/// Error of each row's mean, of the rows that hold a counted pixel.
std::vector<double> measure_profile(const MetricInput& input, const PooledRegion& region) {
    std::vector<double> profile;
    for (int y = 0; y < input.test.height(); ++y) {
        double sum = 0.0;
        int count = 0;
        for (int x = 0; x < input.test.width(); ++x) {
            if (region.is_counted(x, y)) {
                sum += static_cast<double>(input.test.at(x, y)) -
                       static_cast<double>(input.reference.at(x, y));
                ++count;
            }
        }
        if (count > 0) {
            profile.push_back(sum / count);
        }
    }
    return profile;
}

double compute_rms(const std::vector<double>& values) {
    double squares = 0.0;
    for (const double value : values) {
        squares += value * value;
    }
    return std::sqrt(squares / static_cast<double>(values.size()));
}

/// Less its mean over `reach` rows to each side; cut off where those are missing.
std::vector<double> subtract_means(const std::vector<double>& profile, std::size_t reach) {
    std::vector<double> fine;
    for (std::size_t y = reach; y + reach < profile.size(); ++y) {
        double sum = 0.0;
        for (std::size_t i = y - reach; i <= y + reach; ++i) {
            sum += profile[i];
        }
        fine.push_back(profile[y] - sum / static_cast<double>(2 * reach + 1));
    }
    return fine;
}

double count_kinks(const std::vector<double>& profile, double least) {
    std::vector<double> kinks(profile.size(), 0.0);
    for (std::size_t y = kSpan; y + kSpan < profile.size(); ++y) {
        kinks[y] = std::abs(profile[y + kSpan] - 2.0 * profile[y] + profile[y - kSpan]);
    }
    double count = 0.0;
    for (std::size_t y = 0; y < kinks.size(); ++y) {
        const std::size_t first = y < kApart ? 0 : y - kApart;
        const std::size_t end = std::min(kinks.size(), y + kApart + 1);
        // Of equal ones the first counts.
        const auto top = std::max_element(kinks.begin() + static_cast<std::ptrdiff_t>(first),
                                          kinks.begin() + static_cast<std::ptrdiff_t>(end));
        count +=
            kinks[y] >= least && static_cast<std::size_t>(top - kinks.begin()) == y ? 1.0 : 0.0;
    }
    return count;
}

class BandProfile final : public Metric {
  public:
    explicit BandProfile(const BandProfileParams& params) : m_params(params) {}

    MetricResult evaluate(const MetricInput& input) const override {
        check_metric_input(input, "band_profile");
        ALCOVE_ASSERT(input.test.channels() == 1, "luma");
        const PooledRegion region(input.mask, input.test.size());
        MetricResult result;
        region.report(result);
        if (region.count() == 0) {
            return result;
        }
        const std::vector<double> profile = measure_profile(input, region);
        const std::vector<double> fine =
            subtract_means(profile, static_cast<std::size_t>(m_params.reach));
        if (fine.empty()) {
            result.undefined_reason = "fewer rows than twice the reach and one";
            return result;
        }
        const double ripple = compute_rms(fine);
        const double bands = count_kinks(profile, m_params.least_kink);
        const double error = compute_rms(profile);
        result.value = m_params.measure == Measure::ripple  ? ripple
                       : m_params.measure == Measure::bands ? bands
                                                            : error;
        result.extras = {{"ripple", ripple}, {"bands", bands}, {"profile_error", error}};
        return result;
    }

  private:
    BandProfileParams m_params;
};

constexpr int kPeriod = 4; ///< rows of a check's wave

Image make_wave() {
    Image image = make_constant(128);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            image.at(x, y) +=
                0.1f * static_cast<float>(std::sin(2.0 * std::numbers::pi * y / kPeriod));
        }
    }
    return image;
}

/// Of a wave 0, 0.1, 0, -0.1 over the 52 rows 6..57 of 64: means over 13 rows hold three whole
/// periods and the row six below, which is the row two below: minus the row itself. So what is left
/// is 14 / 13 of the wave, whose squares are 0.01 in every second row.
double compute_wave_by_hand() {
    return 0.1 * (14.0 / 13.0) * std::sqrt(0.5);
}

/// Flat to row 16, rises by 0.02 a row to row 32, by 0.01 to row 48, flat behind.
Image make_rises() {
    Image image = make_constant(0);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            image.at(x, y) = 0.02f * static_cast<float>(std::clamp(y - 16, 0, 16)) +
                             0.01f * static_cast<float>(std::clamp(y - 32, 0, 16));
        }
    }
    return image;
}

Image make_smooth(ImageSize size) {
    Image image(size, 1);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            image.at(x, y) = 0.3f + 0.4f * static_cast<float>(y) / static_cast<float>(size.height);
        }
    }
    return image;
}

/// Bands of three rows.
Image add_bands(const Image& reference, float amount) {
    Image image = reference;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            for (int c = 0; c < image.channels(); ++c) {
                image.at(x, y, c) += y / 3 % 2 == 0 ? amount : 0.0f;
            }
        }
    }
    return image;
}

} // namespace

MetricUnit band_profile_unit() {
    MetricUnit unit;
    unit.name = "band_profile";
    unit.title = "Bands along rows";
    unit.unit = "value";
    unit.definition =
        "Ours, on linear values (Rec. 709 luma of colour). e(y) = mean over a row's pixels of "
        "test - reference. ripple: RMS of e less its mean over `reach` rows to each side. bands: "
        "places, at least 4 rows apart, where |e(y + 2) - 2 e(y) + e(y - 2)| is the largest around "
        "and least_kink or more. profile_error: RMS of e. The value is the one that `measure` "
        "names.";
    unit.blind_to = "bands that do not run along rows, or are wider than twice the reach, and "
                    "noise, which a row's mean takes out.";
    unit.luma = true;
    unit.on_demand = true;
    unit.smallest_side = 2 * BandProfileParams{}.reach + 1;
    unit.maximum = std::numeric_limits<double>::infinity();
    unit.best = 0.0;
    unit.parameters = describe();
    unit.canary = MetricCanary{make_smooth, add_bands};
    const std::vector<ParameterOverride> bands{{"measure", "bands"}};
    unit.checks = {
        {"a wave of 4 rows", make_wave, [] { return make_constant(128); }, compute_wave_by_hand(),
         1e-7, "by hand: 14 / 13 of the wave"},
        {"a constant error", [] { return make_constant(100); }, [] { return make_constant(151); },
         0.0, 1e-12, "by design: a level has no bands"},
        {"three rises", make_rises, [] { return make_constant(0); }, 3.0, 1e-12,
         "by hand: the profile's rise changes at rows 16, 32 and 48", bands},
    };
    unit.create = [table = unit.parameters](const ResolvedParameters& parameters) {
        return std::make_unique<BandProfile>(table.bind<BandProfileParams>(parameters));
    };
    return unit;
}

} // namespace alcove
