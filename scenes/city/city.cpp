#include "scenes/city/city.hpp"

#include "scenes/city/elements.hpp"
#include "scenes/common/walkthrough_file.hpp"

#include <memory>
#include <utility>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

enum class Path { standard, full };

struct CityParameters {
    double detail = 1.0;
    int seed = 1;
    Path walkthrough = Path::standard;
};

ParameterTable make_table() {
    using P = CityParameters;
    return describe_parameters(
        "city", {real(&P::detail, "detail")
                     .range(0.5, 64.0)
                     .log_scale()
                     .unit("1")
                     .meaning("how far from the walkthroughs' street houses have facades, trees "
                              "and furniture stand, and how fine they all are; the city's extent "
                              "and its houses stay")
                     .source("ours"),
                 integer(&P::seed, "seed")
                     .range(0, 65535)
                     .unit("1")
                     .meaning("chooses heights, styles and colours of houses, and trees")
                     .source("ours"),
                 choice(&P::walkthrough, "walkthrough", {"default", "full"})
                     .meaning("a street and a cut to the roofs in 120 frames, or 3000 frames")
                     .source("ours")});
}

/// A rigid scene whose movers are posed from the time alone.
class CityScene final : public Scene {
  public:
    CityScene(RigidSceneContent content, city::Movers movers)
        : m_rest(std::move(content)), m_movers(std::move(movers)),
          m_objects(m_rest.get_objects().begin(), m_rest.get_objects().end()) {
        // Whatever the movers place does not keep the nothing that is handed to them.
        const glm::dmat4 nothing(0.0);
        std::vector<glm::dmat4> placed(m_objects.size(), nothing);
        city::pose_movers(m_movers, 0.0, placed);
        for (std::size_t i = 0; i < placed.size(); ++i) {
            if (placed[i] != nothing) {
                m_objects[i].motion = ObjectMotion::rigid;
            }
        }
    }

    [[nodiscard]] std::span<const Mesh> get_meshes() const override { return m_rest.get_meshes(); }
    [[nodiscard]] std::span<const Object> get_objects() const override { return m_objects; }
    [[nodiscard]] const Lights& get_lights() const override { return m_rest.get_lights(); }
    [[nodiscard]] const Walkthrough& get_walkthrough() const override {
        return m_rest.get_walkthrough();
    }
    [[nodiscard]] double get_ao_radius_m() const override { return m_rest.get_ao_radius_m(); }
    [[nodiscard]] Pose compute_pose(double time_s) const override {
        Pose pose = m_rest.compute_pose(time_s);
        city::pose_movers(m_movers, time_s, pose.object_to_world);
        return pose;
    }
    [[nodiscard]] bool is_static() const override { return false; }

  private:
    RigidScene m_rest;
    city::Movers m_movers;
    std::vector<Object> m_objects; ///< those of m_rest, with what moves
};

std::unique_ptr<Scene> open_city(const ResolvedParameters& resolved) {
    const auto parameters = make_table().bind<CityParameters>(resolved);
    city::Kit kit(parameters.detail, parameters.seed);
    const city::Plan plan = city::make_plan(kit);
    const std::vector<city::Style> styles = city::make_styles(kit);
    city::Movers movers;
    city::add_ground(kit, plan);
    city::add_houses(kit, plan, styles);
    city::add_facades(kit, plan, styles);
    city::add_church(kit, plan);
    city::add_trees(kit, plan);
    city::add_furniture(kit, plan);
    city::add_vehicles(kit, movers);
    city::add_figures(kit, movers);
    RigidSceneContent content = kit.take();
    content.lights.directional.push_back(
        {glm::normalize(glm::dvec3(-0.35, 0.8, 0.5)), glm::vec3(0.9f, 0.86f, 0.76f)});
    content.lights.ambient = glm::vec3(0.44f, 0.5f, 0.6f); // the sky
    content.walkthrough = get_embedded_walkthrough(parameters.walkthrough == Path::standard
                                                       ? "scenes/city/walkthrough.json"
                                                       : "scenes/city/walkthrough_full.json");
    content.ao_radius_m = 0.75;
    return std::make_unique<CityScene>(std::move(content), std::move(movers));
}

} // namespace

SceneUnit city_unit() {
    SceneUnit unit;
    unit.name = "city";
    unit.title = "City with traffic";
    unit.stresses = "depth from 0.2 m to more than 1 km in one image, relief far narrower than a "
                    "pixel, foliage, many instances, vehicles and walking figures";
    unit.license = "CC0-1.0, built by this program";
    unit.parameters = make_table();
    unit.open = open_city;
    return unit;
}

} // namespace alcove
