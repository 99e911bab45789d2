#include "harness/run/radiance_store.hpp"

#include "tests/harness/temporary_folder.hpp"
#include "tests/test_scenes.hpp"

#include <gtest/gtest.h>

namespace alcove {
namespace {

constexpr ImageSize kSize{32, 24};

PathSettings make_settings() {
    PathSettings settings;
    settings.radius_m = 0.5;
    settings.rays_per_half = 16;
    return settings;
}

/// The boxes under other surroundings.
class LitScene final : public Scene {
  public:
    explicit LitScene(float ambient) : m_scene(make_box_scene()), m_lights(m_scene.get_lights()) {
        m_lights.ambient = glm::vec3(ambient);
    }
    [[nodiscard]] std::span<const Mesh> get_meshes() const override { return m_scene.get_meshes(); }
    [[nodiscard]] std::span<const Object> get_objects() const override {
        return m_scene.get_objects();
    }
    [[nodiscard]] const Lights& get_lights() const override { return m_lights; }
    [[nodiscard]] const Walkthrough& get_walkthrough() const override {
        return m_scene.get_walkthrough();
    }
    [[nodiscard]] double get_ao_radius_m() const override { return m_scene.get_ao_radius_m(); }
    [[nodiscard]] Pose compute_pose(double time_s) const override {
        return m_scene.compute_pose(time_s);
    }

  private:
    TestScene m_scene;
    Lights m_lights;
};

class Radiances : public testing::Test {
  protected:
    ReferencePair get(const Scene& scene, const PathSettings& settings,
                      const char* tracer = "tracer-hash") {
        // A store of its own: what it finds, it finds on disk.
        RadianceStore store(m_folder.path(), tracer);
        return store.get(scene, make_frame_view(scene.get_walkthrough(), 0, kSize, true), settings,
                         m_was_cached);
    }

    TemporaryFolder m_folder;
    bool m_was_cached = false;
};

TEST_F(Radiances, AreDirectLightAndEachHalfReadBackBitForBit) {
    const LitScene scene(0.5f);
    const ReferencePair traced = get(scene, make_settings());
    EXPECT_FALSE(m_was_cached);
    EXPECT_EQ(traced.a.channels(), 3);
    PathTracer tracer;
    tracer.update(pose_geometry(scene, 0.0));
    const FrameView view = make_frame_view(scene.get_walkthrough(), 0, kSize, true);
    const TracedRadiance expected =
        tracer.trace(view.camera, kSize, scene.get_lights(), make_settings());
    for (std::size_t i = 0; i < traced.a.values().size(); ++i) {
        ASSERT_EQ(traced.a.values()[i],
                  expected.indirect.a.values()[i] + expected.direct.values()[i]);
        ASSERT_EQ(traced.b.values()[i],
                  expected.indirect.b.values()[i] + expected.direct.values()[i]);
    }
    const ReferencePair cached = get(scene, make_settings());
    EXPECT_TRUE(m_was_cached);
    EXPECT_EQ(hash_image(traced.a), hash_image(cached.a));
    EXPECT_EQ(hash_image(traced.b), hash_image(cached.b));
    EXPECT_NE(hash_image(traced.a), hash_image(traced.b));
}

TEST_F(Radiances, LightsAndEverySettingAreInTheKey) {
    const LitScene scene(0.5f);
    static_cast<void>(get(scene, make_settings()));
    const auto expect_new = [&](const char* what, const Scene& other, const PathSettings& settings,
                                const char* tracer = "tracer-hash") {
        static_cast<void>(get(other, settings, tracer));
        EXPECT_FALSE(m_was_cached) << what;
        static_cast<void>(get(other, settings, tracer));
        EXPECT_TRUE(m_was_cached) << what;
    };
    expect_new("lights", LitScene(0.25f), make_settings());
    expect_new("tracer", scene, make_settings(), "another");
    PathSettings settings = make_settings();
    settings.radius_m = 0.75;
    expect_new("radius", scene, settings);
    settings = make_settings();
    settings.falloff = Falloff::none;
    expect_new("falloff", scene, settings);
    settings = make_settings();
    settings.reach = PathReach::full;
    expect_new("reach", scene, settings);
    settings = make_settings();
    settings.normals = Normals::geometric;
    expect_new("normals", scene, settings);
    settings = make_settings();
    settings.bounces = 0;
    expect_new("bounces", scene, settings);
    settings = make_settings();
    settings.rays_per_half = 32;
    expect_new("rays", scene, settings);
    settings = make_settings();
    settings.seed = 1;
    expect_new("seed", scene, settings);
    settings = make_settings();
    settings.terminator_safe = false;
    expect_new("terminator", scene, settings);
}

} // namespace
} // namespace alcove
