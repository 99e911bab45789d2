#include "scenes/city/elements.hpp"
#include "scenes/common/solids.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace alcove::city {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kLaneZ = 4.1;       ///< axis of a lane for cars
constexpr double kStreetEnd = 590.0; ///< where the first of a lane stops
constexpr double kWheel = 0.31;      ///< radius, metres

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

/// A tyre with a bar across its disk, around z: its turning can be seen. From two steps on the disk
/// has holes.
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

/// Side view of the car's lower body with cut-outs for the wheels.
Contour draw_car(int arc, double by) {
    Contour outline{{-2.05 + by, 0.28 + by}};
    for (const double axle : {-1.25, 1.3}) {
        const Contour arch = make_arc({axle, kWheel}, {0.38 + by, 0.38 + by}, kPi, 0.0, arc);
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

/// 16 m long, in one piece.
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

class Depot {
  public:
    Depot(Kit& kit, Movers& movers)
        : m_kit(kit), m_movers(movers), m_wheel(kit.add_mesh(make_wheel(kit, kWheel))),
          m_tram_wheel(kit.add_mesh(make_wheel(kit, 0.33))), m_tram(add_tram(kit)) {
        for (const glm::vec3& paint :
             {glm::vec3(0.55f, 0.1f, 0.09f), glm::vec3(0.62f, 0.63f, 0.64f),
              glm::vec3(0.1f, 0.2f, 0.42f), glm::vec3(0.66f, 0.55f, 0.2f)}) {
            m_cars.push_back(add_car(kit, paint));
        }
    }

    void add_moving_car(const Drive& drive, std::size_t paint) {
        add(m_cars[paint % m_cars.size()], drive, m_wheel, kWheel,
            {{-1.25, kWheel, 0.0}, {1.3, kWheel, 0.0}}, 0.72);
    }
    void add_moving_tram(const Drive& drive) {
        // The wheels stand on rails that are 0.025 m high.
        add(m_tram, drive, m_tram_wheel, 0.33,
            {{-5.3, 0.35, 0.0}, {-3.9, 0.35, 0.0}, {3.9, 0.35, 0.0}, {5.3, 0.35, 0.0}},
            0.5 * kGauge);
    }
    void add_parked_car(const glm::dmat4& frame, std::size_t paint) {
        for (const std::size_t mesh : m_cars[paint % m_cars.size()]) {
            m_kit.place(mesh, frame);
        }
        for (const double x : {-1.25, 1.3}) {
            for (const double z : {-0.72, 0.72}) {
                m_kit.place(m_wheel, shift(frame, {x, kWheel - 0.01, z}));
            }
        }
    }

  private:
    void add(const std::vector<std::size_t>& bodies, const Drive& drive, std::size_t wheel,
             double radius, const std::vector<glm::dvec3>& axles, double half_gauge) {
        Vehicle vehicle;
        vehicle.drive = drive;
        for (const std::size_t mesh : bodies) {
            vehicle.bodies.push_back(m_kit.place(mesh, glm::dmat4(1.0)));
        }
        for (const glm::dvec3& axle : axles) {
            for (const double side : {-1.0, 1.0}) {
                vehicle.wheels.push_back({m_kit.place(wheel, glm::dmat4(1.0)),
                                          axle + glm::dvec3(0.0, 0.0, side * half_gauge), radius});
            }
        }
        m_movers.vehicles.push_back(vehicle);
    }

    Kit& m_kit;
    Movers& m_movers;
    std::size_t m_wheel;
    std::size_t m_tram_wheel;
    std::vector<std::size_t> m_tram;
    std::vector<std::vector<std::size_t>> m_cars;
};

/// Cars of one lane, the foremost first; at its end they queue.
void add_lane(Depot& depot, double z, bool is_eastward, double speed,
              const std::vector<double>& starts) {
    for (std::size_t i = 0; i < starts.size(); ++i) {
        const double stop = kStreetEnd - 6.5 * static_cast<double>(i);
        depot.add_moving_car(
            {{is_eastward ? starts[i] : -starts[i], 0.0, z}, is_eastward, speed, stop - starts[i]},
            i * 3 + (is_eastward ? 0u : 1u));
    }
}

} // namespace

void add_vehicles(Kit& kit, Movers& movers) {
    Depot depot(kit, movers);
    add_lane(depot, kLaneZ, true, 6.5,
             {-20.0, -90.0, -140.0, -165.0, -196.0, -208.0, -260.0, -330.0, -420.0, -520.0});
    add_lane(depot, -kLaneZ, false, 7.5,
             {185.0, 160.0, 140.0, 80.0, 20.0, -60.0, -130.0, -220.0, -330.0, -450.0});
    add_lane(depot, kPitch + 2.8, true, 8.0, {150.0, -100.0, -300.0, -500.0});
    add_lane(depot, -kPitch - 2.8, false, 8.0, {100.0, -200.0, -400.0});
    depot.add_moving_tram({{-228.0, 0.0, kTrackZ}, true, 6.0, 780.0});
    depot.add_moving_tram({{-60.0, 0.0, -kTrackZ}, false, 6.0, 480.0});
    // Parked in the cross streets, on the right.
    SplitMix random = kit.make_random(0xca5u);
    const int parked = std::min(kit.count(6.0, 3), 14);
    for (int street = -4; street <= 4; ++street) {
        for (int row = -5; row < 5; ++row) {
            for (int i = 0; i < parked; ++i) {
                const double z = kPitch * (row + 0.5) - 42.0 + 84.0 * i / (parked - 1);
                const glm::dvec3 place(kPitch * street + kHalfCarriageway - 1.05, 0.0,
                                       z + random.draw(-0.3, 0.3));
                const auto paint = static_cast<std::size_t>(random.draw_index(4));
                const int turns = random.draw_unit() < 0.8 ? 1 : 3;
                if (measure_distance_to_route(place) < kit.reach_m()) {
                    depot.add_parked_car(make_frame(place, turns), paint);
                }
            }
        }
    }
}

} // namespace alcove::city
