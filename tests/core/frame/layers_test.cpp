// Depth layers, back faces, extra views and multisampling against rays and geometry.
#include "core/base/error.hpp"
#include "core/frame/gbuffer_part.hpp"
#include "core/frame/scene_renderer.hpp"
#include "methods/common/traced_scene.hpp"
#include "scenes/registry.hpp"
#include "tests/core/gl/test_context.hpp"
#include "tests/test_scenes.hpp"

#include <cmath>
#include <limits>
#include <memory>

#include <embree3/rtcore.h>
#include <glm/geometric.hpp>

namespace alcove {
namespace {

constexpr ImageSize kSize{160, 100};
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Eye depths of the first hits through the centre of each pixel, front and back, layer by layer.
class RayLayers {
  public:
    RayLayers(const Scene& scene, const FrameView& view) {
        m_tree.update(pose_geometry(scene, view.time_s));
        m_back = {Image(view.size, 1, kInfinity), Image(view.size, 1, -1.0f)};
        m_layers.assign(kMostLayers, m_back);
        const glm::vec3 eye(view.camera.position - m_tree.origin());
        for (int y = 0; y < view.size.height; ++y) {
            for (int x = 0; x < view.size.width; ++x) {
                trace(view, eye, x, y);
            }
        }
    }
    struct Layer {
        Image depth;
        Image object;
    };
    [[nodiscard]] const Layer& layer(int k) const {
        return m_layers[static_cast<std::size_t>(k - 1)];
    }
    [[nodiscard]] const Layer& back() const { return m_back; }

  private:
    void trace(const FrameView& view, const glm::vec3& eye, int x, int y) {
        const glm::vec3 way(compute_pixel_direction(view.camera, view.size, {x + 0.5, y + 0.5}));
        auto nearest = static_cast<float>(view.camera.near_m);
        for (int k = 0; k < 64; ++k) {
            RTCIntersectContext context;
            rtcInitIntersectContext(&context);
            RTCRayHit query{};
            query.ray.org_x = eye.x;
            query.ray.org_y = eye.y;
            query.ray.org_z = eye.z;
            query.ray.dir_x = way.x;
            query.ray.dir_y = way.y;
            query.ray.dir_z = way.z;
            query.ray.tnear = nearest;
            query.ray.tfar = static_cast<float>(view.camera.far_m);
            query.ray.mask = 0xffffffffu;
            query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
            rtcIntersect1(m_tree.top(), &context, &query);
            if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
                return;
            }
            const auto put = [&](Layer& layer) {
                layer.depth.at(x, y) = query.ray.tfar;
                layer.object.at(x, y) = static_cast<float>(query.hit.geomID);
            };
            if (k < kMostLayers) {
                put(m_layers[static_cast<std::size_t>(k)]);
            }
            const glm::vec3 normal(query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z);
            if (glm::dot(normal, way) > 0.0f && std::isinf(m_back.depth.at(x, y))) {
                put(m_back);
            }
            nearest = query.ray.tfar * (1.0f + 4e-6f);
        }
    }

    TracedScene m_tree;
    std::vector<Layer> m_layers;
    Layer m_back;
};

bool agree(float a, float b) {
    return a == b || std::abs(a - b) <= 1e-4f * std::min(a, b);
}

/// Does an edge run within a pixel: does the ray image hold the drawn depth, another object or a
/// jump beside the pixel?
bool is_at_edge(const RayLayers::Layer& rays, float drawn, int x, int y) {
    const Image& depth = rays.depth;
    bool edge = false;
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, depth.height() - 1); ++v) {
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, depth.width() - 1); ++u) {
            edge = edge || agree(depth.at(u, v), drawn) ||
                   rays.object.at(u, v) != rays.object.at(x, y) ||
                   !(std::abs(depth.at(u, v) - depth.at(x, y)) <= 0.02f * depth.at(x, y));
        }
    }
    return edge;
}

