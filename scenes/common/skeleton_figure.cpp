#include "scenes/common/skeleton_figure.hpp"

#include "scenes/common/figure_shapes.hpp"
#include "scenes/common/solids.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace alcove {
namespace {

constexpr glm::vec3 kBone(0.72f, 0.68f, 0.58f);
constexpr double kForearm_m = 0.25;

WalkerBody make_body() {
    WalkerBody body;
    body.hip = 0.88;
    body.thigh_length = 0.42;
    body.shin_length = 0.42;
    body.ankle = 0.07;
    body.shoulder = 0.49;
    body.neck = 0.55;
    body.half_shoulders = 0.19;
    body.cycle = 1.0;
    return body;
}

class BoneKit {
  public:
    BoneKit(double thickness_m, double detail)
        : m_radius(0.5 * thickness_m), m_scale(std::sqrt(detail)) {}

    [[nodiscard]] double radius() const { return m_radius; }
    [[nodiscard]] int count(int at_one, int minimum) const {
        return std::max(minimum, static_cast<int>(std::lround(at_one * m_scale)));
    }
    [[nodiscard]] int around(int at_one) const { return count(at_one, 6); }

    /// A long bone down from its joint, with knobs at both ends.
    void add_long_bone(MeshBuilder& builder, double length, double aside = 0.0,
                       double thin = 1.0) const {
        const double r = thin * m_radius;
        const std::vector<Slice> slices{{-length - 0.6 * r, 0.7 * r, 0.8 * r},
                                        {-length, 1.5 * r, 1.75 * r},
                                        {-0.93 * length, 1.3 * r, 1.4 * r},
                                        {-0.82 * length, r, r},
                                        {-0.5 * length, 0.92 * r, 0.92 * r},
                                        {-0.18 * length, r, r},
                                        {-0.07 * length, 1.3 * r, 1.35 * r},
                                        {0.0, 1.5 * r, 1.6 * r},
                                        {0.6 * r, 0.7 * r, 0.8 * r}};
        std::vector<Slice> placed = smooth_slices(slices, count(4, 1));
        for (Slice& slice : placed) {
            slice.aside += aside;
        }
        add_limb(builder, placed, around(16));
    }
    void add_curve(MeshBuilder& builder, const std::vector<glm::dvec3>& places, double from,
                   double to) const {
        std::vector<TubePoint> line;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const double s = static_cast<double>(i) / static_cast<double>(places.size() - 1);
            line.push_back({places[i], from + s * (to - from)});
        }
        add_tube(builder, line, around(10));
    }

  private:
    double m_radius;
    double m_scale;
};

