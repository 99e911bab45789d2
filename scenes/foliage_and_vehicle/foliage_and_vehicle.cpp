#include "scenes/foliage_and_vehicle/foliage_and_vehicle.hpp"

#include "scenes/common/walkthrough_file.hpp"
#include "scenes/foliage_and_vehicle/elements.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace alcove {

int foliage::Settings::segments(int at_one) const {
    return std::max(3, static_cast<int>(std::lround(at_one * std::sqrt(detail))));
}

int foliage::Settings::count(int at_one) const {
    return std::max(1, static_cast<int>(std::lround(at_one * detail)));
}

namespace {

/// With which the scene has the million polygons of: P. Shanmugam, O. Arikan. Hardware Accelerated
/// Ambient Occlusion Techniques on GPUs. 2007, figure 1c; within 3 %.
constexpr double kHighestDetail = 23.4;

ParameterTable make_table() {
    using P = foliage::Settings;
    return describe_parameters(
        "foliage_and_vehicle",
        {real(&P::detail, "detail")
             .range(0.25, kHighestDetail)
             .log_scale()
             .unit("1")
             .meaning("number of leaves, blades and triangles of curved parts, about, relative "
                      "to the default; with more, leaves are smaller")
             .source("ours"),
         integer(&P::seed, "seed")
             .range(0, 65535)
             .unit("1")
             .meaning("chooses branches, leaves and where grass stands")
             .source("ours")});
}

/// The car drives this far over the walkthrough, metres.
constexpr double kWay = 1.8;

void add_drive(Walkthrough& walkthrough, const foliage::Car& car) {
    const int last = static_cast<int>(walkthrough.cameras.size()) - 1;
    const glm::dvec3 way(kWay, 0.0, 0.0);
    const auto add = [&](const std::string& object, const glm::dvec3& pivot, double degrees) {
        walkthrough.tracks.push_back(
            {object, pivot, {0.0, 0.0, 1.0}, {{0, glm::dvec3(0.0), 0.0}, {last, way, degrees}}});
    };
    for (const std::string& body : car.bodies) {
        add(body, glm::dvec3(0.0), 0.0);
    }
    for (const foliage::Car::Wheel& wheel : car.wheels) {
        for (const std::string& part : wheel.parts) {
            add(part, wheel.axle, -glm::degrees(kWay / foliage::kWheel));
        }
    }
    walkthrough.events.push_back({0, "car drives"});
}

std::unique_ptr<Scene> open_foliage_and_vehicle(const ResolvedParameters& resolved) {
    const auto settings = make_table().bind<foliage::Settings>(resolved);
    SceneKit kit;
    foliage::add_ground(kit, settings);
    foliage::add_trees(kit, settings);
    const foliage::Car car = foliage::add_car(kit, settings, -1.0);
    RigidSceneContent content = kit.take();
    content.lights.directional.push_back(
        {glm::normalize(glm::dvec3(0.4, 1.0, 0.7)), glm::vec3(0.95f, 0.9f, 0.8f)});
    content.lights.ambient = glm::vec3(0.46f, 0.52f, 0.6f);
    content.walkthrough = get_embedded_walkthrough("scenes/foliage_and_vehicle/walkthrough.json");
    add_drive(content.walkthrough, car);
    content.ao_radius_m = 0.4;
    return std::make_unique<RigidScene>(std::move(content));
}

} // namespace

SceneUnit foliage_and_vehicle_unit() {
    SceneUnit unit;
    unit.name = "foliage_and_vehicle";
    unit.title = "Car between trees";
    unit.stresses = "leaves and blades narrower than a pixel before a far background, depth that "
                    "jumps from pixel to pixel, a smooth moving body beside it";
    unit.license = "CC0-1.0, built by this program";
    unit.parameters = make_table();
    unit.open = open_foliage_and_vehicle;
    return unit;
}

} // namespace alcove
