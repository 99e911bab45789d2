#include "scenes/moving_objects/moving_objects.hpp"

#include "scenes/common/rigid_scene.hpp"
#include "scenes/common/solids.hpp"
#include "scenes/common/walkthrough_file.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace alcove {
namespace {

enum class Path { clip, shake, zoom, aba, teleport, cut };

struct MovingObjectsParameters {
    Path walkthrough = Path::clip;
};

/// Of the enumerators and, after "walkthrough_", of the files.
std::vector<std::string> list_walkthroughs() {
    return {"clip", "shake", "zoom", "aba", "teleport", "cut"};
}

ParameterTable make_table() {
    return describe_parameters(
        "moving_objects",
        {choice(&MovingObjectsParameters::walkthrough, "walkthrough", list_walkthroughs())
             .meaning("all objects move, or hand-held shake, a fast zoom, from A to B and back, "
                      "one box jumping by 2 m, a hard cut")
             .source("ours")});
}

/// Objects that touch floor or wall are sunk into it by this many metres: in contact, without two
/// faces in one plane.
constexpr double kSink = 0.004;
/// What never moves is sunk deeper.
constexpr double kFoundation = 0.05;

class Stage {
  public:
    void add(Mesh mesh, const glm::dvec3& position) {
        m_content.objects.push_back({mesh.name, m_content.meshes.size()});
        m_content.meshes.push_back(std::move(mesh));
        m_content.transforms.push_back(glm::translate(glm::dmat4(1.0), position));
    }

    /// `size` above the floor or, for the box in the air, about its middle.
    void add_box(const char* name, const glm::vec3& albedo, const glm::dvec3& position,
                 const glm::dvec3& size, double sink) {
        const glm::dvec3 half = 0.5 * size;
        add(make_box_mesh(name, albedo, {-half.x, -sink, -half.z}, {half.x, size.y, half.z}),
            position);
    }

    [[nodiscard]] RigidSceneContent take() { return std::move(m_content); }

  private:
    RigidSceneContent m_content;
};

RigidSceneContent build_stage() {
    constexpr double kWallFront = -2.5; // z of the wall's face
    constexpr glm::vec3 kGrey(0.6f);
    constexpr glm::vec3 kWhite(0.75f);
    constexpr glm::vec3 kDark(0.4f, 0.4f, 0.42f);
    constexpr glm::vec3 kClay(0.55f, 0.4f, 0.34f);
    constexpr glm::vec3 kWood(0.7f, 0.52f, 0.34f);
    constexpr glm::vec3 kRed(0.7f, 0.36f, 0.3f);
    constexpr glm::vec3 kGreen(0.42f, 0.62f, 0.4f);
    constexpr glm::vec3 kBlue(0.38f, 0.5f, 0.7f);
    constexpr glm::vec3 kYellow(0.75f, 0.65f, 0.32f);
    Stage stage;
    stage.add(make_box_mesh("floor", kGrey, {-6.0, -0.25, -4.0}, {6.0, 0.0, 6.0}), glm::dvec3(0.0));
    stage.add(make_box_mesh("wall", kWhite, {-5.5, -kFoundation, kWallFront - 0.25},
                            {5.5, 2.6, kWallFront}),
              glm::dvec3(0.0));
    stage.add_box("post", kDark, {0.0, 0.0, -0.7}, {0.3, 1.6, 0.3}, kFoundation);
    MeshBuilder column;
    add_lathe(column, {{0.12, -kFoundation}, {0.12, 2.2}}, 32);
    stage.add(column.finish("column", kClay, 30.0), {-0.9, 0.0, -1.8});
    stage.add_box("stand", kDark, {2.3, 0.0, -1.6}, {0.24, 1.15, 0.2}, kFoundation);

    stage.add_box("spinner", kRed, {-2.3, 0.0, -0.4}, {0.7, 0.8, 0.5}, kSink);
    stage.add(make_box_mesh("bar", kYellow, {-0.65, -0.11, -0.11}, {0.65, 0.11, 0.11}),
              {2.3, 1.0, -1.3});
    stage.add_box("passing box", kBlue, {-1.2, 0.0, -1.4}, {0.5, 0.5, 0.5}, kSink);
    MeshBuilder vase;
    add_lathe(vase,
              {{0.14, -kSink}, {0.22, 0.12}, {0.26, 0.3}, {0.22, 0.48}, {0.12, 0.6}, {0.16, 0.7}},
              40);
    stage.add(vase.finish("vase", kGreen, 60.0), {1.2, 0.0, -0.7});
    stage.add_box("lifted box", kWood, {-1.0, 0.0, 0.5}, {0.6, 0.6, 0.6}, kSink);
    stage.add(make_box_mesh("wall box", kRed, {-0.25, -0.25, -kSink}, {0.25, 0.25, 0.5}),
              {-2.2, 1.55, kWallFront});
    return stage.take();
}

std::unique_ptr<Scene> open_moving_objects(const ResolvedParameters& resolved) {
    const auto parameters = make_table().bind<MovingObjectsParameters>(resolved);
    RigidSceneContent content = build_stage();
    content.lights.directional.push_back(
        {glm::normalize(glm::dvec3(0.45, 1.0, 0.7)), glm::vec3(1.0f)});
    content.lights.ambient = glm::vec3(0.5f);
    content.walkthrough = get_embedded_walkthrough(
        "scenes/moving_objects/walkthrough_" +
        list_walkthroughs().at(static_cast<std::size_t>(parameters.walkthrough)) + ".json");
    content.ao_radius_m = 0.5;
    return std::make_unique<RigidScene>(std::move(content));
}

} // namespace

SceneUnit moving_objects_unit() {
    SceneUnit unit;
    unit.name = "moving_objects";
    unit.title = "Stage of moving objects";
    unit.stresses = "reprojection: every rigid motion at once with occlusion and disocclusion, or "
                    "camera shake, zoom, return, jump and cut over a stage at rest";
    unit.license = "CC0-1.0, built by this program";
    unit.parameters = make_table();
    unit.open = open_moving_objects;
    return unit;
}

} // namespace alcove
