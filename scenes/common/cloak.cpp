#include "scenes/common/cloak.hpp"

#include "scenes/common/split_mix.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace alcove {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kThickness = 0.008; ///< metres

/// A level section: an ellipse behind the walker, open in front.
struct Section {
    double v = 0.0;
    double y = 0.0;     ///< over the hips
    double x = 0.0;     ///< of the ellipse's middle
    double along = 0.0; ///< half axes
    double across = 0.0;
    double angle = 0.0; ///< from its middle behind to an edge, radians
};

/// Collar, over the shoulder plates, down behind the arms, and away from the heels.
constexpr std::array<Section, 7> kSections{{{0.0, 0.62, 0.005, 0.105, 0.105, 1.75},
                                            {0.07, 0.605, 0.0, 0.15, 0.2, 1.65},
                                            {0.15, 0.55, -0.01, 0.19, 0.335, 1.45},
                                            {0.3, 0.37, -0.04, 0.205, 0.39, 1.22},
                                            {0.55, 0.04, -0.09, 0.22, 0.42, 1.12},
                                            {0.78, -0.29, -0.15, 0.25, 0.45, 1.08},
                                            {1.0, -0.62, -0.22, 0.27, 0.48, 1.05}}};

/// Cubic Hermite with slopes of the parabola through three neighbours.
double interpolate(double v, double Section::*field) {
    const auto slope = [field](std::size_t i) {
        const std::size_t a = i == 0 ? 0 : i - 1;
        const std::size_t b = std::min(i + 1, kSections.size() - 1);
        const auto chord = [field](std::size_t from, std::size_t to) {
            return (kSections[to].*field - kSections[from].*field) /
                   (kSections[to].v - kSections[from].v);
        };
        if (a == i || b == i) {
            return chord(a, b);
        }
        const double before = kSections[i].v - kSections[a].v;
        const double after = kSections[b].v - kSections[i].v;
        return (chord(a, i) * after + chord(i, b) * before) / (before + after);
    };
    std::size_t i = 0;
    while (i + 2 < kSections.size() && v > kSections[i + 1].v) {
        ++i;
    }
    const double width = kSections[i + 1].v - kSections[i].v;
    const double s = (v - kSections[i].v) / width;
    const double s2 = s * s;
    const double s3 = s2 * s;
    return (2.0 * s3 - 3.0 * s2 + 1.0) * kSections[i].*field +
           (s3 - 2.0 * s2 + s) * width * slope(i) +
           (3.0 * s2 - 2.0 * s3) * kSections[i + 1].*field + (s3 - s2) * width * slope(i + 1);
}

int scale(int at_one, double detail, int minimum) {
    return std::max(minimum, static_cast<int>(std::lround(at_one * std::sqrt(detail))));
}

} // namespace

