#include "scenes/city/storeys.hpp"

#include "scenes/city/openings.hpp"
#include "scenes/city/plan.hpp"
#include "scenes/common/solids.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

namespace alcove::city {
namespace {

constexpr double kCrease = 47.0;    // degrees: half a circle of four segments is smooth
constexpr double kSeam = 0.03;      ///< from a storey's floor to its wall, hidden by the belt
constexpr double kBeltBack = -0.07; ///< z, in the house, deeper than the back of a wall

std::vector<Opening> list_openings(const Style& style, StoreyKind kind, int bays) {
    std::vector<Opening> openings;
    for (int bay = 0; bay < bays; ++bay) {
        Opening opening{kBay * (bay - 0.5 * (bays - 1)), style.half_window, style.sill, style.head,
                        style.rise};
        if (kind == StoreyKind::ground) {
            const bool is_door = bays == kFrontBays && bay == 2;
            opening.half_width = is_door ? 0.95 : 1.2;
            opening.bottom = is_door ? 0.02 : 0.6;
            opening.top = 3.35;
            opening.rise = is_door ? 0.9 : 1.1;
        } else if (kind == StoreyKind::court) {
            opening.rise = 0.0;
        }
        openings.push_back(opening);
    }
    return openings;
}

/// The floor's edge as a moulded belt over the seam between two walls.
void add_belt(MeshBuilder& builder, StoreyKind kind, int bays, int segments, int steps) {
    // The ground floor's wall ends lower where its house is not raised.
    const double low = kind == StoreyKind::noble ? -0.3 : -0.12;
    const double half = 0.5 * kBay * bays - 0.02;
    Contour section{{kBeltBack, low}, {kFacade + 0.06, low}};
    if (steps > 1) {
        const Contour swell = make_arc({kFacade + 0.06, low + 0.09}, {0.06, 0.06},
                                       -0.25 * std::numbers::pi, 0.5 * std::numbers::pi, segments);
        section.insert(section.end(), swell.begin(), swell.end());
    }
    section.insert(section.end(),
                   {{kFacade + 0.14, 0.06}, {kFacade + 0.14, 0.16}, {kBeltBack, 0.16}});
    add_bar(builder, section, -half, half);
}

/// Blocks on the piers between the ground floor's openings.
void add_rustication(MeshBuilder& builder, const std::vector<Opening>& openings, int bays,
                     int courses) {
    const double edge = 0.5 * kBay * bays - 0.2;
    const double pitch = 3.3 / courses;
    for (std::size_t i = 0; i <= openings.size(); ++i) {
        const double left =
            i == 0 ? -edge : openings[i - 1].middle + openings[i - 1].half_width + 0.2;
        const double right =
            i == openings.size() ? edge : openings[i].middle - openings[i].half_width - 0.2;
        for (int course = 0; course < courses; ++course) {
            add_box(builder, {left, 0.4 + pitch * course, kFacade - kSink},
                    {right, 0.4 + pitch * (course + 1) - 0.05, kFacade + 0.055});
        }
    }
}

/// A door leaf with raised fields, within the first opening that reaches the floor.
void add_door(MeshBuilder& builder, const Opening& door, int rows) {
    for (const double side : {-1.0, 1.0}) {
        const double left = door.middle + (side < 0.0 ? 0.1 - door.half_width : 0.04);
        for (int row = 0; row < rows; ++row) {
            const double pitch = 2.1 / rows;
            add_box(builder, {left, 0.2 + pitch * row, 0.1},
                    {left + door.half_width - 0.14, 0.12 + pitch * (row + 1), 0.16});
        }
    }
}

Mesh make_wall(const Kit& kit, const Style& style, StoreyKind kind,
               const std::vector<Opening>& openings, int bays) {
    const double half = 0.5 * kBay * bays + 0.02;
    const double low = kind == StoreyKind::ground ? -0.5 : kSeam;
    const double high = (kind == StoreyKind::ground ? kGroundFloor : kStorey) - kSeam;
    std::vector<Contour> holes;
    for (const Opening& opening : openings) {
        holes.push_back(draw_opening(opening, 0.0, kit.segments(4, 4)));
    }
    MeshBuilder builder;
    add_extrusion(builder, {{0.0, 0.0, -kSink}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}},
                  make_rectangle(-half, low, half, high), holes, kFacade + kSink);
    return builder.finish("facade_wall", style.wall, kCrease);
}

void add_trim(MeshBuilder& builder, const Kit& kit, const Style& style, StoreyKind kind,
              const std::vector<Opening>& openings, int steps) {
    const int arc = kit.segments(4, 4);
    const int bays = static_cast<int>(openings.size());
    for (const Opening& opening : openings) {
        add_surround(builder, opening, arc, steps);
        if (opening.bottom > 0.1) {
            add_sash(builder, opening, arc, steps);
            add_sill(builder, opening, steps);
        }
        if (kind == StoreyKind::noble) {
            add_pediment(builder, opening, style.pediment, arc, steps);
        }
    }
    if (kind == StoreyKind::ground) {
        add_rustication(builder, openings, bays, kit.count(1.4, 1));
    } else {
        add_belt(builder, kind, bays, kit.segments(3, 2), steps);
    }
}

} // namespace

