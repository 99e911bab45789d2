// This work is based on: Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild. FLIP: A
// Difference Evaluator for Alternating Images. 2020.
#include "metrics/common/flip_filters.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace alcove {
namespace {

/// a sqrt(pi / b) exp(-pi^2 x^2 / b), x in degrees (Table 1 of the paper).
struct SensitivityTerm {
    double a;
    double b;
};
constexpr SensitivityTerm kAchromatic{1.0, 0.0047};
constexpr SensitivityTerm kRedGreen{1.0, 0.0053};
constexpr SensitivityTerm kBlueYellowWide{34.1, 0.04};
constexpr SensitivityTerm kBlueYellowNarrow{13.5, 0.025};

constexpr double kFeatureWidth_deg = 0.082; ///< of an edge or point: twice the Gaussian's sigma

/// Weights under this share of the centre's are left out: all of them together stay under 1e-8.
constexpr double kNegligible = 1e-9;

double compute_sigma_px(SensitivityTerm term, double ppd) {
    return std::sqrt(term.b / 2.0) / std::numbers::pi * ppd;
}

std::vector<double> sample_gaussian(double sigma_px, int radius) {
    std::vector<double> weights;
    for (int x = 0; x <= radius; ++x) {
        weights.push_back(std::exp(-0.5 * x * x / (sigma_px * sigma_px)));
    }
    return weights;
}

double sum_both_sides(const std::vector<double>& half) {
    double sum = half[0];
    for (std::size_t i = 1; i < half.size(); ++i) {
        sum += 2.0 * half[i];
    }
    return sum;
}

HalfFilter scale(const std::vector<double>& half, double factor) {
    HalfFilter filter;
    for (const double weight : half) {
        if (std::abs(weight) >= kNegligible * half[0]) {
            filter.weights.push_back(static_cast<float>(weight * factor));
        }
    }
    return filter;
}

/// A sum of separable terms; the square root of each term's weight goes to each axis.
std::vector<HalfFilter> make_channel(const std::vector<SensitivityTerm>& terms, double ppd,
                                     int radius) {
    std::vector<std::vector<double>> halves;
    std::vector<double> factors;
    double total = 0.0;
    for (const SensitivityTerm& term : terms) {
        halves.push_back(sample_gaussian(compute_sigma_px(term, ppd), radius));
        factors.push_back(term.a * std::sqrt(std::numbers::pi / term.b));
        const double sum = sum_both_sides(halves.back());
        total += factors.back() * sum * sum;
    }
    std::vector<HalfFilter> filters;
    for (std::size_t i = 0; i < terms.size(); ++i) {
        filters.push_back(scale(halves[i], std::sqrt(factors[i] / total)));
    }
    return filters;
}

/// In single precision throughout, as published: see FilterKind for why that shows.
void add_features(FlipFilters& filters, double ppd) {
    const float sigma = 0.5f * static_cast<float>(kFeatureWidth_deg) * static_cast<float>(ppd);
    const int radius = static_cast<int>(std::ceil(3.0f * sigma));
    float sum = 0.0f;
    float lobe = 0.0f;
    float positive = 0.0f;
    float negative = 0.0f;
    std::vector<float>& gaussian = filters.gaussian.weights;
    std::vector<float>& first = filters.first_derivative.weights;
    std::vector<float>& second = filters.second_derivative.weights;
    for (int x = -radius; x <= radius; ++x) {
        const auto place = static_cast<float>(x);
        const float weight = std::exp(-(place * place) / (2.0f * sigma * sigma));
        const float curvature = (place * place / (sigma * sigma) - 1.0f) * weight;
        sum += weight;
        (curvature > 0.0f ? positive : negative) += curvature;
        if (x >= 0) {
            lobe += place * weight;
            gaussian.push_back(weight);
            first.push_back(place * weight);
            second.push_back(curvature);
        }
    }
    for (std::size_t i = 0; i < gaussian.size(); ++i) {
        gaussian[i] /= sum;
        first[i] = lobe > 0.0f ? first[i] / lobe : 0.0f;
        second[i] /= second[i] > 0.0f ? positive : -negative;
    }
}

} // namespace

FlipFilters make_flip_filters(double pixels_per_degree) {
    const double ppd = pixels_per_degree;
    // Three sigma of the widest filter.
    const int radius = static_cast<int>(std::ceil(3.0 * compute_sigma_px(kBlueYellowWide, ppd)));
    FlipFilters filters;
    filters.achromatic = make_channel({kAchromatic}, ppd, radius).front();
    filters.red_green = make_channel({kRedGreen}, ppd, radius).front();
    std::vector<HalfFilter> both = make_channel({kBlueYellowWide, kBlueYellowNarrow}, ppd, radius);
    filters.blue_yellow_wide = std::move(both[0]);
    filters.blue_yellow_narrow = std::move(both[1]);
    add_features(filters, ppd);
    return filters;
}

} // namespace alcove
