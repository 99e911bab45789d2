#include "scenes/city/elements.hpp"
#include "scenes/city/vehicle_shapes.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace alcove::city {
namespace {

constexpr double kLaneZ = 4.1;       ///< axis of a lane for cars
constexpr double kStreetEnd = 590.0; ///< where the first of a lane stops

class Depot {
  public:
    Depot(Kit& kit, Movers& movers)
        : m_kit(kit), m_movers(movers), m_wheel(kit.add_mesh(make_wheel(kit, kCarWheel))),
          m_tram_wheel(kit.add_mesh(make_wheel(kit, kTramWheel))), m_tram(add_tram(kit)) {
        for (const glm::vec3& paint :
             {glm::vec3(0.55f, 0.1f, 0.09f), glm::vec3(0.62f, 0.63f, 0.64f),
              glm::vec3(0.1f, 0.2f, 0.42f), glm::vec3(0.66f, 0.55f, 0.2f)}) {
            m_cars.push_back(add_car(kit, paint));
        }
    }

    void add_moving_car(const Drive& drive, std::size_t paint) {
        add(m_cars[paint % m_cars.size()], drive, m_wheel, kCarWheel,
            {{-1.25, kCarWheel, 0.0}, {1.3, kCarWheel, 0.0}}, 0.72);
    }
    void add_moving_tram(const Drive& drive) {
        // The wheels stand on rails that are 0.025 m high.
        add(m_tram, drive, m_tram_wheel, kTramWheel,
            {{-5.3, 0.35, 0.0}, {-3.9, 0.35, 0.0}, {3.9, 0.35, 0.0}, {5.3, 0.35, 0.0}},
            0.5 * kGauge);
    }
    void add_parked_car(const glm::dmat4& frame, std::size_t paint) {
        for (const std::size_t mesh : m_cars[paint % m_cars.size()]) {
            m_kit.place(mesh, frame);
        }
        for (const double x : {-1.25, 1.3}) {
            for (const double z : {-0.72, 0.72}) {
                m_kit.place(m_wheel, shift(frame, {x, kCarWheel - 0.01, z}));
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
