#include "scenes/city/elements.hpp"
#include "scenes/common/figure_shapes.hpp"

#include <array>
#include <cmath>

namespace alcove::city {
namespace {

/// From its joint down, thick at both ends so that neighbours reach into each other.
std::size_t add_rod(Kit& kit, const char* name, const glm::vec3& albedo, double length,
                    double thick, double thin) {
    MeshBuilder builder;
    add_limb(builder,
             {{-length - 0.6 * thin, 0.4 * thin, 0.4 * thin},
              {-length, thin, thin},
              {-0.4 * length, 0.5 * (thick + thin), 0.5 * (thick + thin), -0.1 * thick},
              {0.0, thick, thick},
              {0.7 * thick, 0.45 * thick, 0.45 * thick}},
             kit.segments(8, 6));
    return kit.add_mesh(builder.finish(name, albedo, 70.0));
}

struct Clothes {
    glm::vec3 coat;
    glm::vec3 trousers;
};

/// One mesh a limb; left and right share it.
std::array<std::size_t, kLimbs> add_body(Kit& kit, const Clothes& clothes) {
    constexpr glm::vec3 kSkin(0.55f, 0.38f, 0.29f);
    const int around = kit.segments(10, 8);
    std::array<std::size_t, kLimbs> meshes{};
    MeshBuilder torso;
    add_limb(torso,
             {{-0.11, 0.06, 0.08},
              {-0.07, 0.1, 0.15},
              {0.02, 0.115, 0.165},
              {0.2, 0.1, 0.14},
              {0.42, 0.125, 0.19, 0.01},
              {0.52, 0.09, 0.18, 0.01},
              {0.57, 0.05, 0.07, 0.01}},
             around);
    meshes[kTorso] = kit.add_mesh(torso.finish("figure_torso", clothes.coat, 70.0));
    MeshBuilder head;
    add_limb(head,
             {{-0.06, 0.045, 0.045},
              {0.04, 0.05, 0.05},
              {0.07, 0.085, 0.065, 0.02},
              {0.16, 0.1, 0.078, 0.01},
              {0.24, 0.08, 0.06},
              {0.27, 0.03, 0.025}},
             around);
    meshes[kHead] = kit.add_mesh(head.finish("figure_head", kSkin, 70.0));
    const std::size_t upper_arm =
        add_rod(kit, "figure_upper_arm", clothes.coat, kBody.upper_arm_length, 0.062, 0.046);
    const std::size_t forearm = add_rod(kit, "figure_forearm", clothes.coat, 0.27, 0.046, 0.036);
    const std::size_t thigh =
        add_rod(kit, "figure_thigh", clothes.trousers, kBody.thigh_length, 0.09, 0.062);
    const std::size_t shin =
        add_rod(kit, "figure_shin", clothes.trousers, kBody.shin_length, 0.062, 0.042);
    MeshBuilder shoe;
    add_limb(shoe,
             {{-kBody.ankle, 0.12, 0.042, 0.055},
              {-0.04, 0.125, 0.047, 0.055},
              {0.0, 0.06, 0.045},
              {0.05, 0.045, 0.04, -0.005}},
             around);
    const std::size_t foot = kit.add_mesh(shoe.finish("figure_foot", kIron, 50.0));
    for (std::size_t side = 0; side < 2; ++side) {
        meshes[kUpperArm + side] = upper_arm;
        meshes[kForearm + side] = forearm;
        meshes[kThigh + side] = thigh;
        meshes[kShin + side] = shin;
        meshes[kFoot + side] = foot;
    }
    return meshes;
}

} // namespace

void add_figures(Kit& kit, Movers& movers) {
    constexpr double kInner = 8.4; ///< metres from the street's axis: lane along the trees
    constexpr double kOuter = 9.0; ///< lane along the houses, the other way
    struct Start {
        double x;
        double z;
        bool is_eastward;
    };
    constexpr std::array<Start, 18> kStarts{{{-186.5, kInner, true},
                                             {-181.0, kInner, true},
                                             {-171.5, kInner, true},
                                             {-214.0, kInner, true},
                                             {-228.0, kInner, true},
                                             {-172.0, kOuter, false},
                                             {-164.5, kOuter, false},
                                             {-140.0, kOuter, false},
                                             {-126.0, kOuter, false},
                                             {-180.0, -kInner, false},
                                             {-168.0, -kInner, false},
                                             {-150.0, -kInner, false},
                                             {-205.0, -kOuter, true},
                                             {-190.0, -kOuter, true},
                                             {-100.0, kInner, true},
                                             {-80.0, kInner, true},
                                             {-20.0, kOuter, false},
                                             {-30.0, -kInner, false}}};
    constexpr std::array<Clothes, 4> kClothes{{{{0.16f, 0.2f, 0.32f}, {0.12f, 0.12f, 0.14f}},
                                               {{0.5f, 0.14f, 0.12f}, {0.2f, 0.22f, 0.3f}},
                                               {{0.55f, 0.5f, 0.4f}, {0.3f, 0.24f, 0.18f}},
                                               {{0.2f, 0.36f, 0.24f}, {0.4f, 0.38f, 0.34f}}}};
    std::array<std::array<std::size_t, kLimbs>, kClothes.size()> bodies{};
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        bodies[i] = add_body(kit, kClothes[i]);
    }
    SplitMix random = kit.make_random(0xf16u);
    for (std::size_t i = 0; i < kStarts.size(); ++i) {
        const Start& start = kStarts[i];
        Walker walker;
        walker.phase = random.draw_unit();
        walker.drive = {{start.x, kPavement, start.z}, start.is_eastward, random.draw(0.95, 1.0)};
        // Up to the pavement's end at the next crossing, and there to a moment when both feet
        // stand.
        const double crossing = kPitch * (start.is_eastward ? std::ceil(start.x / kPitch)
                                                            : std::floor(start.x / kPitch));
        const double room = std::abs(crossing - start.x) - kHalfCarriageway - 1.0;
        const double half_cycles = std::floor(2.0 * (room / kBody.cycle + walker.phase - 0.06));
        walker.drive.length = (0.5 * half_cycles + 0.06 - walker.phase) * kBody.cycle;
        for (std::size_t limb = 0; limb < kLimbs; ++limb) {
            walker.objects[limb] = kit.place(bodies[i % bodies.size()][limb], glm::dmat4(1.0));
        }
        movers.walkers.push_back(walker);
    }
}

} // namespace alcove::city