/// Vertebrae, ribs, breastbone, collarbones and pelvis; zero is between the hips.
MeshBuilder make_trunk(const BoneKit& kit) {
    const WalkerBody& body = get_skeleton_body();
    const double r = kit.radius();
    MeshBuilder builder;
    constexpr int kVertebrae = 15;
    const double bottom = 0.06;
    const double pitch = (body.neck + 0.03 - bottom) / kVertebrae;
    const auto spine_x = [](double y) { // the bends of loin and chest
        return -0.045 - 0.025 * std::sin(2.0 * std::numbers::pi * (y - 0.12) / 0.62);
    };
    std::vector<Slice> spine;
    for (int i = 0; i < kVertebrae; ++i) {
        const double y = bottom + i * pitch;
        const double wide = 1.75 * r * (1.0 - 0.02 * i);
        for (const auto& [at, size] :
             {std::pair{0.05, 0.72}, std::pair{0.2, 1.0}, std::pair{0.55, 0.92},
              std::pair{0.75, 1.0}, std::pair{0.92, 0.72}}) {
            const double place = y + at * pitch;
            spine.push_back({place, size * wide, size * wide, spine_x(place)});
        }
    }
    add_limb(builder, spine, kit.around(14));
    for (int i = 0; i < kVertebrae; ++i) { // spines behind
        const double y = bottom + (i + 0.45) * pitch;
        kit.add_curve(
            builder,
            {{spine_x(y) - 0.8 * r, y, 0.0}, {spine_x(y) - 1.75 * r - 0.018, y - 0.012, 0.0}},
            0.5 * r, 0.3 * r);
    }
    constexpr int kRibs = 9;
    const int pieces = kit.count(26, 8);
    for (int i = 0; i < kRibs; ++i) {
        const double s = static_cast<double>(i) / (kRibs - 1); // from above
        const double y = 0.49 - 0.27 * s;
        const double wide = 0.075 + 0.065 * std::sin(std::numbers::pi * (0.18 + 0.62 * s));
        const double deep = 0.8 * wide;
        // The lowest ones end on the way to the breastbone.
        const double reach = i < 7 ? 0.96 : 0.96 - 0.2 * (i - 6);
        for (const double side : {-1.0, 1.0}) {
            std::vector<glm::dvec3> rib;
            for (int k = 0; k <= pieces; ++k) {
                const double angle = std::numbers::pi * reach * k / pieces;
                rib.emplace_back(spine_x(y) + deep * (1.0 - std::cos(angle)),
                                 y + 0.015 * std::sin(2.0 * angle) - 0.06 * angle / 3.14,
                                 side * wide * std::sin(angle));
            }
            kit.add_curve(builder, rib, 0.55 * r, 0.45 * r);
        }
    }
    add_tube(builder,
             {{{0.045, 0.475, 0.0}, 0.75 * r},
              {{0.07, 0.46, 0.0}, 1.2 * r},
              {{0.14, 0.3, 0.0}, 0.9 * r},
              {{0.155, 0.23, 0.0}, 0.45 * r}},
             kit.around(10));
    for (const double side : {-1.0, 1.0}) {
        kit.add_curve(builder,
                      {{0.05, 0.475, side * 0.01},
                       {0.06, 0.49, side * 0.06},
                       {0.03, 0.505, side * 0.12},
                       {0.015, body.shoulder + 0.012, side * (body.half_shoulders + 0.005)}},
                      0.7 * r, 0.7 * r);
        // Shoulder blade: a flat drop.
        add_ellipsoid(builder, {-0.1, 0.41, side * 0.105}, {0.35 * r + 0.002, 0.085, 0.05},
                      kit.around(16));
        kit.add_curve(builder,
                      {{-0.095, 0.455, side * 0.12},
                       {-0.05, 0.485, side * 0.165},
                       {0.015, body.shoulder, side * body.half_shoulders}},
                      0.6 * r, 0.8 * r);
        // Pelvis: a wing, its rim and the bone to sit on.
        std::vector<glm::dvec3> rim;
        for (int k = 0; k <= pieces; ++k) {
            const double angle = std::numbers::pi * (-0.1 + 1.0 * k / pieces);
            rim.emplace_back(-0.075 + 0.085 * (1.0 - std::cos(angle)),
                             0.02 + 0.07 * std::sin(angle),
                             side * (0.025 + 0.1 * std::sin(0.9 * angle + 0.25)));
        }
        kit.add_curve(builder, rim, 0.8 * r, 0.7 * r);
        add_ellipsoid(builder, {-0.02, 0.045, side * 0.09}, {0.075, 0.05, 0.3 * r + 0.004},
                      kit.around(16));
        kit.add_curve(builder,
                      {{0.06, 0.0, side * 0.012},
                       {0.03, -0.015, side * 0.05},
                       {0.0, 0.0, side * body.half_hips},
                       {-0.03, -0.06, side * 0.07},
                       {0.02, -0.07, side * 0.045},
                       {0.06, -0.03, side * 0.014}},
                      0.9 * r, 0.7 * r);
    }
    add_tube(builder,
             {{{-0.065, 0.09, 0.0}, 2.2 * r},
              {{-0.085, 0.03, 0.0}, 1.7 * r},
              {{-0.07, -0.03, 0.0}, 0.7 * r}},
             kit.around(12));
    return builder;
}

