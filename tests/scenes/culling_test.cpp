// Culling over walkthroughs of shipped scenes: every channel is the same, bit for bit, as without.
#include "core/base/hash.hpp"
#include "core/frame/scene_renderer.hpp"
#include "scenes/registry.hpp"
#include "tests/core/gl/test_context.hpp"

namespace alcove {
namespace {

constexpr ImageSize kSize{160, 120};
constexpr ChannelSet kDrawn = kBaseChannels | ChannelSet{Channel::motion, Channel::instance_id};

struct Case {
    const char* name;
    const char* scene;
    std::vector<ParameterOverride> overrides;
    int frames; ///< spread over the walkthrough
};

class CullingOfScenes : public GlTest, public testing::WithParamInterface<Case> {
  protected:
    std::string draw(SceneRenderer& renderer, const GBuffer& gbuffer, const FrameView& view) {
        context().reset_state();
        renderer.render(gbuffer, view);
        Hasher hasher;
        for (const ChannelInfo& info : kChannels) {
            if (kDrawn.contains(info.channel)) {
                const Image image =
                    gl::read_texture(gl(), gbuffer.texture(info.channel), info.components);
                hasher.add_bytes(std::as_bytes(image.values()));
            }
        }
        return hasher.finish_hex();
    }
};

TEST_P(CullingOfScenes, LeavesEveryBitOfEveryChannel) {
    const Registry<SceneUnit> scenes = scenes_registry();
    const SceneUnit& unit = scenes.find(GetParam().scene);
    const auto scene = unit.open(unit.parameters.resolve(GetParam().overrides, {}));
    SceneRenderer all(gl(), *scene, Culling::none);
    SceneRenderer frustum(gl(), *scene, Culling::frustum);
    SceneRenderer hidden(gl(), *scene, Culling::occlusion);
    const GBuffer gbuffer(gl(), kSize, kDrawn, {});
    const Walkthrough& walkthrough = scene->get_walkthrough();
    const auto count = static_cast<int>(walkthrough.cameras.size());
    std::size_t drawn = 0;
    std::size_t without = 0;
    for (int i = 0; i < GetParam().frames; ++i) {
        const int frame = (2 * i + 1) * count / (2 * GetParam().frames);
        const FrameView view = make_frame_view(walkthrough, frame, kSize, false);
        const std::string expected = draw(all, gbuffer, view);
        EXPECT_EQ(draw(frustum, gbuffer, view), expected) << "frame " << frame;
        EXPECT_EQ(draw(hidden, gbuffer, view), expected) << "frame " << frame;
        drawn += hidden.counts().drawn;
        without += all.counts().drawn;
    }
    EXPECT_LT(drawn, without);
}

INSTANTIATE_TEST_SUITE_P(Scenes, CullingOfScenes,
                         testing::Values(Case{"cathedral", "cathedral", {{"detail", "16"}}, 8},
                                         Case{"city", "city", {{"detail", "16"}}, 10},
                                         Case{"crowd", "crowd", {}, 4},
                                         Case{"factory", "factory", {{"detail", "8"}}, 6},
                                         Case{"paladin", "paladin", {}, 4}),
                         [](const auto& instance) { return std::string(instance.param.name); });

} // namespace
} // namespace alcove
