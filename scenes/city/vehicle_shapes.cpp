#include "scenes/city/vehicle_shapes.hpp"

#include "scenes/city/movers.hpp"
#include "scenes/city/style.hpp"
#include "scenes/common/solids.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace alcove::city {
namespace {

constexpr double kPi = std::numbers::pi;

/// In the (x, y) plane through `z`, pushed towards +z.
void add_plate(MeshBuilder& builder, double z, double depth, const Contour& outline,
               const std::vector<Contour>& holes = {}) {
    add_extrusion(builder, {{0.0, 0.0, z}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}, outline, holes,
                  depth);
}

Contour make_circle(double radius, int segments, double phase = 0.0) {
    Contour circle = make_arc({0.0, 0.0}, {radius, radius}, phase, phase + 2.0 * kPi, segments);
    circle.pop_back();
    return circle;
}

/// Side view of the car's lower body with cut-outs for the wheels.
Contour draw_car(int arc, double by) {
    Contour outline{{-2.05 + by, 0.28 + by}};
    for (const double axle : {-1.25, 1.3}) {
        const Contour arch = make_arc({axle, kCarWheel}, {0.38 + by, 0.38 + by}, kPi, 0.0, arc);
        outline.emplace_back(axle - 0.38 - by, 0.2 + by);
        outline.insert(outline.end(), arch.begin(), arch.end());
        outline.emplace_back(axle + 0.38 + by, 0.2 + by);
    }
    outline.insert(outline.end(), {{2.05 - by, 0.28 + by},
                                   {2.12 - by, 0.62},
                                   {1.95 - by, 0.78 - by},
                                   {0.95, 0.93 - by},
                                   {-1.7, 0.96 - by},
                                   {-2.08 + by, 0.86 - by}});
    return outline;
}

} // namespace

Mesh make_wheel(const Kit& kit, double radius) {
    const int around = kit.segments(11, 10);
    MeshBuilder builder;
    std::vector<Contour> rim;
    std::vector<Contour> holes;
    constexpr int kHoles = 5;
    for (int i = 0; i < kHoles && kit.steps() > 1; ++i) {
        const double angle = 2.0 * kPi * i / kHoles;
        Contour hole = make_arc({0.42 * radius * std::cos(angle), 0.42 * radius * std::sin(angle)},
                                {0.13 * radius, 0.13 * radius}, 0.0, 2.0 * kPi, 4);
        hole.pop_back();
        holes.push_back(hole);
    }
    if (kit.steps() > 1) {
        rim.push_back(make_circle(0.66 * radius, around));
    }
    add_plate(builder, -0.1, 0.2, make_circle(radius, around), rim);
    // Within the tyre's ring, or proud of its disk.
    const double half = kit.steps() > 1 ? 0.06 : 0.11;
    add_plate(builder, -half, 2.0 * half, make_circle(0.7 * radius, around, 0.1), holes);
    add_box(builder, {-0.6 * radius, -0.1 * radius, -half - 0.02},
            {0.6 * radius, 0.1 * radius, half + 0.02});
    return builder.finish("wheel", {0.09f, 0.09f, 0.1f}, 40.0);
}

std::vector<std::size_t> add_car(Kit& kit, const glm::vec3& paint) {
    const int arc = kit.segments(6, 6);
    MeshBuilder body;
    add_plate(body, -0.8, 1.6, draw_car(arc, 0.0));
    for (const double side : {-1.0, 1.0}) { // doors and wings bulge
        add_plate(body, side < 0.0 ? -0.85 : 0.75, 0.1, draw_car(arc, 0.05));
    }
    const auto rectangle = [](double back, double front, double half, double y) {
        return Ring{{back, y, -half}, {back, y, half}, {front, y, half}, {front, y, -half}};
    };
    add_loft(body, {rectangle(-1.3, 0.16, 0.66, 1.36), rectangle(-1.16, 0.02, 0.58, 1.45)},
             LoftEnds::capped);
    for (const double x : {-0.5}) { // the post between the doors
        add_box(body, {x - 0.05, 0.9, -0.76}, {x + 0.05, 0.99, 0.76});
    }
    for (const double side : {-1.0, 1.0}) {
        add_box(body, {0.55, 0.95, side * 0.87 - 0.1}, {0.68, 1.08, side * 0.87 + 0.1});
    }
    MeshBuilder dark;
    add_loft(dark, {rectangle(-1.72, 0.95, 0.75, 0.85), rectangle(-1.28, 0.14, 0.645, 1.385)},
             LoftEnds::capped);
    add_box(dark, {-1.9, 0.24, -0.7}, {1.9, 0.4, 0.7});   // underbody
    add_box(dark, {2.0, 0.42, -0.4}, {2.125, 0.55, 0.4}); // grille
    MeshBuilder lamps;
    for (const double side : {-1.0, 1.0}) {
        add_box(lamps, {1.9, 0.56, side * 0.6 - 0.14}, {2.125, 0.7, side * 0.6 + 0.14});
        add_box(lamps, {-2.12, 0.62, side * 0.65 - 0.1}, {-1.9, 0.78, side * 0.65 + 0.1});
    }
    return {kit.add_mesh(body.finish("car", paint, 35.0)),
            kit.add_mesh(dark.finish("car_glass", kGlass, 35.0)),
            kit.add_mesh(lamps.finish("car_lamps", glm::vec3(0.75f), 35.0))};
}

