#include "scenes/common/gltf_export.hpp"

#include "core/base/file.hpp"
#include "scenes/common/gltf_scene.hpp"
#include "scenes/common/lighting.hpp"
#include "scenes/common/rigid_scene.hpp"
#include "scenes/common/walkthrough_file.hpp"
#include "scenes/common/walkthrough_writer.hpp"
#include "scenes/registry.hpp"
#include "tests/scenes/common/gltf_fixture.hpp"

#include <algorithm>
#include <array>
#include <set>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <nlohmann/json.hpp>

namespace alcove {
namespace {

class GltfExport : public GltfTest {
  protected:
    [[nodiscard]] std::unique_ptr<Scene> reopen(const Scene& scene) {
        m_lost = export_gltf(scene, m_folder / "out.glb");
        std::unique_ptr<Scene> back = open_gltf_scene(m_folder / "out.glb", {}, &m_warnings);
        check_scene(*back, "out.glb");
        return back;
    }

    std::set<std::string> m_lost;
};

std::unique_ptr<Scene> open_unit(const char* name, const std::vector<ParameterOverride>& values) {
    const Registry<SceneUnit> scenes = scenes_registry();
    const SceneUnit& unit = scenes.find(name);
    return unit.open(unit.parameters.resolve(values, {}));
}

double find_difference(const glm::dmat4& a, const glm::dmat4& b) {
    double largest = 0.0;
    for (int i = 0; i < 16; ++i) {
        largest = std::max(largest, std::abs(a[i / 4][i % 4] - b[i / 4][i % 4]));
    }
    return largest;
}

/// Opening a file may sort them into clusters.
std::multiset<std::array<std::uint32_t, 3>> list_triangles(const Mesh& mesh) {
    std::multiset<std::array<std::uint32_t, 3>> triangles;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        std::array<std::uint32_t, 3> triangle{mesh.indices[i], mesh.indices[i + 1],
                                              mesh.indices[i + 2]};
        std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()),
                    triangle.end());
        triangles.insert(triangle);
    }
    return triangles;
}

void expect_same(const Scene& scene, const Scene& back) {
    ASSERT_EQ(back.get_objects().size(), scene.get_objects().size());
    for (std::size_t i = 0; i < scene.get_objects().size(); ++i) {
        const Mesh& a = scene.get_meshes()[scene.get_objects()[i].mesh];
        const Mesh& b = back.get_meshes()[back.get_objects()[i].mesh];
        EXPECT_EQ(a.positions, b.positions);
        EXPECT_EQ(list_triangles(a), list_triangles(b));
        EXPECT_EQ(a.albedo, b.albedo);
        EXPECT_EQ(a.colors, b.colors);
        EXPECT_EQ(a.texture_coordinates, b.texture_coordinates);
        EXPECT_EQ(scene.get_objects()[i].name + ".0", back.get_objects()[i].name);
    }
    const Walkthrough& walkthrough = scene.get_walkthrough();
    ASSERT_EQ(back.get_walkthrough().cameras.size(), walkthrough.cameras.size());
    for (std::size_t frame = 0; frame < walkthrough.cameras.size(); frame += 7) {
        const double time_s = static_cast<double>(frame) * walkthrough.step_s;
        const Pose a = scene.compute_pose(time_s);
        const Pose b = back.compute_pose(time_s);
        for (std::size_t i = 0; i < a.object_to_world.size(); ++i) {
            EXPECT_LT(find_difference(a.object_to_world[i], b.object_to_world[i]), 2e-6)
                << scene.get_objects()[i].name << " on frame " << frame;
        }
        const Camera& from = walkthrough.cameras[frame];
        const Camera& to = back.get_walkthrough().cameras[frame];
        EXPECT_LT(glm::distance(from.position, to.position), 1e-5) << frame;
        for (int i = 0; i < 3; ++i) {
            EXPECT_LT(glm::distance(from.world_from_view[i], to.world_from_view[i]), 1e-5);
        }
    }
}

TEST_F(GltfExport, CathedralComesBack) {
    const auto scene = open_unit("cathedral", {{"detail", "0.125", Provenance::command_line}});
    const auto back = reopen(*scene);
    expect_same(*scene, *back);
    std::set<std::size_t> shown; // instances share their mesh
    for (const Object& object : scene->get_objects()) {
        shown.insert(object.mesh);
    }
    EXPECT_EQ(back->get_meshes().size(), shown.size());
    ASSERT_EQ(back->get_lights().directional.size(), scene->get_lights().directional.size());
    EXPECT_LT(glm::distance(back->get_lights().directional[0].to_light,
                            scene->get_lights().directional[0].to_light),
              1e-9);
    EXPECT_EQ(back->get_lights().directional[0].irradiance,
              scene->get_lights().directional[0].irradiance);
}

TEST_F(GltfExport, MovingObjectsComeBackOnEveryFrame) {
    const auto scene = open_unit("moving_objects", {});
    ASSERT_FALSE(scene->is_static());
    const auto back = reopen(*scene);
    EXPECT_FALSE(back->is_static());
    expect_same(*scene, *back);
}

TEST_F(GltfExport, BunnyComesBack) {
    const Registry<SceneUnit> scenes = scenes_registry();
    if (const auto obstacle = scenes.find("bunny").find_obstacle()) {
        GTEST_SKIP() << *obstacle;
    }
    const auto scene = open_unit("bunny", {});
    expect_same(*scene, *reopen(*scene));
}

