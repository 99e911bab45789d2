#include "tests/methods/analytic_occlusion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

/// Integral of sqrt(1 - x^2).
double integrate_half_disc(double x) {
    return 0.5 * (x * std::sqrt(std::max(0.0, 1.0 - x * x)) + std::asin(x));
}

} // namespace

double compute_falloff(Falloff falloff, double relative) {
    switch (falloff) {
    case Falloff::none:
        return 1.0;
    case Falloff::linear:
        return 1.0 - relative;
    case Falloff::quadratic:
        break;
    }
    return 1.0 - relative * relative;
}

double integrate_hemisphere(const std::function<double(const glm::dvec3&)>& blocked,
                            Weighting weighting, int steps) {
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double u = (i + 0.5) / steps;
        const double z = weighting == Weighting::cosine ? std::sqrt(1.0 - u) : u;
        const double horizontal = std::sqrt(1.0 - z * z);
        for (int j = 0; j < steps; ++j) {
            const double azimuth = 2.0 * std::numbers::pi * (j + 0.5) / steps;
            sum += blocked({horizontal * std::cos(azimuth), horizontal * std::sin(azimuth), z});
        }
    }
    return sum / (static_cast<double>(steps) * steps);
}

double compute_wall_occlusion(double k, Weighting weighting) {
    if (k >= 1.0) {
        return 0.0;
    }
    if (weighting == Weighting::uniform) {
        return 0.5 * (1.0 - k);
    }
    return (std::acos(k) - k * std::sqrt(1.0 - k * k)) / std::numbers::pi;
}

double integrate_wall_occlusion(double k, Falloff falloff, Weighting weighting) {
    // x = k + (1 - k)(1 - s^2) takes the square root's steep end at x = 1 out of the integrand:
    // 1,000 midpoints are then good for seven digits.
    constexpr int kSteps = 1000;
    double sum = 0.0;
    for (int i = 0; i < kSteps && k < 1.0; ++i) {
        const double s = (i + 0.5) / kSteps;
        const double x = k + (1.0 - k) * (1.0 - s * s);
        const double density =
            weighting == Weighting::uniform ? 0.5 : 2.0 / std::numbers::pi * std::sqrt(1.0 - x * x);
        sum += density * compute_falloff(falloff, k / x) * 2.0 * s * (1.0 - k);
    }
    return sum / kSteps;
}

double compute_two_walls_occlusion(double kx, double ky) {
    const double both = compute_wall_occlusion(kx, Weighting::cosine) +
                        compute_wall_occlusion(ky, Weighting::cosine);
    if (kx * kx + ky * ky >= 1.0) {
        return both;
    }
    const double end = std::sqrt(1.0 - ky * ky);
    const double shared = integrate_half_disc(end) - integrate_half_disc(kx) - ky * (end - kx);
    return both - shared / std::numbers::pi;
}

double compute_sphere_occlusion(const glm::dvec3& to_center, double sphere_radius) {
    const double distance = glm::length(to_center);
    const double sine = sphere_radius / distance;
    return sine * sine * to_center.z / distance;
}

} // namespace alcove
