#include "scenes/common/round_solids.hpp"
#include "scenes/common/solids.hpp"
#include "scenes/foliage_and_vehicle/elements.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

namespace alcove::foliage {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kAxleX = 1.32;
constexpr double kTrackZ = 0.76; ///< middle of a wheel

/// A section of a body across its length.
struct Section {
    double x = 0.0;
    double low = 0.0;
    double high = 0.0;
    double half = 0.0; ///< width to each side, at its lower end
};

/// Rounded boxes along x, narrower by `taper` of their width at the top. Straight between sections.
void add_body(MeshBuilder& builder, const std::vector<Section>& sections, double taper,
              const Settings& settings) {
    const int around = 4 * settings.segments(7);
    std::vector<Ring> rings;
    for (const Section& section : sections) {
        Ring ring;
        for (int i = 0; i < around; ++i) {
            const double angle = 2.0 * kPi * (i + 0.5) / around;
            // A superellipse of exponent 5, seen from +x: z to the left.
            const auto round = [](double value) {
                return std::copysign(std::pow(std::abs(value), 0.4), value);
            };
            const double up = 0.5 * (1.0 + round(std::sin(angle)));
            const double side = section.half * (1.0 - taper * up) * round(std::cos(angle));
            ring.emplace_back(section.x, section.low + up * (section.high - section.low), -side);
        }
        rings.push_back(std::move(ring));
    }
    add_loft(builder, rings, LoftEnds::capped);
}

/// Sections between the given ones, on a smooth curve.
std::vector<Section> refine(const std::vector<Section>& sections, int steps) {
    std::vector<Section> fine;
    for (std::size_t i = 0; i + 1 < sections.size(); ++i) {
        const Section& a = sections[i == 0 ? 0 : i - 1];
        const Section& b = sections[i];
        const Section& c = sections[i + 1];
        const Section& d = sections[std::min(i + 2, sections.size() - 1)];
        for (int k = 0; k < steps; ++k) {
            const double s = static_cast<double>(k) / steps;
            const auto mix = [&](double Section::*f) { // Catmull-Rom, uniform knots
                return 0.5 * (2.0 * b.*f + (c.*f - a.*f) * s +
                              (2.0 * a.*f - 5.0 * b.*f + 4.0 * c.*f - d.*f) * s * s +
                              (3.0 * b.*f - a.*f - 3.0 * c.*f + d.*f) * s * s * s);
            };
            fine.push_back(
                {mix(&Section::x), mix(&Section::low), mix(&Section::high), mix(&Section::half)});
        }
    }
    fine.push_back(sections.back());
    return fine;
}

void add_disk(MeshBuilder& builder, const glm::dvec3& centre, double half, double radius,
              int around) {
    const glm::dvec3 push(0.0, 0.0, half);
    add_tube(builder, {centre - push, centre + push}, {radius, radius}, around);
}

Mesh make_paint(const Settings& settings) {
    MeshBuilder builder;
    const int steps = settings.segments(2);
    add_body(builder,
             refine({{-2.16, 0.46, 0.74, 0.6},
                     {-2.1, 0.34, 0.86, 0.76},
                     {-1.85, 0.27, 0.94, 0.83},
                     {-1.2, 0.24, 0.97, 0.86},
                     {0.0, 0.22, 0.96, 0.86},
                     {0.9, 0.22, 0.93, 0.86},
                     {1.6, 0.26, 0.83, 0.83},
                     {2.0, 0.32, 0.72, 0.76},
                     {2.14, 0.42, 0.62, 0.62}},
                    steps),
             0.06, settings);
    // Roof, above the glass.
    add_body(builder,
             refine({{-1.2, 1.36, 1.405, 0.5},
                     {-1.05, 1.38, 1.46, 0.56},
                     {-0.45, 1.42, 1.52, 0.57},
                     {0.05, 1.4, 1.49, 0.56},
                     {0.2, 1.38, 1.43, 0.5}},
                    steps),
             0.05, settings);
    const int around = settings.segments(6);
    for (const double side : {-1.0, 1.0}) { // posts
        const auto post = [&](const glm::dvec3& foot, const glm::dvec3& head) {
            add_tube(builder, {{foot.x, foot.y, side * foot.z}, {head.x, head.y, side * head.z}},
                     {0.045, 0.04}, around);
        };
        post({0.98, 0.88, 0.66}, {0.12, 1.43, 0.53});
        post({-0.4, 0.88, 0.71}, {-0.45, 1.45, 0.545});
        post({-1.62, 0.9, 0.66}, {-1.1, 1.42, 0.53});
        add_ball(builder, 2, [side](const glm::dvec3& d) { // mirror
            return glm::dvec3(0.72, 1.0, side * 0.86) + glm::dvec3(0.06, 0.07, 0.1) * d;
        });
    }
    return builder.finish("car paint", {0.6f, 0.12f, 0.1f}, 50.0);
}

Mesh make_glass(const Settings& settings) {
    MeshBuilder builder;
    add_body(builder,
             refine({{-1.78, 0.85, 0.94, 0.6},
                     {-1.5, 0.84, 1.16, 0.7},
                     {-1.05, 0.84, 1.39, 0.7},
                     {-0.45, 0.84, 1.45, 0.7},
                     {0.1, 0.84, 1.41, 0.7},
                     {0.65, 0.84, 1.14, 0.7},
                     {1.12, 0.84, 0.93, 0.62}},
                    settings.segments(2)),
             0.24, settings);
    return builder.finish("car glass", {0.1f, 0.13f, 0.16f}, 50.0);
}

/// What is black: underbody, wheel wells, grille.
Mesh make_dark(const Settings& settings) {
    MeshBuilder builder;
    add_box(builder, {-1.6, 0.17, -0.62}, {1.6, 0.3, 0.62});
    for (const double x : {-kAxleX, kAxleX}) {
        for (const double side : {-1.0, 1.0}) {
            add_disk(builder, {x, kWheel + 0.05, side * 0.74}, 0.125, kWheel + 0.035,
                     settings.segments(20));
        }
    }
    add_box(builder, {1.95, 0.4, -0.45}, {2.13, 0.52, 0.45});
    return builder.finish("car dark", glm::vec3(0.06f), 40.0);
}

Mesh make_lamps(const Settings& settings) {
    MeshBuilder builder;
    const int fine = settings.detail > 4.0 ? 3 : 2;
    for (const double side : {-1.0, 1.0}) {
        add_ball(builder, fine, [side](const glm::dvec3& d) {
            return glm::dvec3(2.0, 0.62, side * 0.56) + glm::dvec3(0.1, 0.08, 0.13) * d;
        });
        add_ball(builder, fine, [side](const glm::dvec3& d) {
            return glm::dvec3(-2.08, 0.72, side * 0.58) + glm::dvec3(0.06, 0.06, 0.12) * d;
        });
    }
    return builder.finish("car lamps", glm::vec3(0.75f), 180.0);
}

Mesh make_tyre(const Settings& settings) {
    MeshBuilder builder;
    const double r = kWheel;
    add_tube(builder,
             {{0.0, 0.0, -0.12},
              {0.0, 0.0, -0.1},
              {0.0, 0.0, -0.07},
              {0.0, 0.0, 0.07},
              {0.0, 0.0, 0.1},
              {0.0, 0.0, 0.12}},
             {0.84 * r, 0.95 * r, r, r, 0.95 * r, 0.84 * r}, settings.segments(24));
    return builder.finish("tyre", glm::vec3(0.08f), 40.0);
}

Mesh make_rim(const Settings& settings) {
    MeshBuilder builder;
    const int around = settings.segments(20);
    add_disk(builder, glm::dvec3(0.0), 0.123, 0.22, around);
    add_disk(builder, glm::dvec3(0.0), 0.15, 0.05, settings.segments(10));
    for (int i = 0; i < 5; ++i) {
        const double angle = 2.0 * kPi * i / 5;
        for (const double z : {-0.125, 0.125}) {
            add_tube(builder, {{0.0, 0.0, z}, {0.21 * std::cos(angle), 0.21 * std::sin(angle), z}},
                     {0.03, 0.02}, settings.segments(6));
        }
    }
    return builder.finish("rim", glm::vec3(0.6f), 40.0);
}

} // namespace

Car add_car(SceneKit& kit, const Settings& settings, double x) {
    // Tyres are 4 mm deep in the road: in contact, as by their load.
    const glm::dvec3 place(x, kRoad - 0.004, 0.5);
    Car car;
    for (Mesh& mesh : std::vector<Mesh>{make_paint(settings), make_glass(settings),
                                        make_dark(settings), make_lamps(settings)}) {
        car.bodies.push_back(kit.place(kit.add_mesh(std::move(mesh)), make_place(place)));
    }
    const std::size_t tyre = kit.add_mesh(make_tyre(settings));
    const std::size_t rim = kit.add_mesh(make_rim(settings));
    for (const double along : {-kAxleX, kAxleX}) {
        for (const double side : {-1.0, 1.0}) {
            const glm::dvec3 axle = place + glm::dvec3(along, kWheel, side * kTrackZ);
            car.wheels.push_back(
                {{kit.place(tyre, make_place(axle)), kit.place(rim, make_place(axle))}, axle});
        }
    }
    return car;
}

} // namespace alcove::foliage
