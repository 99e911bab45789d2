#include "scenes/city/elements.hpp"
#include "scenes/common/solids.hpp"

namespace alcove::city {
namespace {

std::size_t make_lamp(Kit& kit) {
    MeshBuilder builder;
    const int around = kit.segments(7, 5);
    add_lathe_at(builder, {0.0, 0.0, 0.0},
                 {{0.17, -0.1}, {0.17, 0.12}, {0.1, 0.2}, {0.09, 0.8}, {0.055, 0.9}, {0.04, 4.2}},
                 around);
    // A lantern: four panes that widen upwards, below a lid.
    const auto square = [](double half, double y) {
        return Ring{{-half, y, -half}, {-half, y, half}, {half, y, half}, {half, y, -half}};
    };
    add_loft(builder, {square(0.1, 4.15), square(0.19, 4.6)}, LoftEnds::capped);
    add_loft(builder, {square(0.25, 4.57), square(0.05, 4.8)}, LoftEnds::capped);
    if (kit.steps() > 1) {
        for (const double y : {1.2, 2.2, 3.9}) {
            add_lathe_at(builder, {0.0, y, 0.0}, {{0.045, 0.0}, {0.075, 0.03}, {0.045, 0.06}},
                         around);
        }
        add_box(builder, {-0.5, 3.6, -0.025}, {0.5, 3.65, 0.025});
    }
    return kit.add_mesh(builder.finish("lamp", kIron, 40.0));
}

std::size_t make_bollard(Kit& kit) {
    MeshBuilder builder;
    add_lathe_at(builder, {0.0, 0.0, 0.0},
                 {{0.09, -0.1}, {0.08, 0.75}, {0.11, 0.8}, {0.09, 0.88}, {0.0, 0.93}},
                 kit.segments(6, 6));
    return kit.add_mesh(builder.finish("bollard", kIron, 80.0));
}

std::size_t make_bench(Kit& kit) {
    MeshBuilder builder;
    for (const double x : {-0.8, 0.8}) {
        add_box(builder, {x - 0.05, -0.05, -0.25}, {x + 0.05, 0.43, 0.22});
        add_box(builder, {x - 0.04, 0.4, -0.3}, {x + 0.04, 0.9, -0.22});
    }
    for (int slat = 0; slat < 3; ++slat) {
        const double z = -0.2 + 0.15 * slat;
        add_box(builder, {-0.95, 0.41, z}, {0.95, 0.46, z + 0.11});
        const double y = 0.52 + 0.14 * slat;
        add_box(builder, {-0.96, y, -0.23}, {0.96, y + 0.1, -0.18});
    }
    return kit.add_mesh(builder.finish("bench", kWood, 30.0));
}

} // namespace

void add_furniture(Kit& kit, const Plan& plan) {
    const std::size_t lamp = make_lamp(kit);
    const std::size_t bollard = make_bollard(kit);
    const std::size_t bench = make_bench(kit);
    for (const Block& block : plan.blocks) {
        for (int turns = 0; turns < 4; ++turns) {
            const auto put = [&](std::size_t mesh, double x, double z, int turn) {
                const glm::dmat4 side = make_frame(block.middle, turns);
                const glm::dmat4 frame =
                    shift(side, {x, kPavement, z}) * make_frame(glm::dvec3(0.0), turn);
                if (measure_distance_to_route(glm::dvec3(frame[3])) < kit.reach_m()) {
                    kit.place(mesh, frame);
                }
            };
            for (int i = 0; i < 5; ++i) {
                put(lamp, -42.0 + kLotWidth * i, kKerb - 0.7, 0);
            }
            for (int i = 0; i < 3; ++i) {
                put(bollard, 45.0 + 1.6 * i, kKerb - 0.6, 0);
                put(bollard, -45.0 - 1.6 * i, kKerb - 0.6, 0);
            }
            put(bench, -36.5, kKerb - 0.95, 2);
            put(bench, 5.0, kKerb - 0.95, 2);
        }
    }
}

} // namespace alcove::city
