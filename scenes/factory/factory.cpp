#include "scenes/factory/factory.hpp"

#include "scenes/common/walkthrough_file.hpp"
#include "scenes/factory/elements.hpp"

#include <memory>
#include <utility>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

struct FactoryParameters {
    double detail = 1.0;
};

/// With which the hall has the 537,000 polygons of: T. Ritschel, T. Grosch, H.-P. Seidel.
/// Approximating Dynamic Global Illumination in Image Space. 2009, table 1; within 3 %.
constexpr double kHighestDetail = 30.0;

ParameterTable make_table() {
    return describe_parameters("factory", {real(&FactoryParameters::detail, "detail")
                                               .range(0.5, kHighestDetail)
                                               .log_scale()
                                               .unit("1")
                                               .meaning("number of triangles of curved parts, "
                                                        "gratings and teeth, about, relative to "
                                                        "the default")
                                               .source("ours")});
}

std::unique_ptr<Scene> open_factory(const ResolvedParameters& resolved) {
    const factory::Fineness fineness(make_table().bind<FactoryParameters>(resolved).detail);
    SceneKit kit;
    factory::add_hall(kit, fineness);
    factory::add_pipes(kit, fineness);
    factory::add_machines(kit, fineness);
    factory::add_gantry(kit, fineness);
    factory::add_moving_parts(kit, fineness);
    RigidSceneContent content = kit.take();
    content.lights.directional.push_back(
        {glm::normalize(glm::dvec3(-0.5, 0.8, -0.6)), glm::vec3(0.8f, 0.78f, 0.72f)});
    content.lights.ambient = glm::vec3(0.46f, 0.48f, 0.5f);
    content.walkthrough = get_embedded_walkthrough("scenes/factory/walkthrough.json");
    content.ao_radius_m = 0.5;
    return std::make_unique<RigidScene>(std::move(content));
}

} // namespace

SceneUnit factory_unit() {
    SceneUnit unit;
    unit.name = "factory";
    unit.title = "Hall of pipes and machines";
    unit.stresses = "pipes before pipes before walls, railings and gratings narrower than a pixel, "
                    "round bodies that touch, a crane and a wheel that move";
    unit.license = "CC0-1.0, built by this program";
    unit.parameters = make_table();
    unit.open = open_factory;
    return unit;
}

} // namespace alcove