TEST_F(GltfExport, SurfacesMirroredAndFarFromZeroComeBack) {
    Mesh mesh;
    mesh.name = "sheet";
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.normals.assign(3, {0, 0, 1});
    mesh.indices = {0, 1, 2};
    mesh.albedo = {0.25f, 0.5f, 0.75f};
    mesh.colors = {{1, 0, 0}, {0, 0.125f, 0}, {0, 0, 1}};
    mesh.texture_coordinates = {{0, 0}, {2, 0}, {0, 0.5f}};
    mesh.texture = 0;
    RigidSceneContent content;
    content.meshes = {mesh};
    content.textures = {{"picture", {2, 1}, {255, 0, 7, 0, 9, 100}}};
    content.objects = {{"plain", 0}, {"mirrored", 0}};
    content.transforms = {glm::dmat4(1.0), glm::dmat4(1.0)};
    content.transforms[1][0][0] = -2.0;
    content.origin = {1e7, 0.0, -1e7};
    content.walkthrough.cameras.assign(
        60, make_look_at_camera({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 1.0, 0.1, 10.0));
    const RigidScene scene(std::move(content));
    const auto back = reopen(scene);
    expect_same(scene, *back);
    ASSERT_EQ(back->get_textures().size(), 1u);
    EXPECT_EQ(back->get_textures()[0].rgb, scene.get_textures()[0].rgb);
    EXPECT_EQ(back->get_meshes()[0].texture, std::optional<std::size_t>(0));
    EXPECT_LT(glm::distance(back->get_origin(), scene.get_origin()), 10.0);
    // The far node is told in double: nothing of it is lost.
    EXPECT_EQ(back->compute_pose(0.0).object_to_world[1],
              scene.compute_pose(0.0).object_to_world[1]);
}

/// The rules of glTF 2.0, 3.6 and 4.4 that a reader may be lax about.
TEST_F(GltfExport, FilesAreWellFormed) {
    const auto scene = open_unit("moving_objects", {});
    static_cast<void>(reopen(*scene));
    const std::string bytes = read_file(m_folder / "out.glb");
    const auto read_u32 = [&bytes](std::size_t at) {
        std::uint32_t value = 0;
        std::memcpy(&value, bytes.data() + at, 4);
        return std::size_t{value};
    };
    EXPECT_EQ(read_u32(8), bytes.size());
    const std::size_t json_size = read_u32(12);
    EXPECT_EQ(json_size % 4, 0u);
    EXPECT_EQ(read_u32(20 + json_size) % 4, 0u);
    EXPECT_EQ(28 + json_size + read_u32(20 + json_size), bytes.size());
    const auto json = nlohmann::json::parse(bytes.substr(20, json_size));
    for (const auto& view : json["bufferViews"]) {
        EXPECT_EQ(view["byteOffset"].get<std::size_t>() % 4, 0u);
        EXPECT_LE(view["byteOffset"].get<std::size_t>() + view["byteLength"].get<std::size_t>(),
                  json["buffers"][0]["byteLength"].get<std::size_t>());
    }
    for (const auto& mesh : json["meshes"]) {
        const auto& accessor =
            json["accessors"][mesh["primitives"][0]["attributes"]["POSITION"].get<std::size_t>()];
        EXPECT_EQ(accessor["min"].size(), 3u);
        EXPECT_EQ(accessor["max"].size(), 3u);
    }
    for (const auto& sampler : json["animations"][0]["samplers"]) {
        const auto& times = json["accessors"][sampler["input"].get<std::size_t>()];
        EXPECT_EQ(times["min"].size(), 1u);
        EXPECT_EQ(times["count"], scene->get_walkthrough().cameras.size() + 1);
    }
}

TEST_F(GltfExport, WalkthroughComesBack) {
    const auto scene = open_unit("moving_objects", {});
    Walkthrough written = scene->get_walkthrough();
    written.cuts = {0, 5};
    const Walkthrough back = parse_walkthrough(write_walkthrough(written), "back.json");
    ASSERT_EQ(back.cameras.size(), written.cameras.size());
    EXPECT_EQ(back.cuts, written.cuts);
    EXPECT_EQ(back.step_s, written.step_s);
    ASSERT_EQ(back.tracks.size(), written.tracks.size());
    EXPECT_EQ(back.tracks.back().keys.size(), written.tracks.back().keys.size());
    ASSERT_EQ(back.events.size(), written.events.size());
    for (std::size_t i = 0; i < written.cameras.size(); ++i) {
        EXPECT_EQ(back.cameras[i].position, written.cameras[i].position);
        EXPECT_LT(glm::distance(back.cameras[i].world_from_view[2],
                                written.cameras[i].world_from_view[2]),
                  1e-12);
    }
}

TEST_F(GltfExport, ALampThatGoesAroundComesBack) {
    Lighting lighting;
    lighting.params.lamp = LampKind::spot;
    lighting.params.lamp_speed = 60.0;
    lighting.params.lamp_level = 0.5;
    const auto scene = relight(open_unit("template_scene", {}), lighting);
    const auto back = reopen(*scene);
    const Walkthrough& walkthrough = scene->get_walkthrough();
    for (std::size_t frame = 0; frame < walkthrough.cameras.size(); frame += 5) {
        const double time_s = static_cast<double>(frame) * walkthrough.step_s;
        const PointLight lamp = scene->compute_lights(time_s).points.at(0);
        const PointLight read = back->compute_lights(time_s).points.at(0);
        EXPECT_LT(glm::distance(lamp.position, read.position), 1e-4) << frame;
        EXPECT_LT(glm::distance(lamp.cone->direction, read.cone->direction), 1e-4) << frame;
        EXPECT_LT(glm::distance(lamp.intensity, read.intensity), 1e-5f) << frame;
    }
    const DirectionalLight& sun = scene->get_lights().directional.at(0);
    EXPECT_LT(glm::distance(back->compute_lights(0.5).directional.at(0).to_light, sun.to_light),
              1e-6);
}

} // namespace
} // namespace alcove