Cloak::Cloak(double detail, int seed, double hip_m)
    : m_sheet(scale(112, detail, 14), scale(118, detail, 12), kThickness) {
    SplitMix random(static_cast<std::uint64_t>(seed) * 2 + 1);
    const auto draw_phase = [&random] { return random.draw(0.0, kTurn); };
    // With the steps (2 a cycle, 8 in four), with the gait, and slower ones of the air.
    m_waves = {{0.030, -8, 7.0, 1.6, 1.3, 0.4},
               {0.022, -8, 11.0, -4.0, 1.6, draw_phase()},
               {0.020, -3, 9.0, 5.5, 1.4, draw_phase()},
               {0.014, -5, 15.0, 8.5, 1.8, draw_phase()},
               {0.040, -4, 1.6, 2.6, 2.0, 0.0}};
    // Seven columns draw a fold; without twice as many the fine ones are left out.
    const int folds = std::min(5 + random.draw_index(2), m_sheet.columns() / 7);
    const double fine = m_sheet.columns() < 14 * folds ? 0.0 : 0.3;
    const double fold_phase = draw_phase();
    const double fine_phase = draw_phase();
    for (int row = 0; row <= m_sheet.rows(); ++row) {
        const double v = static_cast<double>(row) / m_sheet.rows();
        m_rows.push_back({v, glm::smoothstep(0.1, 0.75, v)});
    }
    for (int column = 0; column <= m_sheet.columns(); ++column) {
        m_columns.push_back(2.0 * column / m_sheet.columns() - 1.0);
    }
    for (const Row& row : m_rows) {
        const Section section{row.v,
                              interpolate(row.v, &Section::y),
                              interpolate(row.v, &Section::x),
                              interpolate(row.v, &Section::along),
                              interpolate(row.v, &Section::across),
                              interpolate(row.v, &Section::angle)};
        const double deep = 0.004 + 0.044 * glm::smoothstep(0.08, 0.9, row.v);
        for (const double u : m_columns) {
            // Folds spread like a fan; a fine one lies beside each broad one.
            const double broad = std::numbers::pi * folds * u + fold_phase + 0.9 * row.v;
            const double fold = std::sin(broad) + fine * std::sin(2.0 * broad + fine_phase) +
                                0.25 * std::sin(0.5 * broad + fine_phase);
            const double lag = 0.03 * std::cos(broad) * row.free;
            const double angle = u * section.angle + lag;
            const glm::dvec3 outward(-std::cos(angle), 0.0, std::sin(angle));
            m_outward.push_back(outward);
            m_rest.push_back(glm::dvec3(section.x, hip_m + section.y, 0.0) +
                             glm::dvec3(section.along, 0.0, section.across) * outward +
                             deep * fold * outward +
                             glm::dvec3(0.0, 0.012 * row.free * std::sin(broad + 1.0), 0.0));
        }
    }
}

std::vector<glm::dvec3> Cloak::compute_middle(double cycles, const glm::dmat4& torso) const {
    struct Angle {
        double sine = 0.0;
        double cosine = 1.0;
    };
    // sin(row + column) by the sum of angles: sines of rows and columns only.
    std::vector<std::vector<Angle>> across(m_waves.size());
    for (std::size_t i = 0; i < m_waves.size(); ++i) {
        for (const double u : m_columns) {
            const double angle = m_waves[i].across * u;
            across[i].push_back({std::sin(angle), std::cos(angle)});
        }
    }
    const double gait = kTurn * cycles;
    std::vector<glm::dvec3> middle;
    middle.reserve(m_rest.size());
    std::vector<Angle> down(m_waves.size());
    for (const Row& row : m_rows) {
        for (std::size_t i = 0; i < m_waves.size(); ++i) {
            const Wave& wave = m_waves[i];
            const double angle = wave.down * row.v + wave.phase + gait * wave.frequency / kRepeat;
            const double amplitude = wave.amplitude * std::pow(row.v, wave.power) * row.free;
            down[i] = {amplitude * std::sin(angle), amplitude * std::cos(angle)};
        }
        // The hem lags behind the shoulders: sideways with the gait, forth and back with the steps.
        const double hang = row.free * row.v * row.v;
        const glm::dvec3 sway(-0.022 * hang * std::cos(2.0 * gait - 1.5 * row.v),
                              0.008 * hang * std::sin(2.0 * gait - 2.0 * row.v),
                              0.045 * hang * std::sin(gait - 1.2 * row.v));
        const double held = 1.0 - row.free;
        for (std::size_t column = 0; column < m_columns.size(); ++column) {
            const std::size_t point = middle.size();
            double push = 0.0;
            for (std::size_t i = 0; i < m_waves.size(); ++i) {
                const Angle& a = across[i][column];
                push += down[i].sine * a.cosine + down[i].cosine * a.sine;
            }
            const glm::dvec3& rest = m_rest[point];
            const glm::dvec3 carried(torso * glm::dvec4(rest, 1.0));
            // The hem keeps its height over the ground, but goes up and down with the shoulders.
            glm::dvec3 place = rest + held * (carried - rest);
            place.y += row.free * torso[3].y;
            middle.push_back(place + sway + push * m_outward[point]);
        }
    }
    return middle;
}

Mesh Cloak::make_mesh(std::string name, const glm::vec3& albedo) const {
    return m_sheet.make_mesh(std::move(name), albedo, compute_middle(0.0, glm::dmat4(1.0)));
}

Deformation Cloak::deform(double cycles, const glm::dmat4& torso) const {
    return m_sheet.wrap(compute_middle(cycles, torso));
}

} // namespace alcove