std::vector<std::size_t> add_tram(Kit& kit) {
    constexpr double kHalf = 8.0;
    constexpr double kBase = 0.42;
    const int arc = kit.segments(6, 4);
    // Seen from above: rounded ends.
    const auto ring = [arc](double inset, double y) {
        Ring points;
        for (const double end : {1.0, -1.0}) {
            const Contour nose = make_arc({end * (kHalf - 1.3), 0.0}, {1.3 - inset, 1.15 - inset},
                                          end > 0.0 ? -0.5 * kPi : 0.5 * kPi,
                                          end > 0.0 ? 0.5 * kPi : 1.5 * kPi, 2 * arc);
            for (const glm::dvec2& p : nose) {
                points.emplace_back(p.x, y, -p.y); // counter-clockwise from above
            }
        }
        return points;
    };
    MeshBuilder body;
    add_loft(body, {ring(0.06, kBase), ring(0.0, kBase + 0.2), ring(0.0, 1.35)}, LoftEnds::capped);
    add_loft(body,
             {ring(0.02, 2.55), ring(0.0, 2.65), ring(0.0, 2.85), ring(0.2, 3.05), ring(0.5, 3.12)},
             LoftEnds::capped);
    constexpr int kPosts = 9;
    for (int i = 0; i < kPosts; ++i) {
        const double x = -6.4 + 12.8 * i / (kPosts - 1);
        for (const double side : {-1.0, 1.0}) {
            add_box(body, {x - 0.09, 1.25, side * 1.06 - 0.07},
                    {x + 0.09, 2.62, side * 1.06 + 0.07});
        }
    }
    for (const double x : {-4.0, 0.5, 4.0}) { // boxes on the roof
        add_box(body, {x - 0.9, 3.0, -0.55}, {x + 0.9, 3.38, 0.55});
    }
    MeshBuilder dark;
    add_loft(dark, {ring(0.16, 1.2), ring(0.14, 2.7)}, LoftEnds::capped);
    for (const double x : {-4.8, 0.0, 4.8}) {
        for (const double side :
             {-1.0, 1.0}) { // door leaves, from behind the glass to before the side
            for (const double leaf : {-0.34, 0.34}) {
                add_box(dark, {x + leaf - 0.31, 0.6, side * 1.045 - 0.145},
                        {x + leaf + 0.31, 2.5, side * 1.045 + 0.145});
            }
        }
    }
    for (const double x : {-4.6, 4.6}) { // bogies
        add_box(dark, {x - 1.1, 0.16, -0.86}, {x + 1.1, 0.5, 0.86});
    }
    MeshBuilder trim;
    add_loft(trim, {ring(-0.02, 1.28), ring(-0.025, 1.38)}, LoftEnds::capped);
    add_loft(trim, {ring(-0.02, 0.76), ring(-0.02, 0.82)}, LoftEnds::capped);
    for (const double side : {-1.0, 1.0}) { // collector
        add_box(trim, {2.1, 3.55, side * 0.5 - 0.03}, {2.16, 3.6, side * 0.5 + 0.03});
        add_bar(trim,
                {{side * 0.47, 3.3}, {side * 0.53, 3.3}, {side * 0.54, 4.6}, {side * 0.48, 4.6}},
                2.08, 2.14);
    }
    add_box(trim, {2.06, 4.52, -0.8}, {2.17, 4.62, 0.8});
    return {kit.add_mesh(body.finish("tram", {0.6f, 0.11f, 0.1f}, 35.0)),
            kit.add_mesh(dark.finish("tram_glass", kGlass, 35.0)),
            kit.add_mesh(trim.finish("tram_trim", glm::vec3(0.68f), 35.0))};
}

} // namespace alcove::city
