// A cached G-buffer against the same one rasterised: the cathedral's walkthrough (about 200 000
// vertices), 512x384, base channels and those of methods with a history, wall time fenced by
// glFinish, frame by frame in turn. The files are in the page cache, as in every repeat of a round
// but the first.

#include "core/base/statistics.hpp"
#include "core/gl/context.hpp"
#include "harness/run/round_gbuffers.hpp"
#include "scenes/registry.hpp"
#include "tests/benchmark/ratio.hpp"
#include "tests/harness/temporary_folder.hpp"

#include <cstdio>

namespace {

using namespace alcove;

constexpr ImageSize kSize{512, 384};
constexpr int kFrames = 30;
constexpr double kTarget = 5.0;

bool measure(gl::Context& context, const Scene& scene, const char* name, ChannelSet channels) {
    const TemporaryFolder folder;
    const gl::Functions& gl = context.functions();
    RoundGBuffers gbuffers(gl, scene, kSize, {}, GBufferStore(folder.path(), "benchmark"), {},
                           "wall");
    const GBufferKey key{channels, {}, {}};
    gbuffers.add(key);
    std::vector<double> ratios;
    std::vector<double> draw_ms;
    std::vector<double> load_ms;
    const auto frame_count = static_cast<int>(scene.get_walkthrough().cameras.size());
    for (int i = 0; i < kFrames; ++i) {
        const FrameView view =
            make_frame_view(scene.get_walkthrough(), i * frame_count / kFrames, kSize, true);
        context.reset_state();
        gbuffers.draw(key, view);
        gbuffers.store(key, view);
        if (!gbuffers.load(key, view)) { // into the page cache
            return false;
        }
        gl.Finish();
        draw_ms.push_back(1e3 * time_call([&] {
                              gbuffers.draw(key, view);
                              gl.Finish();
                          }));
        load_ms.push_back(1e3 * time_call([&] {
                              static_cast<void>(gbuffers.load(key, view));
                              gl.Finish();
                          }));
        ratios.push_back(draw_ms.back() / load_ms.back());
    }
    std::printf("# %s: drawn %.2f ms, loaded %.2f ms (medians, n=%zu)\n", name,
                compute_median(draw_ms), compute_median(load_ms), ratios.size());
    return print_target(std::string("G-buffer drawn / loaded, ") + name, kTarget, true, ratios);
}

} // namespace

int main() {
    const std::unique_ptr<gl::Context> context = gl::open_context(gl::ContextKind::autodetect);
    const Registry<SceneUnit> scenes = scenes_registry();
    const SceneUnit& unit = scenes.find("cathedral");
    // About 200 000 vertices.
    const std::vector<ParameterOverride> detail{{"detail", "7"}};
    const std::unique_ptr<Scene> scene = unit.open(unit.parameters.resolve(detail, {}));
    std::printf("# cathedral: %zu vertices\n", count_size(*scene).vertices);
    const bool base = measure(*context, *scene, "base", kBaseChannels);
    const bool more = measure(*context, *scene, "with motion and depth",
                              kBaseChannels | ChannelSet{Channel::motion_depth});
    return base && more ? 0 : 3;
}
