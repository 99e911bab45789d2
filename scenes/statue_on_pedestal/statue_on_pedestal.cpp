#include "scenes/statue_on_pedestal/statue_on_pedestal.hpp"

#include "scenes/common/knight.hpp"
#include "scenes/common/knot.hpp"
#include "scenes/common/pedestal.hpp"
#include "scenes/common/rigid_scene.hpp"
#include "scenes/common/solids.hpp"
#include "scenes/common/walkthrough_file.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

namespace alcove {
namespace {

enum class Piece { knight, knot };

struct StatueOnPedestalParameters {
    Piece piece = Piece::knight;
    double detail = 1.0;
};

ParameterTable make_table() {
    using P = StatueOnPedestalParameters;
    return describe_parameters(
        "statue_on_pedestal",
        {choice(&P::piece, "piece", {"knight", "knot"})
             .meaning("a knight in stone with cloak, sword and shield, or a carved trefoil knot")
             .source("ours"),
         real(&P::detail, "detail")
             .range(0.1, 16.0)
             .log_scale()
             .unit("1")
             .meaning("number of the statue's vertices, relative to the default")
             .source("ours")});
}

constexpr double kTop = 1.1;    ///< of the pedestal, metres
constexpr double kPlate = 0.09; ///< the statue's own base
constexpr double kSink = 0.008;
constexpr double kCycles = 0.08; ///< of the gait that the knight stands in: both feet stand
constexpr glm::vec3 kStone(0.66f, 0.64f, 0.6f);

void append_mesh(Mesh& all, std::span<const glm::vec3> positions,
                 std::span<const glm::vec3> normals, std::span<const std::uint32_t> indices) {
    const auto first = static_cast<std::uint32_t>(all.positions.size());
    all.positions.insert(all.positions.end(), positions.begin(), positions.end());
    all.normals.insert(all.normals.end(), normals.begin(), normals.end());
    for (const std::uint32_t index : indices) {
        all.indices.push_back(first + index);
    }
}

/// A knight turned to stone in mid-stride; y = 0 is its ground.
Mesh carve_knight(double detail) {
    AnimatedSceneContent content;
    KnightTroop troop(detail);
    CircleWalk walk;
    walk.radius = 1e4; // all but straight
    walk.phase = kCycles;
    walk.centre = {0.0, 0.0, -walk.radius};
    troop.add_knight(content, troop.add_look(content, {}), walk, "knight", 0);
    std::vector<glm::dmat4> nodes;
    troop.append_nodes(0.0, nodes);
    Mesh statue;
    statue.name = "statue";
    statue.albedo = kStone;
    statue.closed = true;
    for (std::size_t i = 0; i < content.objects.size(); ++i) {
        const AnimatedObject& object = content.objects[i];
        const Mesh& mesh = content.meshes[object.object.mesh];
        Deformation shape{mesh.positions, mesh.normals};
        if (object.object.motion == ObjectMotion::deforming) {
            shape = deform_object(content, i, nodes, 0.0);
        }
        if (!object.skin) { // a rotation and a shift
            const glm::dmat4& place = nodes[object.node];
            for (std::size_t k = 0; k < shape.positions.size(); ++k) {
                shape.positions[k] =
                    glm::vec3(place * glm::dvec4(glm::dvec3(shape.positions[k]), 1.0));
                shape.normals[k] = glm::vec3(glm::dmat3(place) * glm::dvec3(shape.normals[k]));
            }
        }
        append_mesh(statue, shape.positions, shape.normals, mesh.indices);
    }
    return statue;
}

std::unique_ptr<Scene> open_statue_on_pedestal(const ResolvedParameters& resolved) {
    const auto parameters = make_table().bind<StatueOnPedestalParameters>(resolved);
    const int rounds =
        std::clamp(static_cast<int>(std::lround(6.0 * std::sqrt(parameters.detail))), 2, 40);
    RigidSceneContent content;
    content.meshes.push_back(
        make_box_mesh("floor", {0.55f, 0.54f, 0.52f}, {-8.0, -0.3, -8.0}, {8.0, 0.0, 8.0}));
    content.meshes.push_back(
        make_pedestal("pedestal", {0.6f, 0.58f, 0.54f}, kTop, 0.6, 0.5, rounds));
    content.meshes.push_back(
        make_box_mesh("base", kStone, {-0.48, kTop - kSink, -0.38}, {0.48, kTop + kPlate, 0.38}));
    content.meshes.push_back(parameters.piece == Piece::knight
                                 ? carve_knight(parameters.detail)
                                 : make_knot(parameters.detail, kStone));
    content.objects = {{"floor", 0}, {"pedestal", 1}, {"base", 2}, {"statue", 3}};
    content.transforms.assign(content.objects.size(), glm::dmat4(1.0));
    content.transforms.back() = glm::translate(glm::dmat4(1.0), {0.0, kTop + kPlate - kSink, 0.0});
    content.lights.directional.push_back(
        {glm::normalize(glm::dvec3(0.7, 0.8, 0.5)), glm::vec3(0.95f, 0.92f, 0.85f)});
    content.lights.ambient = glm::vec3(0.48f, 0.5f, 0.54f);
    content.walkthrough = get_embedded_walkthrough("scenes/statue_on_pedestal/walkthrough.json");
    content.ao_radius_m = 0.25;
    return std::make_unique<RigidScene>(std::move(content));
}

} // namespace

SceneUnit statue_on_pedestal_unit() {
    SceneUnit unit;
    unit.name = "statue_on_pedestal";
    unit.title = "Statue on a moulded pedestal";
    unit.stresses = "occlusion at every scale of one model: from the joints of armour to the whole "
                    "statue over the floor; ray lengths from 1/80 of the model to all of it";
    unit.license = "CC0-1.0, built by this program";
    unit.parameters = make_table();
    unit.open = open_statue_on_pedestal;
    return unit;
}

} // namespace alcove
