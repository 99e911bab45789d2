// What surfaces carry into the G-buffer: deformation with its motion, vertex colors, textures.
#include "core/frame/scene_renderer.hpp"
#include "tests/core/gl/test_context.hpp"
#include "tests/test_scenes.hpp"

#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace alcove {
namespace {

constexpr ImageSize kSize{64, 64};
constexpr double kStretch = 0.6; ///< 1 / s
constexpr double kRise = 0.3;    ///< m / s
constexpr double kLeave = 0.9;   ///< m / s

/// A square of 8 m that faces the camera at 5 m, stretches along x and leaves along the view axis
/// by its vertices, and rises by its transform.
class StretchedScene final : public Scene {
  public:
    StretchedScene() {
        m_meshes.push_back(make_quad({-4, -4, -5}, {4, -4, -5}, {4, 4, -5}, {-4, 4, -5}));
        m_objects.push_back({"sheet", 0, ObjectMotion::deforming});
        m_lights.directional.push_back({{0.0, 0.0, 1.0}, glm::vec3(1.0f)});
        m_walkthrough.cameras.assign(4, make_look_at_camera(glm::dvec3(0.0), {0.0, 0.0, -1.0},
                                                            {0.0, 1.0, 0.0}, 1.0, 0.1, 50.0));
        m_walkthrough.cuts = {0};
    }
    [[nodiscard]] std::span<const Mesh> get_meshes() const override { return m_meshes; }
    [[nodiscard]] std::span<const Object> get_objects() const override { return m_objects; }
    [[nodiscard]] const Lights& get_lights() const override { return m_lights; }
    [[nodiscard]] const Walkthrough& get_walkthrough() const override { return m_walkthrough; }
    [[nodiscard]] double get_ao_radius_m() const override { return 0.5; }
    [[nodiscard]] bool is_static() const override { return false; }
    [[nodiscard]] Lights compute_lights(double time_s) const override {
        Lights lights = m_lights;
        lights.directional[0].to_light = {std::sin(time_s), 0.0, std::cos(time_s)};
        return lights;
    }
    [[nodiscard]] Pose compute_pose(double time_s) const override {
        return {{glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, kRise * time_s, 0.0))}};
    }
    [[nodiscard]] Deformation deform(std::size_t /*object*/, double time_s) const override {
        Deformation now{m_meshes[0].positions, m_meshes[0].normals};
        for (glm::vec3& position : now.positions) {
            position.x *= static_cast<float>(1.0 + kStretch * time_s);
            position.z -= static_cast<float>(kLeave * time_s);
        }
        return now;
    }

  private:
    std::vector<Mesh> m_meshes;
    std::vector<Object> m_objects;
    Lights m_lights;
    Walkthrough m_walkthrough;
};

/// One quad that fills the image, with a texture of 2 x 2 texels.
class TexturedScene final : public Scene {
  public:
    TexturedScene() {
        m_meshes.push_back(make_quad({-4, -4, -5}, {4, -4, -5}, {4, 4, -5}, {-4, 4, -5}));
        m_meshes[0].albedo = glm::vec3(0.5f);
        m_meshes[0].texture_coordinates = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
        m_meshes[0].texture = 0;
        m_textures.push_back({"four", {2, 2}, {255, 0, 0, 0, 255, 0, 0, 0, 255, 188, 188, 188}});
        m_objects.push_back({"quad", 0, ObjectMotion::still});
        m_walkthrough.cameras.push_back(make_look_at_camera(
            glm::dvec3(0.0), {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}, 2.0 * std::atan(0.8), 0.1, 50.0));
        m_walkthrough.cuts = {0};
    }
    [[nodiscard]] std::span<const Mesh> get_meshes() const override { return m_meshes; }
    [[nodiscard]] std::span<const Object> get_objects() const override { return m_objects; }
    [[nodiscard]] std::span<const Texture> get_textures() const override { return m_textures; }
    [[nodiscard]] const Lights& get_lights() const override { return m_lights; }
    [[nodiscard]] const Walkthrough& get_walkthrough() const override { return m_walkthrough; }
    [[nodiscard]] double get_ao_radius_m() const override { return 0.5; }
    [[nodiscard]] Pose compute_pose(double /*time_s*/) const override {
        return {{glm::dmat4(1.0)}};
    }

  private:
    std::vector<Mesh> m_meshes;
    std::vector<Texture> m_textures;
    std::vector<Object> m_objects;
    Lights m_lights;
    Walkthrough m_walkthrough;
};

class SurfacesTest : public GlTest {
  protected:
    Image render(const Scene& scene, Channel channel, const FrameView& view) {
        Precision precision;
        precision.motion = MotionPrecision::float32;
        const GBuffer gbuffer(gl(), kSize, kBaseChannels | ChannelSet{channel}, precision);
        SceneRenderer renderer(gl(), scene);
        context().reset_state();
        renderer.render(gbuffer, view);
        return gl::read_texture(gl(), gbuffer.texture(channel),
                                channel == Channel::eye_depth ? 1 : 3);
    }
    static TestScene make_facing_quad(Mesh mesh) {
        return TestScene({std::move(mesh)}, {glm::dmat4(1.0)},
                         {make_look_at_camera(glm::dvec3(0.0), {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0},
                                              2.0 * std::atan(0.8), 0.1, 50.0)},
                         0.5);
    }
};

