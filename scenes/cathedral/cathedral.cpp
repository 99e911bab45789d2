#include "scenes/cathedral/cathedral.hpp"

#include "scenes/cathedral/elements.hpp"
#include "scenes/cathedral/guests.hpp"
#include "scenes/common/walkthrough_file.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <string_view>
#include <utility>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

enum class Path { standard, walk_and_rest, full };

struct CathedralParameters {
    double detail = 1.0;
    int seed = 1;
    Path walkthrough = Path::standard;
};

ParameterTable make_table() {
    using P = CathedralParameters;
    return describe_parameters(
        "cathedral",
        {real(&P::detail, "detail")
             .range(0.125, 256.0)
             .log_scale()
             .unit("1")
             .meaning("number of vertices of curved parts, relative to the default; also the "
                      "number of balusters and, above 8, of chairs and candles")
             .source("ours"),
         integer(&P::seed, "seed")
             .range(0, 65535)
             .unit("1")
             .meaning("chooses sizes of ornament and wear, and which column stands where")
             .source("ours"),
         choice(&P::walkthrough, "walkthrough", {"default", "walk_and_rest", "full"})
             .meaning("the length of the church, 300 frames of slow walk and 300 of rest, or 3500 "
                      "frames through all of it with a walking skeleton and a bunny")
             .source("ours")});
}

std::string_view get_file(Path path) {
    constexpr std::array<std::string_view, 3> kFiles{
        "scenes/cathedral/walkthrough.json", "scenes/cathedral/walkthrough_walk_and_rest.json",
        "scenes/cathedral/walkthrough_full.json"};
    return kFiles.at(static_cast<std::size_t>(path));
}

std::unique_ptr<Scene> open_cathedral(const ResolvedParameters& resolved) {
    const auto parameters = make_table().bind<CathedralParameters>(resolved);
    cathedral::Kit kit(parameters.detail, parameters.seed);
    cathedral::add_walls(kit);
    cathedral::add_windows(kit);
    cathedral::add_columns(kit);
    cathedral::add_vaults(kit);
    cathedral::add_ribs(kit);
    cathedral::add_apse(kit);
    cathedral::add_choir(kit);
    cathedral::add_furniture(kit);
    cathedral::add_aisle_furniture(kit);
    RigidSceneContent content = kit.take();
    // Light as from the clerestory; it casts no shadow (DirectionalLight), so that it reaches the
    // room at all.
    content.lights.directional.push_back(
        {glm::normalize(glm::dvec3(-0.45, 0.75, 0.4)), glm::vec3(0.9f, 0.85f, 0.75f)});
    content.lights.ambient = glm::vec3(0.34f, 0.36f, 0.4f);
    content.walkthrough = get_embedded_walkthrough(get_file(parameters.walkthrough));
    content.ao_radius_m = 0.5;
    if (parameters.walkthrough == Path::full) {
        return std::make_unique<AnimatedScene>(cathedral::add_guests(std::move(content)));
    }
    return std::make_unique<RigidScene>(std::move(content));
}

} // namespace

SceneUnit cathedral_unit() {
    SceneUnit unit;
    unit.name = "cathedral";
    unit.title = "Cathedral interior";
    unit.stresses =
        "thin balusters and tracery before far background, fluted columns, deep concave "
        "ribs, large plane walls at grazing angles, depth from 0.5 m to 35 m in one image";
    unit.license = "CC0-1.0, built by this program";
    unit.parameters = make_table();
    unit.open = open_cathedral;
    return unit;
}

} // namespace alcove
