#include "scenes/molecule/molecule.hpp"

#include "scenes/common/round_solids.hpp"
#include "scenes/common/scene_kit.hpp"
#include "scenes/common/walkthrough_file.hpp"
#include "scenes/molecule/fold.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

enum class Path { orbit, turning };

struct MoleculeParameters {
    int atoms = 400;
    int seed = 1;
    Path walkthrough = Path::orbit;
};

/// The molecule fits into a ball of this radius, metres, whatever its number of atoms.
constexpr double kExtent = 1.0;

ParameterTable make_table() {
    using P = MoleculeParameters;
    return describe_parameters(
        "molecule",
        {integer(&P::atoms, "atoms")
             .range(100, 10000)
             .log_scale()
             .unit("1")
             .meaning("balls, 320 triangles each; the molecule keeps its extent")
             .source("ours; Shanmugam and Arikan 2007, figure 1"),
         integer(&P::seed, "seed")
             .range(0, 65535)
             .unit("1")
             .meaning("chooses the fold and the elements")
             .source("ours"),
         choice(&P::walkthrough, "walkthrough", {"orbit", "turning"})
             .meaning("the camera goes around a molecule at rest, or the molecule turns before "
                      "a still camera")
             .source("ours")});
}

/// Every atom turns with the others, by a third of a circle.
void add_turn(Walkthrough& walkthrough, const std::vector<Object>& objects) {
    const int last = static_cast<int>(walkthrough.cameras.size()) - 1;
    for (const Object& object : objects) {
        ObjectTrack track;
        track.object = object.name;
        track.keys = {{0, glm::dvec3(0.0), 0.0}, {last, glm::dvec3(0.0), 120.0}};
        walkthrough.tracks.push_back(std::move(track));
    }
}

std::unique_ptr<Scene> open_molecule(const ResolvedParameters& resolved) {
    const auto parameters = make_table().bind<MoleculeParameters>(resolved);
    const std::vector<molecule::Atom> atoms = molecule::fold(parameters.atoms, parameters.seed);
    double reach = 0.0;
    double summed_radii = 0.0;
    for (const molecule::Atom& atom : atoms) {
        const double radius = molecule::kElements[atom.element].radius;
        reach = std::max(reach, glm::length(atom.position) + radius);
        summed_radii += radius;
    }
    const double scale = kExtent / reach;
    SceneKit kit;
    std::array<std::size_t, molecule::kElements.size()> meshes{};
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        const molecule::Element& element = molecule::kElements[i];
        meshes[i] = kit.add_mesh(make_ball_mesh(element.name, element.albedo, 2));
    }
    for (const molecule::Atom& atom : atoms) {
        const double radius = scale * molecule::kElements[atom.element].radius;
        kit.place(meshes[atom.element], make_place(scale * atom.position, 0.0, glm::dvec3(radius)));
    }
    RigidSceneContent content = kit.take();
    content.lights.directional.push_back(
        {glm::normalize(glm::dvec3(0.4, 1.0, 0.7)), glm::vec3(0.8f)});
    content.lights.ambient = glm::vec3(0.55f);
    content.walkthrough = get_embedded_walkthrough(
        parameters.walkthrough == Path::orbit ? "scenes/molecule/walkthrough.json"
                                              : "scenes/molecule/walkthrough_turning.json");
    if (parameters.walkthrough == Path::turning) {
        add_turn(content.walkthrough, content.objects);
    }
    // An atom: from any surface into the gaps beside it.
    content.ao_radius_m = 2.0 * scale * summed_radii / static_cast<double>(atoms.size());
    return std::make_unique<RigidScene>(std::move(content));
}

} // namespace

SceneUnit molecule_unit() {
    SceneUnit unit;
    unit.name = "molecule";
    unit.title = "Molecule of overlapping balls";
    unit.stresses = "many small convex occluders whose occlusion is known as balls, sharp creases "
                    "where they meet, gaps on every scale, an outline before the open background";
    unit.license = "CC0-1.0, built by this program";
    unit.parameters = make_table();
    unit.open = open_molecule;
    return unit;
}

} // namespace alcove