/// Zero is on top of the neck.
MeshBuilder make_skull(const BoneKit& kit) {
    MeshBuilder builder;
    const int around = kit.around(40);
    const int steps = kit.count(7, 2);
    std::vector<Ring> rings;
    for (const Slice& slice : smooth_slices({{0.055, 0.05, 0.045, -0.02},
                                             {0.07, 0.075, 0.058, -0.012},
                                             {0.1, 0.098, 0.068, 0.0},
                                             {0.14, 0.104, 0.075, -0.004},
                                             {0.18, 0.095, 0.073, -0.01},
                                             {0.215, 0.07, 0.055, -0.014},
                                             {0.232, 0.03, 0.025, -0.014}},
                                            steps)) {
        Ring ring;
        for (int i = 0; i < around; ++i) {
            const double angle = -2.0 * std::numbers::pi * i / around;
            // Eye sockets and the nose are hollows of the face.
            const auto hollow = [&](double y, double turn, double high, double wide) {
                const double a = (slice.y - y) / high;
                const double b = std::remainder(angle - turn, 2.0 * std::numbers::pi) / wide;
                return std::exp(-(a * a + b * b) * (a * a + b * b));
            };
            const double deep =
                0.032 * (hollow(0.128, 0.42, 0.022, 0.27) + hollow(0.128, -0.42, 0.022, 0.27)) +
                0.016 * hollow(0.09, 0.0, 0.016, 0.11);
            ring.emplace_back(slice.shift + (slice.along - deep) * std::cos(angle), slice.y,
                              (slice.across - deep) * std::sin(angle));
        }
        rings.push_back(std::move(ring));
    }
    add_loft(builder, rings, LoftEnds::capped);
    std::vector<TubePoint> jaw;
    const int pieces = kit.count(20, 8);
    for (int i = 0; i <= pieces; ++i) {
        const double angle = std::numbers::pi * (0.5 - 1.0 * i / pieces);
        const double front = std::cos(angle);
        jaw.push_back({{-0.015 + 0.1 * front, 0.075 - 0.055 * std::min(1.0, 1.8 * front),
                        0.052 * std::sin(angle)},
                       0.011 + 0.004 * front});
    }
    add_tube(builder, jaw, kit.around(10));
    add_tube(builder, // teeth
             {{{0.055, 0.05, -0.03}, 0.008},
              {{0.08, 0.052, -0.016}, 0.01},
              {{0.087, 0.053, 0.0}, 0.01},
              {{0.08, 0.052, 0.016}, 0.01},
              {{0.055, 0.05, 0.03}, 0.008}},
             kit.around(8));
    const double r = kit.radius();
    add_tube(builder, {{{-0.045, -0.05, 0.0}, 1.3 * r}, {{-0.025, 0.065, 0.0}, 1.3 * r}},
             kit.around(12));
    return builder;
}

MeshBuilder make_forearm(const BoneKit& kit) {
    const double r = kit.radius();
    MeshBuilder builder;
    kit.add_long_bone(builder, kForearm_m, -0.6 * r, 0.62);
    kit.add_long_bone(builder, kForearm_m, 0.6 * r + 0.008, 0.55);
    // A wrist and five fingers, a little bent.
    add_ellipsoid(builder, {0.0, -kForearm_m - 0.018, 0.004}, {0.012, 0.02, 0.022}, kit.around(12));
    for (int finger = 0; finger < 5; ++finger) {
        const double x = 0.026 - 0.013 * finger;
        const double long_one = finger == 0 ? 0.7 : 1.0 - 0.06 * std::abs(finger - 2);
        const double y = -kForearm_m - 0.025;
        kit.add_curve(builder,
                      {{0.5 * x, y, 0.004},
                       {x, y - 0.07 * long_one, 0.004},
                       {x + 0.004, y - 0.115 * long_one, 0.0},
                       {x + 0.002, y - 0.15 * long_one, -0.012}},
                      0.35 * r + 0.001, 0.25 * r + 0.001);
    }
    return builder;
}

