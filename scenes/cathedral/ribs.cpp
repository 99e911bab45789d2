#include "scenes/cathedral/elements.hpp"
#include "scenes/common/solids.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

namespace alcove::cathedral {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr glm::dvec3 kUp(0.0, 1.0, 0.0);

/// Half an ellipse from -reach over the crown to +reach; `reach` is horizontal.
std::vector<glm::dvec3> make_arch(const glm::dvec3& reach, double spring, double rise,
                                  int segments) {
    std::vector<glm::dvec3> path;
    for (int i = 0; i <= segments; ++i) {
        const double angle = kPi * i / segments;
        path.push_back(-std::cos(angle) * reach +
                       glm::dvec3(0.0, spring + rise * std::sin(angle), 0.0));
    }
    return path;
}

/// Bar, its lower edges chamfered or not: `sunk` into the vault, `deep` below it, `half` to each
/// side.
Contour make_rib_section(bool is_chamfered, double sunk, double deep, double half) {
    if (!is_chamfered) {
        return {{-sunk, -half}, {deep, -half}, {deep, half}, {-sunk, half}};
    }
    return {{-sunk, -half},      {0.6 * deep, -half}, {deep, -0.45 * half},
            {deep, 0.45 * half}, {0.6 * deep, half},  {-sunk, half}};
}

/// Ribs of neighbouring bays meet above the abacus: every other bay is moved a little, so that no
/// faces share a plane.
double get_stagger(int bay) {
    return 0.01 * (bay % 2);
}

Mesh make_rib(std::string name, const std::vector<glm::dvec3>& path, const glm::dvec3& reach,
              const Contour& section) {
    MeshBuilder builder;
    // Side cross up is the way to the arch's middle, so that the section's x points into the room.
    add_sweep(builder, section, path, glm::normalize(glm::cross(kUp, reach)));
    return builder.finish(std::move(name), kLightStone, 40.0);
}

void add_nave_ribs(Kit& kit) {
    const int segments = kit.segments(26, 6);
    constexpr double kReach = kNaveHalfWidth + kSink;
    const double deep = kit.vary(0.3, 0.1);
    const glm::dvec3 across(0.0, 0.0, kReach);
    const std::size_t transverse =
        kit.add_mesh(make_rib("nave_rib", make_arch(across, kNaveSpring, kNaveRise, segments),
                              across, make_rib_section(kit.has_ornament(), 0.08, deep, 0.24)));
    for (int line = 0; line <= kBays; ++line) {
        kit.place(transverse, {get_column_x(line), 0.0, 0.0});
    }
    std::vector<std::size_t> in_bay;
    for (const double side : {-1.0, 1.0}) {
        const glm::dvec3 diagonal(0.5 * kBayLength, 0.0, side * kReach);
        in_bay.push_back(kit.add_mesh(make_rib(
            "diagonal_rib", make_arch(diagonal, kNaveSpring, kNaveRise, segments), diagonal,
            make_rib_section(kit.has_ornament(), side > 0.0 ? 0.1 : 0.12,
                             side > 0.0 ? 0.7 * deep : 0.73 * deep, 0.14))));
    }
    const double boss = kit.vary(0.34, 0.1);
    in_bay.push_back(kit.add_mesh(make_lathe(
        "boss", kLightStone,
        smooth_profile({{0.0, 13.52}, {0.7 * boss, 13.58}, {boss, 13.76}, {0.8 * boss, 14.08}},
                       kit.segments(3, 1)),
        kit.segments(16, 6))));
    for (int bay = 0; bay < kBays; ++bay) {
        for (const std::size_t part : in_bay) {
            kit.place(part, {get_bay_x(bay), get_stagger(bay), 0.0});
        }
    }
}

/// Along the lunettes, where the vault meets the nave walls.
void add_wall_ribs(Kit& kit) {
    const glm::dvec3 along(0.5 * kBayLength, 0.0, 0.0);
    const std::size_t wall_rib = kit.add_mesh(
        make_rib("wall_rib", make_arch(along, kNaveSpring, kNaveRise, kit.segments(20, 5)), along,
                 make_rib_section(true, 0.1, 0.16, 0.13)));
    for (int bay = 0; bay < kBays; ++bay) {
        for (const double side : {-1.0, 1.0}) {
            kit.place(wall_rib, {get_bay_x(bay), get_stagger(bay),
                                 side * (kNaveHalfWidth + get_stagger(bay))});
        }
    }
}

void add_aisle_ribs(Kit& kit) {
    const double inner = kNaveHalfWidth + kNaveWall;
    const glm::dvec3 across(0.0, 0.0, 0.5 * (kAisleOuter - inner) + kSink);
    const std::size_t rib = kit.add_mesh(
        make_rib("aisle_rib", make_arch(across, kArcadeSpring, kAisleRise, kit.segments(18, 5)),
                 across, make_rib_section(kit.has_ornament(), 0.08, 0.22, 0.2)));
    for (int line = 0; line <= kBays; ++line) {
        for (const double side : {-1.0, 1.0}) {
            kit.place(rib, {get_column_x(line), 0.0, side * 0.5 * (kAisleOuter + inner)});
        }
    }
}

/// A roll along the edge of each arcade arch, on both faces of the wall.
void add_arcade_mouldings(Kit& kit) {
    const double roll = kit.vary(0.09, 0.15);
    Contour section = make_arc({0.0, 0.0}, {roll, roll}, 0.0, 2.0 * kPi, kit.segments(8, 4));
    section.pop_back();
    const glm::dvec3 along(2.13, 0.0, 0.0);
    // A little higher than the springing: its ends are cut off by the abacus.
    const std::size_t moulding = kit.add_mesh(make_rib(
        "arcade_moulding", make_arch(along, kArcadeSpring - 0.01, 2.13, kit.segments(22, 6)), along,
        section));
    for (int bay = 0; bay < kBays; ++bay) {
        for (const double side : {-1.0, 1.0}) {
            kit.place(moulding, {get_bay_x(bay), 0.0, side * kNaveHalfWidth});
            kit.place(moulding, {get_bay_x(bay), 0.0, side * (kNaveHalfWidth + kNaveWall)});
        }
    }
}

} // namespace

void add_ribs(Kit& kit) {
    add_nave_ribs(kit);
    add_aisle_ribs(kit);
    if (kit.has_ornament()) {
        add_wall_ribs(kit);
        add_arcade_mouldings(kit);
    }
}

} // namespace alcove::cathedral
