// Which visibility the samples of a multisampled picture take at silhouettes.
#include "core/frame/compose.hpp"
#include "core/frame/scene_renderer.hpp"
#include "tests/core/gl/test_context.hpp"
#include "tests/test_scenes.hpp"

#include <algorithm>
#include <cmath>

namespace alcove {
namespace {

constexpr ImageSize kSize{96, 72};

/// A white slanted slab before a black wall, without direct light: what the picture shows is the
/// slab's share of each pixel times the visibility that its samples took.
TestScene make_slab_scene() {
    Mesh slab = make_quad({-0.9f, -0.8f, -3.0f}, {0.4f, -0.9f, -3.0f}, {0.9f, 0.8f, -3.0f},
                          {-0.5f, 0.7f, -3.0f});
    slab.albedo = glm::vec3(1.0f);
    Mesh wall = make_quad({-9.0f, -9.0f, -8.0f}, {9.0f, -9.0f, -8.0f}, {9.0f, 9.0f, -8.0f},
                          {-9.0f, 9.0f, -8.0f});
    wall.albedo = glm::vec3(0.0f);
    return {{slab, wall}, {glm::dmat4(1.0), glm::dmat4(1.0)}, {Camera{}}, 0.5};
}

class ComposeSamplesTest : public GlTest {
  protected:
    /// The picture of this visibility over 4 samples a pixel.
    Image compose(const Image& visibility_image, bool takes_nearest) {
        const TestScene scene = make_slab_scene();
        SceneRenderer renderer(gl(), scene);
        const GBuffer pixels(gl(), kSize, kBaseChannels, {});
        const GBuffer samples(gl(), kSize, kBaseChannels, {}, 4);
        const FrameView view = make_frame_view(scene.get_walkthrough(), 0, kSize, true);
        context().reset_state();
        renderer.render(pixels, view);
        context().reset_state();
        renderer.render(samples, view);
        m_depth = gl::read_texture(gl(), pixels.texture(Channel::eye_depth), 1);
        const gl::Texture visibility(gl(), GL_R32F, kSize);
        gl::write_texture(gl(), visibility, visibility_image);
        Lights lights;
        lights.ambient = glm::vec3(1.0f);
        Surroundings surroundings(gl());
        surroundings.update(lights);
        Compose compose(gl(), kSize);
        PassRecorder recorder(PassTiming::none);
        context().reset_state();
        compose.render(samples, surroundings.look_through(view.camera), view.camera,
                       {.visibility = &visibility}, recorder,
                       takes_nearest ? &pixels.texture(Channel::eye_depth) : nullptr);
        context().check_errors();
        return gl::read_texture(gl(), compose.picture(), 3);
    }
    Image m_depth;
};

TEST_F(ComposeSamplesTest, NearestDepthTakesTheSurfacesOwnVisibilityAtItsEdge) {
    // With visibility 1 everywhere the picture is the slab's share: the truth for a slab that is
    // open, whatever the wall's visibility.
    const Image truth = compose(Image(kSize, 1, 1.0f), false);
    Image visibility(kSize, 1);
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            visibility.at(x, y) = m_depth.at(x, y) < 5.0f ? 1.0f : 0.25f;
        }
    }
    const auto measure = [&](bool takes_nearest) {
        const Image picture = compose(visibility, takes_nearest);
        int wrong = 0;
        int edge = 0;
        for (int y = 0; y < kSize.height; ++y) {
            for (int x = 0; x < kSize.width; ++x) {
                const float share = truth.at(x, y);
                edge += share > 0.01f && share < 0.99f ? 1 : 0;
                wrong += std::abs(picture.at(x, y) - share) > 0.01f ? 1 : 0;
            }
        }
        EXPECT_GT(edge, 60); // around the slab
        RecordProperty(takes_nearest ? "wrong_nearest" : "wrong_pixel", wrong);
        RecordProperty("edge_pixels", edge);
        return static_cast<double>(wrong) / edge;
    };
    // About half of the edge's pixels have their centre on the wall.
    EXPECT_GT(measure(false), 0.3);
    EXPECT_EQ(measure(true), 0.0);
}

TEST_F(ComposeSamplesTest, NearestDepthChangesNothingWhereVisibilityIsTheSame) {
    const Image flat(kSize, 1, 0.5f);
    EXPECT_EQ(hash_image(compose(flat, false)), hash_image(compose(flat, true)));
}

} // namespace
} // namespace alcove