MeshBuilder make_shin(const BoneKit& kit) {
    const WalkerBody& body = get_skeleton_body();
    const double r = kit.radius();
    MeshBuilder builder;
    kit.add_long_bone(builder, body.shin_length);
    kit.add_curve(builder,
                  {{-0.6 * r, -0.04, 1.3 * r},
                   {-0.8 * r - 0.006, -0.2, 1.3 * r + 0.012},
                   {-0.4 * r, -body.shin_length, 1.2 * r + 0.004}},
                  0.5 * r, 0.45 * r);
    add_ellipsoid(builder, {1.25 * r + 0.004, 0.008, 0.0}, {0.7 * r, 1.1 * r, r}, kit.around(12));
    return builder;
}

/// Heel, five rays and toes; the sole is body.ankle below zero.
MeshBuilder make_foot(const BoneKit& kit) {
    const double sole = -get_skeleton_body().ankle;
    const double r = std::min(kit.radius(), 0.02);
    MeshBuilder builder;
    add_ellipsoid(builder, {-0.03, sole + 0.026, 0.0}, {0.034, 0.026, 0.02}, kit.around(16));
    add_ellipsoid(builder, {0.012, sole + 0.045, 0.0}, {0.042, 0.022, 0.026}, kit.around(16));
    for (int ray = 0; ray < 5; ++ray) {
        const double z = 0.032 - 0.016 * ray;
        const double thick = 0.4 * r + 0.0025;
        const double length = 0.19 - 0.012 * ray;
        kit.add_curve(builder,
                      {{0.035, sole + 0.042, 0.4 * z},
                       {0.5 * length + 0.03, sole + 0.03, 0.9 * z},
                       {0.75 * length, sole + thick + 0.004, 1.2 * z},
                       {length, sole + thick, 1.3 * z}},
                      1.2 * thick, thick);
    }
    return builder;
}

} // namespace

const WalkerBody& get_skeleton_body() {
    static const WalkerBody kBody = make_body();
    return kBody;
}

SkeletonMeshes make_skeleton(double thickness_m, double detail) {
    const BoneKit kit(thickness_m, detail);
    const WalkerBody& body = get_skeleton_body();
    SkeletonMeshes skeleton;
    const auto add = [&skeleton](const MeshBuilder& builder, const char* name) {
        skeleton.meshes.push_back(builder.finish(name, kBone, 50.0));
        return skeleton.meshes.size() - 1;
    };
    skeleton.of_limb[kTorso] = add(make_trunk(kit), "trunk");
    skeleton.of_limb[kHead] = add(make_skull(kit), "skull");
    MeshBuilder upper_arm;
    kit.add_long_bone(upper_arm, body.upper_arm_length, 0.0, 0.85);
    MeshBuilder thigh;
    kit.add_long_bone(thigh, body.thigh_length);
    const std::size_t arm = add(upper_arm, "upper arm");
    const std::size_t forearm = add(make_forearm(kit), "forearm");
    const std::size_t leg = add(thigh, "thigh");
    const std::size_t shin = add(make_shin(kit), "shin");
    const std::size_t foot = add(make_foot(kit), "foot");
    for (std::size_t side = 0; side < 2; ++side) {
        skeleton.of_limb[kUpperArm + side] = arm;
        skeleton.of_limb[kForearm + side] = forearm;
        skeleton.of_limb[kThigh + side] = leg;
        skeleton.of_limb[kShin + side] = shin;
        skeleton.of_limb[kFoot + side] = foot;
    }
    return skeleton;
}

} // namespace alcove