std::vector<std::size_t> add_storey(Kit& kit, const Style& style, StoreyKind kind, int bays,
                                    int steps) {
    const std::vector<Opening> openings = list_openings(style, kind, bays);
    std::vector<std::size_t> meshes{kit.add_mesh(make_wall(kit, style, kind, openings, bays))};
    MeshBuilder glass;
    MeshBuilder wood;
    for (const Opening& opening : openings) {
        const bool is_door = opening.bottom < 0.1;
        add_pane(is_door ? wood : glass, opening);
        if (is_door) {
            add_door(wood, opening, 1 + steps);
        }
    }
    meshes.push_back(kit.add_mesh(glass.finish("facade_glass", kGlass, kCrease)));
    if (!wood.triangles().empty()) {
        meshes.push_back(kit.add_mesh(wood.finish("door", kWood, kCrease)));
    }
    if (kind != StoreyKind::court) {
        MeshBuilder trim;
        add_trim(trim, kit, style, kind, openings, steps);
        meshes.push_back(kit.add_mesh(trim.finish("facade_trim", style.trim, kCrease)));
    }
    return meshes;
}

std::size_t add_cornice(Kit& kit, const Style& style, int bays) {
    const double half = 0.5 * kBay * bays - 0.01;
    Contour section{{kBeltBack, -0.93}, {kFacade + 0.1, -0.93}};
    const Contour hollow = make_arc({kFacade + 0.4, -0.93}, {0.28, 0.2}, std::numbers::pi,
                                    0.5 * std::numbers::pi, kit.segments(3, 2));
    section.insert(section.end(), hollow.begin(), hollow.end());
    section.insert(section.end(),
                   {{kFacade + 0.5, -0.72}, {kFacade + 0.5, -0.58}, {kBeltBack, -0.58}});
    MeshBuilder builder;
    add_bar(builder, section, -half, half);
    const int blocks = kit.count(1.0, 1) * bays; // modillions
    for (int i = 0; i < blocks && kit.steps() > 1; ++i) {
        const double x = (i - 0.5 * (blocks - 1)) * kBay * bays / blocks;
        add_box(builder, {x - 0.09, -0.9, kFacade - kSink}, {x + 0.09, -0.7, kFacade + 0.44});
    }
    return kit.add_mesh(builder.finish("cornice", style.trim, kCrease));
}

std::size_t add_balcony(Kit& kit, const Style& style) {
    constexpr double kHalf = kBay - 0.4;
    constexpr double kFront = kFacade + 1.1;
    MeshBuilder builder;
    add_box(builder, {-kHalf, -0.14, kFacade - 0.2}, {kHalf, 0.19, kFront});
    add_box(builder, {-kHalf + 0.05, 1.0, kFront - 0.2}, {kHalf - 0.05, 1.1, kFront - 0.05});
    for (const double side : {-1.0, 1.0}) {
        const double x = side * (kHalf - 0.13);
        add_box(builder, {x - 0.07, 1.01, kFacade - kSink}, {x + 0.07, 1.09, kFront - 0.1});
        add_bar(builder,
                {{kFacade - 0.1, -0.7},
                 {kFacade + 0.2, -0.7},
                 {kFront - 0.2, -0.1},
                 {kFacade - 0.1, -0.1}},
                x - 0.12, x + 0.12);
    }
    const int count = 2 * kit.count(6.0, 6);
    const Contour profile{{0.03, 0.15}, {0.055, 0.42}, {0.022, 0.75}, {0.04, 1.03}};
    for (int i = 0; i <= count; ++i) {
        const double x = (kHalf - 0.13) * (2.0 * i / count - 1.0);
        add_lathe_at(builder, {x, 0.0, kFront - 0.125}, profile, kit.segments(4, 4));
    }
    const int at_side = std::max(2, count / 6);
    for (int i = 1; i < at_side; ++i) {
        const double z = kFacade + (kFront - 0.125 - kFacade) * i / at_side;
        for (const double side : {-1.0, 1.0}) {
            add_lathe_at(builder, {side * (kHalf - 0.13), 0.0, z}, profile, kit.segments(4, 4));
        }
    }
    return kit.add_mesh(builder.finish("balcony", style.trim, 89.0));
}

std::size_t add_quoin(Kit& kit, const Style& style, int storeys) {
    MeshBuilder builder;
    const double top = get_wall_height(storeys) - 0.6;
    add_box(builder, {-0.36, -0.4, -0.36}, {0.36, top, kFacade + 0.09});
    const int blocks = kit.steps() > 1 ? static_cast<int>(top / 0.5) : 0;
    for (int i = 0; i < blocks; ++i) {
        const double wide = i % 2 == 0 ? 0.06 : 0.16;
        const double y = 0.3 + (top - 0.5) * i / blocks;
        add_box(builder, {-0.36 - wide, y, -0.36 - wide}, {0.36 + wide, y + 0.42, kFacade + 0.13});
    }
    return kit.add_mesh(builder.finish("quoin", style.trim, kCrease));
}

} // namespace alcove::city
