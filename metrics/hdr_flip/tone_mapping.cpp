// This work is based on: Andersson, Nilsson, Shirley, Akenine-Moller. Visualizing Errors in
// Rendered High Dynamic Range Images. 2021.
#include "metrics/hdr_flip/tone_mapping.hpp"

#include "core/base/domain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alcove {
namespace {

/// (a x^2 + b x + c) / (d x^2 + e x + f)
struct Curve {
    double a, b, c, d, e, f;
};

/// Narkowicz's fit of ACES with 0.6 of the light, Hable's curve with white at 11.2, x / (1 + x).
constexpr std::array<Curve, 3> kCurves{
    {{0.6 * 0.6 * 2.51, 0.6 * 0.03, 0.0, 0.6 * 0.6 * 2.43, 0.6 * 0.59, 0.14},
     {0.231683, 0.013791, 0.0, 0.18, 0.3, 0.018},
     {0.0, 1.0, 0.0, 0.0, 1.0, 1.0}}};

constexpr double kTarget = 0.85; ///< what exposures bring the largest and the median to

const Curve& get_curve(ToneMapper mapper) {
    return kCurves.at(static_cast<std::size_t>(mapper));
}

/// The light that is mapped to kTarget: the larger root of a quadratic.
double find_bright(const Curve& curve) {
    const double a = curve.a - kTarget * curve.d;
    const double b = curve.b - kTarget * curve.e;
    const double c = curve.c - kTarget * curve.f;
    if (a == 0.0) {
        return -c / b;
    }
    const double root = std::sqrt(b * b - 4.0 * a * c);
    return std::max((-b + root) / (2.0 * a), (-b - root) / (2.0 * a));
}

std::array<float, 6> get_single_precision(const Curve& curve) {
    return {static_cast<float>(curve.a), static_cast<float>(curve.b), static_cast<float>(curve.c),
            static_cast<float>(curve.d), static_cast<float>(curve.e), static_cast<float>(curve.f)};
}

} // namespace

ExposureRange find_exposures(const Image& reference, ToneMapper mapper) {
    const Image luminance = compute_luma(reference);
    std::vector<float> sorted(luminance.values().begin(), luminance.values().end());
    std::sort(sorted.begin(), sorted.end());
    // Of an even count the upper one, as published.
    const auto median = static_cast<double>(sorted[sorted.size() / 2]);
    const double least = static_cast<double>(std::numeric_limits<float>::epsilon());
    const double bright = find_bright(get_curve(mapper));
    return {std::log2(bright / std::max(static_cast<double>(sorted.back()), least)),
            std::log2(bright / std::max(median, least))};
}

std::vector<double> list_exposures(ExposureRange range) {
    const double stops = range.stop - range.start;
    const int count = std::max(2, static_cast<int>(std::ceil(stops)));
    std::vector<double> exposures;
    for (int i = 0; i < count; ++i) {
        exposures.push_back(range.start + stops * i / (count - 1));
    }
    return exposures;
}

void map_tones(const std::array<float*, 3>& planes, std::size_t count, double exposure,
               ToneMapper mapper) {
    const std::array<float, 6> k = get_single_precision(get_curve(mapper));
    const float gain = std::exp2(static_cast<float>(exposure));
    const bool is_grey = planes[1] == nullptr;
    for (std::size_t i = 0; i < count; ++i) {
        std::array<float, 3> light{};
        for (std::size_t p = 0; p < (is_grey ? 1u : 3u); ++p) {
            light[p] = gain * std::max(0.0f, planes[p][i]);
        }
        // Reinhard's operator divides by the luminance of all channels, the others work on each.
        const float luminance =
            is_grey ? light[0] : 0.2126f * light[0] + 0.7152f * light[1] + 0.0722f * light[2];
        for (std::size_t p = 0; p < (is_grey ? 1u : 3u); ++p) {
            const float x = light[p];
            const float mapped =
                mapper == ToneMapper::reinhard
                    ? x / (1.0f + luminance)
                    : (k[0] * x * x + k[1] * x + k[2]) / (k[3] * x * x + k[4] * x + k[5]);
            planes[p][i] = std::clamp(mapped, 0.0f, 1.0f);
        }
    }
}

} // namespace alcove