class LayersTest : public GlTest {
  protected:
    void expect_equal(const Image& drawn, const RayLayers::Layer& traced, const std::string& what) {
        const Image& rays = traced.depth;
        int wrong = 0;
        int hits = 0;
        for (int y = 0; y < rays.height(); ++y) {
            for (int x = 0; x < rays.width(); ++x) {
                hits += std::isfinite(rays.at(x, y)) ? 1 : 0;
                if (!agree(drawn.at(x, y), rays.at(x, y))) {
                    ++wrong;
                    EXPECT_TRUE(is_at_edge(traced, drawn.at(x, y), x, y))
                        << what << " at " << x << ", " << y << ": " << drawn.at(x, y) << " drawn, "
                        << rays.at(x, y) << " traced";
                }
            }
        }
        EXPECT_LE(wrong, static_cast<int>(rays.size().pixel_count() / 1000)) << what;
        EXPECT_GT(hits, static_cast<int>(rays.size().pixel_count() / 40)) << what;
    }
    Image read(const GBuffer& gbuffer) {
        return gl::read_texture(gl(), gbuffer.texture(Channel::eye_depth), 1);
    }
    void expect_layers(const Scene& scene, int frame, const std::string& name) {
        const FrameView view = make_frame_view(scene.get_walkthrough(), frame, kSize, false);
        const RayLayers rays(scene, view);
        SceneRenderer renderer(gl(), scene);
        context().reset_state();
        // Two surfaces 2 cm apart and 31 m away are one to a depth buffer that runs forwards.
        const Precision fine = parse_precision("raster_depth=32F,reversed");
        auto nearer = std::make_unique<GBuffer>(gl(), kSize, ChannelSet{Channel::eye_depth}, fine);
        renderer.render(*nearer, view);
        expect_equal(read(*nearer), rays.layer(1), name + " layer 1");
        for (int k = 2; k <= kMostLayers; ++k) {
            auto layer = std::make_unique<GBuffer>(
                gl(), kSize, ChannelSet{Channel::eye_depth, Channel::normal}, fine);
            renderer.render_layer(*layer, view, *nearer);
            expect_equal(read(*layer), rays.layer(k), name + " layer " + std::to_string(k));
            nearer = std::move(layer);
        }
        const GBuffer back(gl(), kSize, {Channel::eye_depth}, fine);
        renderer.render_back_faces(back, view);
        expect_equal(read(back), rays.back(), name + " back faces");
    }
};

TEST_F(LayersTest, APeeledLayerIsTheNextHitOfARayAmongBoxes) {
    expect_layers(make_box_scene(), 1, "boxes");
}

TEST_F(LayersTest, APeeledLayerIsTheNextHitOfARayInTheCathedral) {
    const Registry<SceneUnit> scenes = scenes_registry();
    const SceneUnit& unit = scenes.find("cathedral");
    const auto scene = unit.open(unit.parameters.resolve({}, {}));
    for (const int frame : {10, 105}) {
        expect_layers(*scene, frame, "cathedral frame " + std::to_string(frame));
    }
}

TEST_F(LayersTest, LayersOfACoarseEyeDepthAreRefused) {
    const TestScene scene = make_box_scene();
    const FrameView view = make_frame_view(scene.get_walkthrough(), 0, kSize, false);
    SceneRenderer renderer(gl(), scene);
    const Precision coarse = parse_precision("eye_depth=16F");
    const GBuffer nearer(gl(), kSize, {Channel::eye_depth}, coarse);
    const GBuffer layer(gl(), kSize, {Channel::eye_depth}, coarse);
    EXPECT_THROW(renderer.render_layer(layer, view, nearer), InputError);
}

TEST_F(LayersTest, AnExtraViewLooksAtTheSamePointFromBesideTheViewer) {
    const TestScene scene = make_box_scene();
    const FrameView view = make_frame_view(scene.get_walkthrough(), 0, kSize, false);
    const BoundingSphere sphere = compute_bounding_sphere(scene);
    const GBufferPart part{PartKind::view, 1, {{1.0, 0.0, 0.0}, 0.5}};
    const FrameView beside = make_part_view(part, view, {}, sphere);
    EXPECT_EQ(beside.size, (ImageSize{80, 50}));
    EXPECT_NEAR(glm::distance(beside.camera.position, view.camera.position), sphere.radius_m,
                1e-9 * sphere.radius_m);
    // Both axes meet: the shortest way between the two lines is 0.
    const glm::dvec3 a = -view.camera.world_from_view[2];
    const glm::dvec3 b = -beside.camera.world_from_view[2];
    const glm::dvec3 between = beside.camera.position - view.camera.position;
    EXPECT_NEAR(glm::dot(between, glm::normalize(glm::cross(a, b))), 0.0, 1e-9 * sphere.radius_m);
    EXPECT_LT(glm::dot(a, b), 0.999);
    EXPECT_EQ(to_text(part), "view1");
}

TEST_F(LayersTest, SamplesOfAPixelAgreeInsideASurfaceAndDifferOnlyAtEdges) {
    const TestScene scene = make_box_scene();
    const FrameView view = make_frame_view(scene.get_walkthrough(), 0, kSize, false);
    SceneRenderer renderer(gl(), scene);
    const GBuffer multisampled(gl(), kSize, kBaseChannels, {}, 4);
    context().reset_state();
    renderer.render(multisampled, view);
    context().check_errors();
    EXPECT_THROW(GBuffer(gl(), kSize, kBaseChannels, {}, 64), InputError);
    EXPECT_THROW(GBuffer(gl(), kSize, kBaseChannels, parse_precision("eye_depth=raster"), 4),
                 InputError);
}

} // namespace
} // namespace alcove
