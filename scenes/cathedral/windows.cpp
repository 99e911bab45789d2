#include "scenes/cathedral/elements.hpp"
#include "scenes/common/solids.hpp"

#include <cmath>
#include <numbers>

namespace alcove::cathedral {
namespace {

constexpr double kPi = std::numbers::pi;

/// Two lancets and a round light: bars of 10 cm before the sky.
Mesh make_clerestory_tracery(Kit& kit) {
    const int arc = kit.segments(14, 4);
    const Contour outline = make_arched_opening(0.0, 0.8 + kSink, 8.7 - kSink, 11.2, arc);
    const double bar = kit.vary(0.1, 0.2);
    const double lancet = 0.5 * (0.8 - bar);
    std::vector<Contour> lights;
    for (const double side : {-1.0, 1.0}) {
        lights.push_back(make_arched_opening(side * (0.5 * bar + lancet), lancet, 8.74, 10.6,
                                             kit.segments(8, 3)));
    }
    Contour round = make_arc({0.0, 11.4}, {0.3, 0.3}, 0.0, 2.0 * kPi, kit.segments(14, 4));
    round.pop_back();
    lights.push_back(round);
    MeshBuilder builder;
    add_extrusion(builder, {}, outline, lights, 0.14);
    return builder.finish("clerestory_tracery", kLightStone, 30.0);
}

/// A wheel: eight petals around a hub.
Mesh make_rose_tracery(Kit& kit) {
    constexpr int kPetals = 8;
    const int rim = kit.segments(40, 16);
    Contour outline = make_arc({0.0, 10.4}, {1.8, 1.8}, 0.0, 2.0 * kPi, rim);
    outline.pop_back();
    std::vector<Contour> lights;
    const int arc = kit.segments(8, 2);
    const double half_angle = kPi / kPetals - kit.vary(0.06, 0.2);
    for (int petal = 0; petal < kPetals; ++petal) {
        const double middle = 2.0 * kPi * petal / kPetals;
        Contour light =
            make_arc({0.0, 10.4}, {1.5, 1.5}, middle - half_angle, middle + half_angle, arc);
        const Contour inner = make_arc({0.0, 10.4}, {0.6, 0.6}, middle + 0.8 * half_angle,
                                       middle - 0.8 * half_angle, std::max(arc / 2, 2));
        light.insert(light.end(), inner.begin(), inner.end());
        lights.push_back(light);
    }
    Contour hub = make_arc({0.0, 10.4}, {0.32, 0.32}, 0.0, 2.0 * kPi, kit.segments(14, 4));
    hub.pop_back();
    lights.push_back(hub);
    MeshBuilder builder;
    add_extrusion(builder, {{0.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}}, outline, lights,
                  0.16);
    return builder.finish("rose_tracery", kLightStone, 30.0);
}

} // namespace

void add_windows(Kit& kit) {
    kit.place(kit.add_mesh(make_rose_tracery(kit)), {-kHalfLength - 0.36, 0.0, 0.0});
    if (!kit.has_ornament()) {
        return;
    }
    const std::size_t clerestory = kit.add_mesh(make_clerestory_tracery(kit));
    for (int bay = 0; bay < kBays; ++bay) {
        for (const double side : {-1.0, 1.0}) {
            kit.place(clerestory, {get_bay_x(bay), 0.0, side * kColumnZ}, side > 0.0 ? 0 : 2);
        }
    }
}

} // namespace alcove::cathedral
