// Every reported scene 1e7 m away from zero looks the same within 1/255, rasterised and traced.
#include "core/contract/scene.hpp"
#include "methods/registry.hpp"
#include "scenes/registry.hpp"
#include "tests/contract/method_shot.hpp"
#include "tests/core/gl/test_context.hpp"

#include <cmath>

namespace alcove {
namespace {

/// A scene moved as a whole: transforms, cameras and origin.
class MovedScene final : public Scene {
  public:
    MovedScene(const Scene& scene, const glm::dvec3& offset)
        : m_scene(scene), m_offset(offset), m_walkthrough(scene.get_walkthrough()) {
        for (Camera& camera : m_walkthrough.cameras) {
            camera.position += offset;
        }
    }
    std::span<const Mesh> get_meshes() const override { return m_scene.get_meshes(); }
    std::span<const Object> get_objects() const override { return m_scene.get_objects(); }
    std::span<const Texture> get_textures() const override { return m_scene.get_textures(); }
    const Lights& get_lights() const override { return m_scene.get_lights(); }
    Lights compute_lights(double time_s) const override { return m_scene.compute_lights(time_s); }
    const Walkthrough& get_walkthrough() const override { return m_walkthrough; }
    double get_ao_radius_m() const override { return m_scene.get_ao_radius_m(); }
    glm::dvec3 get_origin() const override { return m_scene.get_origin() + m_offset; }
    Pose compute_pose(double time_s) const override {
        Pose pose = m_scene.compute_pose(time_s);
        for (glm::dmat4& matrix : pose.object_to_world) {
            matrix[3] += glm::dvec4(m_offset, 0.0);
        }
        return pose;
    }
    Deformation deform(std::size_t object, double time_s) const override {
        return m_scene.deform(object, time_s);
    }
    bool is_static() const override { return m_scene.is_static(); }

  private:
    const Scene& m_scene;
    glm::dvec3 m_offset;
    Walkthrough m_walkthrough;
};

class WorldOffset : public GlTest, public testing::WithParamInterface<std::string> {
  protected:
    /// Pixels that differ by more than 1/255, over frames 10 and 70.
    int count_differences(const Scene& scene, const std::string& method_name) {
        const Registry<MethodUnit> methods = methods_registry();
        const MethodUnit& unit = methods.find(method_name);
        const ResolvedParameters parameters =
            unit.parameters.resolve({}, {{"scene_radius", scene.get_ao_radius_m()}});
        const std::unique_ptr<Method> method = unit.create(context(), parameters);
        const MovedScene moved(scene, glm::dvec3(1e7, -1e7, 1e7));
        int different = 0;
        for (const int frame : {10, 70}) {
            const ShotSettings settings{{192, 144}, {frame}, nullptr};
            const Image here = shoot(context(), *method, scene, settings).visibility;
            const Image there = shoot(context(), *method, moved, settings).visibility;
            for (std::size_t i = 0; i < here.values().size(); ++i) {
                different += std::abs(here.values()[i] - there.values()[i]) > 1.0f / 255.0f ? 1 : 0;
            }
        }
        return different;
    }
};

TEST_P(WorldOffset, ImagesAreEqualWithin1Over255) {
    const Registry<SceneUnit> scenes = scenes_registry();
    const SceneUnit& unit = scenes.find(GetParam());
    if (const auto obstacle = unit.find_obstacle()) {
        GTEST_SKIP() << *obstacle;
    }
    const std::unique_ptr<Scene> scene = unit.open(unit.parameters.resolve({}, {}));
    EXPECT_EQ(count_differences(*scene, "hemisphere_ssao"), 0);
    EXPECT_EQ(count_differences(*scene, "reference_ray_traced"), 0);
}

std::vector<std::string> list_reported_scenes() {
    const Registry<SceneUnit> scenes = scenes_registry();
    std::vector<std::string> names;
    for (const SceneUnit& unit : scenes.units()) {
        if (unit.reported) {
            names.push_back(unit.name);
        }
    }
    return names;
}

INSTANTIATE_TEST_SUITE_P(All, WorldOffset, testing::ValuesIn(list_reported_scenes()),
                         [](const auto& name) { return name.param; });

} // namespace
} // namespace alcove
