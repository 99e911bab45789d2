// Culling changes what is drawn, never what is seen.
#include "core/frame/scene_renderer.hpp"
#include "tests/core/gl/test_context.hpp"
#include "tests/test_scenes.hpp"

#include <glm/gtc/matrix_transform.hpp>

namespace alcove {
namespace {

constexpr ImageSize kSize{192, 128};

/// A yard of 400 spheres of 1,088 triangles; a wall with a gap hides most of it.
std::vector<Mesh> make_yard() {
    std::vector<Mesh> meshes{make_sphere({0.0f, 0.0f, 0.0f}, 0.4f, 17),
                             make_box({-30.0f, -1.0f, -0.2f}, {-0.7f, 5.0f, 0.2f}),
                             make_box({0.7f, -1.0f, -0.2f}, {30.0f, 5.0f, 0.2f})};
    for (Mesh& mesh : meshes) {
        mesh.closed = true;
    }
    return meshes;
}

class YardScene final : public Scene {
  public:
    YardScene() : m_meshes(make_yard()) {
        for (std::size_t i = 0; i < 400; ++i) {
            m_objects.push_back({"sphere", 0, ObjectMotion::still});
            const auto row = static_cast<double>(i / 20);
            const auto column = static_cast<double>(i % 20);
            m_pose.object_to_world.push_back(glm::translate(
                glm::dmat4(1.0), glm::dvec3(column - 9.5, 0.3 * (column - row), -2.0 - row)));
        }
        for (const std::size_t wall : {1u, 2u}) {
            m_objects.push_back({"wall", wall, ObjectMotion::still});
            m_pose.object_to_world.emplace_back(1.0);
        }
        for (int i = 0; i < 8; ++i) {
            m_walkthrough.cameras.push_back(make_look_at_camera(
                {-4.0 + i, 0.5 + 1.2 * i, 6.0}, {0.0, 0.0, -8.0}, {0.0, 1.0, 0.0}, 1.0, 0.1, 90.0));
        }
        m_walkthrough.cuts = {0};
    }
    [[nodiscard]] std::span<const Mesh> get_meshes() const override { return m_meshes; }
    [[nodiscard]] std::span<const Object> get_objects() const override { return m_objects; }
    [[nodiscard]] const Lights& get_lights() const override { return m_lights; }
    [[nodiscard]] const Walkthrough& get_walkthrough() const override { return m_walkthrough; }
    [[nodiscard]] double get_ao_radius_m() const override { return 0.5; }
    [[nodiscard]] Pose compute_pose(double /*time_s*/) const override { return m_pose; }

  private:
    std::vector<Mesh> m_meshes;
    std::vector<Object> m_objects;
    Pose m_pose;
    Lights m_lights;
    Walkthrough m_walkthrough;
};

class CullingTest : public GlTest {
  protected:
    struct Frame {
        std::vector<Image> images;
        DrawCounts counts;
    };
    Frame render(SceneRenderer& renderer, const Scene& scene, int frame,
                 const Precision& precision) {
        const ChannelSet channels = kBaseChannels | ChannelSet{Channel::instance_id};
        const GBuffer gbuffer(gl(), kSize, channels, precision);
        context().reset_state();
        renderer.render(gbuffer, make_frame_view(scene.get_walkthrough(), frame, kSize, false));
        Frame result;
        result.counts = renderer.counts();
        for (const Channel channel : {Channel::eye_depth, Channel::normal, Channel::instance_id}) {
            result.images.push_back(gl::read_texture(gl(), gbuffer.texture(channel),
                                                     channel == Channel::normal ? 3 : 1));
        }
        return result;
    }
};

TEST_F(CullingTest, LeavesEveryBitOfTheImageInEveryPrecision) {
    const YardScene scene;
    SceneRenderer all(gl(), scene, Culling::none);
    SceneRenderer frustum(gl(), scene, Culling::frustum);
    SceneRenderer hidden(gl(), scene, Culling::occlusion);
    std::size_t most_saved = 0;
    for (const char* text : {"raster_depth=32F", "raster_depth=16", "raster_depth=32F,reversed"}) {
        const Precision precision = parse_precision(text);
        for (int frame = 0; frame < 8; ++frame) {
            const Frame expected = render(all, scene, frame, precision);
            EXPECT_EQ(expected.counts.drawn, count_size(scene).triangles);
            for (SceneRenderer* renderer : {&frustum, &hidden}) {
                const Frame got = render(*renderer, scene, frame, precision);
                for (std::size_t i = 0; i < got.images.size(); ++i) {
                    const auto a = expected.images[i].values();
                    const auto b = got.images[i].values();
                    EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin()))
                        << text << " frame " << frame << " channel " << i;
                }
                EXPECT_LE(got.counts.drawn, expected.counts.drawn);
                most_saved = std::max(most_saved, expected.counts.drawn - got.counts.drawn);
            }
        }
    }
    // Through the gap about a tenth of the spheres is seen.
    EXPECT_GT(most_saved, count_size(scene).triangles / 2);
}

TEST_F(CullingTest, HidersAreTheWallsAndTheYardBehindThemIsLeftOut) {
    const YardScene scene;
    SceneRenderer frustum(gl(), scene, Culling::frustum);
    SceneRenderer hidden(gl(), scene, Culling::occlusion);
    const Frame seen = render(frustum, scene, 0, {});
    const Frame left = render(hidden, scene, 0, {});
    EXPECT_EQ(seen.counts.hiders, 0u);
    EXPECT_GT(left.counts.hiders, 24u);
    EXPECT_LT(2 * left.counts.drawn, seen.counts.drawn);
}

} // namespace
} // namespace alcove