TEST_F(SurfacesTest, AVertexOfADeformingObjectMovesFromWhereItWasToWhereItIs) {
    const StretchedScene scene;
    const FrameView view = make_frame_view(scene.get_walkthrough(), 3, kSize, false);
    const Image motion = render(scene, Channel::motion, view);
    const Image depth = render(scene, Channel::eye_depth, view);
    const double step = view.time_s - view.previous_time_s;
    const double distance = 5.0 + kLeave * view.time_s;
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            const glm::dvec3 point =
                distance * compute_pixel_direction(view.camera, kSize, {x + 0.5, y + 0.5});
            EXPECT_NEAR(depth.at(x, y), distance, 1e-5);
            // p_old - p_new.
            const double rest = point.x / (1.0 + kStretch * view.time_s);
            EXPECT_NEAR(motion.at(x, y, 0), -rest * kStretch * step, 1e-6);
            EXPECT_NEAR(motion.at(x, y, 1), -kRise * step, 1e-6);
            EXPECT_NEAR(motion.at(x, y, 2), kLeave * step, 1e-6);
        }
    }
}

TEST_F(SurfacesTest, ALightThatTurnsLightsAsItStandsOnTheFrame) {
    const StretchedScene scene;
    for (const int frame : {0, 3}) {
        const FrameView view = make_frame_view(scene.get_walkthrough(), frame, kSize, false);
        const Image direct = render(scene, Channel::direct_light, view);
        // Albedo 0.8 over pi times the cosine on a sheet that faces +z; stored as a half float.
        EXPECT_NEAR(direct.at(32, 32), 0.8 / 3.14159265 * std::cos(view.time_s), 3e-4);
    }
    EXPECT_NE(hash_lights(scene, 0.0), hash_lights(scene, 0.1));
}

TEST_F(SurfacesTest, AHeldFrameOfADeformingObjectHasNoMotion) {
    const StretchedScene scene;
    const FrameView view = hold(make_frame_view(scene.get_walkthrough(), 3, kSize, false));
    const Image motion = render(scene, Channel::motion, view);
    for (const float value : motion.values()) {
        EXPECT_EQ(value, 0.0f);
    }
}

TEST_F(SurfacesTest, WhatStandsStillHasNoMotion) {
    const TexturedScene scene;
    const FrameView view = make_frame_view(scene.get_walkthrough(), 0, kSize, false);
    const Image motion = render(scene, Channel::motion, view);
    for (const float value : motion.values()) {
        EXPECT_EQ(value, 0.0f);
    }
}

TEST_F(SurfacesTest, DeformingObjectsAreSaidToMove) {
    const StretchedScene scene;
    FrameView view = make_frame_view(scene.get_walkthrough(), 3, kSize, false);
    detect_motion(scene, view);
    EXPECT_TRUE(view.objects_may_move);
}

TEST_F(SurfacesTest, VertexColorsAreFactorsOfTheAlbedo) {
    Mesh mesh = make_quad({-4, -4, -5}, {4, -4, -5}, {4, 4, -5}, {-4, 4, -5});
    mesh.albedo = {0.5f, 0.8f, 1.0f};
    mesh.colors.assign(4, {1.0f, 0.5f, 0.25f});
    const TestScene scene = make_facing_quad(mesh);
    const Image albedo =
        render(scene, Channel::albedo, make_frame_view(scene.get_walkthrough(), 0, kSize, false));
    EXPECT_NEAR(albedo.at(32, 32, 0), 0.5f, 1e-3f);
    EXPECT_NEAR(albedo.at(32, 32, 1), 0.4f, 1e-3f);
    EXPECT_NEAR(albedo.at(32, 32, 2), 0.25f, 1e-3f);
}

TEST_F(SurfacesTest, ATextureIsDecodedFromSrgbWithItsFirstRowOnTop) {
    const TexturedScene scene;
    EXPECT_NO_THROW(check_scene(scene, "textured"));
    const Image albedo =
        render(scene, Channel::albedo, make_frame_view(scene.get_walkthrough(), 0, kSize, false));
    const auto expect = [&albedo](int x, int y, const glm::vec3& color) {
        for (int channel = 0; channel < 3; ++channel) {
            EXPECT_NEAR(albedo.at(x, y, channel), 0.5f * color[channel], 0.02f) << x << " " << y;
        }
    };
    // Texel centres lie on the quarters of the image, half a pixel beside a pixel's centre: the
    // filter mixes in 1/64 of each neighbour. Code 188 is 0.503 of linear light.
    expect(16, 16, {1.0f, 0.0f, 0.0f});
    expect(48, 16, {0.0f, 1.0f, 0.0f});
    expect(16, 48, {0.0f, 0.0f, 1.0f});
    expect(48, 48, {0.5f, 0.5f, 0.5f});
}

} // namespace
} // namespace alcove
