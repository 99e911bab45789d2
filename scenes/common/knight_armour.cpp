#include "scenes/common/figure_shapes.hpp"
#include "scenes/common/knight.hpp"
#include "scenes/common/solids.hpp"
#include "scenes/common/thin_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/common.hpp>

namespace alcove {
namespace {

constexpr glm::vec3 kSteel(0.5f, 0.51f, 0.53f);
constexpr glm::vec3 kDarkSteel(0.34f, 0.35f, 0.37f);
constexpr glm::vec3 kLeather(0.24f, 0.15f, 0.09f);
constexpr glm::vec3 kBrass(0.6f, 0.45f, 0.2f);
constexpr double kCrease = 48.0; ///< degrees; sharper edges stay edges

int scale(int at_one, double detail, int minimum) {
    return std::max(minimum, static_cast<int>(std::lround(at_one * std::sqrt(detail))));
}

/// A great helm: a face with a ridge in front and a slit to see through.
MeshBuilder make_helmet(int around, int steps) {
    constexpr double kSlitLow = 0.155;
    constexpr double kSlitHigh = 0.172;
    constexpr double kSlitDepth = 0.014;
    std::vector<Slice> low = smooth_slices({{-0.035, 0.085, 0.09, 0.02},
                                            {0.0, 0.1, 0.092, 0.022},
                                            {0.08, 0.122, 0.1, 0.025},
                                            {kSlitLow, 0.127, 0.103, 0.02}},
                                           steps);
    const std::vector<Slice> high = smooth_slices({{kSlitHigh, 0.127, 0.103, 0.02},
                                                   {0.22, 0.12, 0.1, 0.014},
                                                   {0.275, 0.095, 0.083, 0.004},
                                                   {0.31, 0.055, 0.05, 0.0},
                                                   {0.325, 0.02, 0.02, 0.0}},
                                                  steps);
    std::vector<Ring> rings;
    const auto add_ring = [&](const Slice& slice, double inset) {
        Ring ring;
        for (int i = 0; i < around; ++i) {
            const double angle = -2.0 * std::numbers::pi * i / around;
            const double front = std::max(0.0, std::cos(angle));
            const double ridge = 0.022 * std::pow(front, 6.0);
            const double slit = inset * glm::smoothstep(0.42, 0.55, front);
            ring.emplace_back(slice.shift + (slice.along + ridge - slit) * std::cos(angle), slice.y,
                              (slice.across - slit) * std::sin(angle));
        }
        rings.push_back(std::move(ring));
    };
    for (const Slice& slice : low) {
        add_ring(slice, 0.0);
    }
    Slice edge = low.back();
    edge.y += 0.002;
    add_ring(edge, kSlitDepth);
    edge = high.front();
    edge.y -= 0.002;
    add_ring(edge, kSlitDepth);
    for (const Slice& slice : high) {
        add_ring(slice, 0.0);
    }
    MeshBuilder builder;
    add_loft(builder, rings, LoftEnds::capped);
    return builder;
}

/// A comb of hair from brow to nape.
MeshBuilder make_crest(int around, int rows) {
    std::vector<Ring> rings;
    for (int i = 0; i <= rows; ++i) {
        const double s = static_cast<double>(i) / rows;
        const double angle = std::numbers::pi * (0.27 + 0.66 * s); // from ahead over the top
        const double high = 0.012 + 0.055 * std::sin(std::numbers::pi * std::min(1.0, s * 1.15));
        const glm::dvec3 out(std::cos(angle), std::sin(angle), 0.0);
        const glm::dvec3 root = glm::dvec3(0.005, 0.18, 0.0) + 0.125 * out;
        Ring ring;
        for (int k = 0; k < around; ++k) {
            const double turn = 2.0 * std::numbers::pi * k / around;
            ring.push_back(root + (0.5 * high * (1.0 + std::cos(turn)) - 0.012) * out +
                           glm::dvec3(0.0, 0.0, -0.017 * std::sin(turn)));
        }
        rings.push_back(std::move(ring));
    }
    MeshBuilder builder;
    add_loft(builder, rings, LoftEnds::capped);
    return builder;
}

MeshBuilder make_breastplate(int around, int steps) {
    MeshBuilder builder;
    add_limb(builder,
             smooth_slices({{0.12, 0.118, 0.158},
                            {0.15, 0.128, 0.168, 0.004},
                            {0.28, 0.148, 0.183, 0.008},
                            {0.38, 0.155, 0.2, 0.012},
                            {0.45, 0.14, 0.195, 0.008},
                            {0.5, 0.115, 0.165, 0.003},
                            {0.525, 0.085, 0.11, 0.0}},
                           steps),
             around);
    return builder;
}

MeshBuilder make_belt(int around) {
    MeshBuilder builder;
    add_limb(builder,
             {{0.062, 0.14, 0.18, 0.01},
              {0.068, 0.152, 0.192, 0.01},
              {0.108, 0.149, 0.189, 0.01},
              {0.114, 0.135, 0.175, 0.01}},
             around);
    return builder;
}

/// Three lames over the shoulder, each a step wider.
MeshBuilder make_pauldron(int around, int steps, double outward) {
    const double a = 0.012 * outward;
    std::vector<Slice> slices{{-0.15, 0.07, 0.068, 0.0, a}};
    const std::vector<std::vector<Slice>> lames{
        {{-0.148, 0.083, 0.08, 0.0, a}, {-0.08, 0.088, 0.084, 0.0, a}},
        {{-0.076, 0.096, 0.091, 0.0, a}, {-0.02, 0.1, 0.094, 0.0, a}},
        {{-0.016, 0.107, 0.1, 0.0, a},
         {0.03, 0.098, 0.09, 0.0, a},
         {0.055, 0.073, 0.067, 0.0, a},
         {0.068, 0.03, 0.028, 0.0, a}}};
    for (const std::vector<Slice>& lame : lames) {
        const std::vector<Slice> curve = smooth_slices(lame, steps);
        slices.insert(slices.end(), curve.begin(), curve.end());
    }
    MeshBuilder builder;
    add_limb(builder, slices, around);
    return builder;
}

/// Cuff, fist and elbow.
MeshBuilder make_gauntlet(int around, int steps) {
    MeshBuilder builder;
    add_limb(builder,
             smooth_slices({{-0.375, 0.02, 0.015, 0.012},
                            {-0.36, 0.045, 0.035, 0.01},
                            {-0.32, 0.052, 0.042, 0.008},
                            {-0.28, 0.04, 0.036, 0.0},
                            {-0.25, 0.043, 0.042, 0.0}},
                           steps),
             around);
    add_limb(builder,
             {{-0.262, 0.046, 0.046},
              {-0.15, 0.066, 0.064},
              {-0.14, 0.068, 0.066},
              {-0.135, 0.05, 0.048}},
             around);
    add_ellipsoid(builder, {-0.008, 0.0, 0.0}, {0.066, 0.07, 0.06}, around);
    return builder;
}

MeshBuilder make_greave(int around, int steps) {
    MeshBuilder builder;
    add_limb(builder,
             smooth_slices({{-0.405, 0.05, 0.047},
                            {-0.38, 0.051, 0.048},
                            {-0.28, 0.058, 0.054, -0.006},
                            {-0.17, 0.071, 0.064, -0.012},
                            {-0.08, 0.066, 0.062, -0.006},
                            {-0.05, 0.068, 0.063, -0.002}},
                           steps),
             around);
    add_ellipsoid(builder, {0.012, 0.0, 0.0}, {0.074, 0.08, 0.07}, around);
    return builder;
}

MeshBuilder make_boot(int around, int steps, double ankle) {
    MeshBuilder builder;
    add_limb(builder,
             smooth_slices({{-ankle, 0.128, 0.044, 0.055},
                            {-ankle + 0.012, 0.138, 0.052, 0.058},
                            {-0.055, 0.128, 0.053, 0.05},
                            {-0.025, 0.09, 0.051, 0.02},
                            {0.01, 0.062, 0.05, 0.0},
                            {0.06, 0.054, 0.05, -0.005}},
                           steps),
             around);
    return builder;
}

MeshBuilder make_blade(double length) {
    const auto make_ring = [](double x, double wide, double thick) {
        // Counter-clockwise seen from the tip: y cross z is x.
        return Ring{{x, wide, 0.0}, {x, 0.0, thick}, {x, -wide, 0.0}, {x, 0.0, -thick}};
    };
    MeshBuilder builder;
    add_loft(builder,
             {make_ring(0.05, 0.026, 0.006), make_ring(0.86 * length, 0.02, 0.005),
              make_ring(length, 0.002, 0.001)},
             LoftEnds::capped);
    return builder;
}

MeshBuilder make_hilt(int around) {
    MeshBuilder builder;
    add_tube(builder, {{{0.05, -0.11, 0.0}, 0.01}, {{0.05, 0.11, 0.0}, 0.01}}, around);
    add_tube(builder, {{{-0.1, 0.0, 0.0}, 0.013}, {{0.055, 0.0, 0.0}, 0.014}}, around);
    add_ellipsoid(builder, {-0.115, 0.0, 0.0}, {0.024, 0.026, 0.018}, around);
    return builder;
}

/// A shield like a flat iron, bent around its long axis; its front looks to -z.
Mesh make_shield(int columns, int rows, const glm::vec3& colour) {
    const ThinSheet sheet(columns, rows, 0.014);
    std::vector<glm::dvec3> middle;
    for (int row = 0; row <= rows; ++row) {
        const double v = static_cast<double>(row) / rows;
        const double half = 0.235 * std::sqrt(std::max(0.0025, 1.0 - std::pow(v, 2.6)));
        for (int column = 0; column <= columns; ++column) {
            const double u = 1.0 - 2.0 * column / columns; // from +x: the front looks to -z
            const double x = half * u;
            const double z = 1.1 * x * x - 0.09;
            middle.emplace_back(x, 0.3 - 0.66 * v, z);
        }
    }
    return sheet.make_mesh("shield", colour, middle);
}

/// `builder` with all points moved.
MeshBuilder move_solid(const MeshBuilder& builder, const glm::dmat4& transform) {
    MeshBuilder moved;
    for (const glm::dvec3& point : builder.points()) {
        moved.add_point(glm::dvec3(transform * glm::dvec4(point, 1.0)));
    }
    for (const auto& [a, b, c] : builder.triangles()) {
        moved.add_triangle(a, b, c);
    }
    return moved;
}

/// In the forearm's space: lies forward in the fist, tip raised.
glm::dmat4 make_grip(double radians) {
    glm::dmat4 grip(1.0);
    grip[0] = {std::cos(radians), std::sin(radians), 0.0, 0.0};
    grip[1] = {-std::sin(radians), std::cos(radians), 0.0, 0.0};
    grip[3] = {0.01, -0.325, 0.0, 1.0};
    return grip;
}

} // namespace

std::vector<KnightPlate> make_knight_plates(double detail, const glm::vec3& colour) {
    const auto around = [detail](int at_one) { return scale(at_one, detail, 8); };
    const int steps = scale(4, detail, 1);
    std::vector<KnightPlate> plates;
    const auto add = [&plates](const MeshBuilder& builder, const char* name,
                               const glm::vec3& albedo, Limb limb) {
        plates.push_back({builder.finish(name, albedo, kCrease), limb});
    };
    const double ankle = get_knight_body().ankle;
    add(make_helmet(around(56), steps), "helmet", kSteel, kHead);
    add(make_crest(around(12), scale(24, detail, 6)), "crest", colour, kHead);
    add(make_breastplate(around(52), steps), "breastplate", kSteel, kTorso);
    add(make_belt(around(40)), "belt", kLeather, kTorso);
    for (std::size_t side = 0; side < 2; ++side) {
        const auto pick = [side](Limb left) { return static_cast<Limb>(left + side); };
        add(make_pauldron(around(36), scale(3, detail, 1), side == 0 ? -1.0 : 1.0), "pauldron",
            kSteel, pick(kUpperArm));
        add(make_gauntlet(around(24), scale(3, detail, 1)), "gauntlet", kDarkSteel, pick(kForearm));
        add(make_greave(around(28), scale(3, detail, 1)), "greave", kSteel, pick(kShin));
        add(make_boot(around(32), scale(3, detail, 1), ankle), "boot", kDarkSteel, pick(kFoot));
    }
    const auto sword_arm = static_cast<Limb>(kForearm + 1);
    const glm::dmat4 grip = make_grip(0.12);
    add(move_solid(make_blade(0.88), grip), "blade", {0.62f, 0.63f, 0.65f}, sword_arm);
    add(move_solid(make_hilt(around(16)), grip), "hilt", kBrass, sword_arm);
    // The forearm lies forward: its -y axis is ahead, so that the shield stands upright when its
    // own y axis is the forearm's x axis.
    Mesh shield = make_shield(scale(20, detail, 6), scale(28, detail, 8), colour);
    for (std::vector<glm::vec3>* vectors : {&shield.positions, &shield.normals}) {
        for (glm::vec3& v : *vectors) {
            v = {v.y, -v.x, v.z};
        }
    }
    for (glm::vec3& position : shield.positions) {
        position.y -= 0.18f;
    }
    plates.push_back({std::move(shield), kForearm});
    return plates;
}

} // namespace alcove
