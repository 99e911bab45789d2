// What culling saves over the short walkthrough of the city at the size of a published one, with
// equal images, and how long that city takes to be there. Exit code 3 if a target is not met.

#include "core/base/hash.hpp"
#include "core/frame/scene_renderer.hpp"
#include "core/gl/context.hpp"
#include "scenes/registry.hpp"
#include "tests/benchmark/ratio.hpp"

#include <cstdio>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

namespace {

using namespace alcove;

constexpr ImageSize kSize{384, 288}; ///< of a run that names none
constexpr ImageSize kLarge{1024, 768};
constexpr int kEvery = 6; ///< of the walkthrough's 120 frames
constexpr double kTarget = 5.0;
constexpr double kReadyS = 60.0;
constexpr double kMostGiB = 6.0;
/// What is compared; timed is the base, which every run rasterises.
constexpr ChannelSet kCompared = kBaseChannels | ChannelSet{Channel::motion, Channel::instance_id};

/// The process's largest resident memory so far in GiB.
double read_peak_gib() {
    std::ifstream status("/proc/self/status");
    std::string word;
    while (status >> word) {
        if (word == "VmHWM:") {
            double kib = 0.0;
            status >> kib;
            return kib / (1024.0 * 1024.0);
        }
    }
    return 0.0;
}

std::string hash_images(const gl::Functions& gl, const GBuffer& gbuffer) {
    Hasher hasher;
    for (const ChannelInfo& info : kChannels) {
        if (kCompared.contains(info.channel)) {
            const Image image =
                gl::read_texture(gl, gbuffer.texture(info.channel), info.components);
            hasher.add_bytes(std::as_bytes(image.values()));
        }
    }
    return hasher.finish_hex();
}

struct Part {
    const char* name;
    std::vector<double> ratios;
    double all_s = 0.0;
    double culled_s = 0.0;
    double all_triangles = 0.0;
    double drawn_triangles = 0.0;
};

/// The walkthrough at one size; prints, and returns whether images are equal and targets hold.
bool measure(gl::Context& context, const Scene& scene, SceneRenderer& culled, SceneRenderer& all,
             ImageSize size, bool has_target) {
    const gl::Functions& gl = context.functions();
    const GBuffer base(gl, size, kBaseChannels, {});
    const GBuffer compared(gl, size, kCompared, {});
    Part street{"street", {}};
    Part roofs{"roofs", {}};
    bool is_equal = true;
    const Walkthrough& walkthrough = scene.get_walkthrough();
    const int cut = walkthrough.cuts.back();
    for (int frame = 0; frame < static_cast<int>(walkthrough.cameras.size()); frame += kEvery) {
        const FrameView view = make_frame_view(walkthrough, frame, size, false);
        Part& part = frame < cut ? street : roofs;
        const auto draw = [&](SceneRenderer& renderer, const GBuffer& gbuffer) {
            context.reset_state();
            return time_call([&] {
                renderer.render(gbuffer, view);
                gl.Finish();
            });
        };
        draw(culled, compared);
        const std::string culled_hash = hash_images(gl, compared);
        draw(all, compared);
        is_equal = is_equal && hash_images(gl, compared) == culled_hash;
        draw(culled, base); // compiles, and brings caches to where they stay
        const double culled_s = draw(culled, base);
        const double all_s = draw(all, base);
        part.ratios.push_back(all_s / culled_s);
        part.all_s += all_s;
        part.culled_s += culled_s;
        part.all_triangles += static_cast<double>(all.counts().drawn);
        part.drawn_triangles += static_cast<double>(culled.counts().drawn + culled.counts().hiders);
    }
    for (const Part* part : {&street, &roofs}) {
        const auto n = static_cast<double>(part->ratios.size());
        std::printf("# %dx%d, %s: %.0f ms of all triangles, %.0f ms culled (means, n=%.0f); %.2f%% "
                    "of the triangles drawn\n",
                    size.width, size.height, part->name, 1e3 * part->all_s / n,
                    1e3 * part->culled_s / n, n,
                    100.0 * part->drawn_triangles / part->all_triangles);
    }
    std::vector<double> together = street.ratios;
    together.insert(together.end(), roofs.ratios.begin(), roofs.ratios.end());
    const std::string name = "G-buffer all / culled, city at 22 M, " + std::to_string(size.width) +
                             "x" + std::to_string(size.height);
    const bool met = print_target(name, kTarget, true, together);
    std::printf("  images equal: %s\n", is_equal ? "yes" : "NO");
    return is_equal && (met || !has_target);
}

} // namespace

int main() {
    const std::unique_ptr<gl::Context> context = gl::open_context(gl::ContextKind::autodetect);
    const gl::Functions& gl = context->functions();
    const Registry<SceneUnit> scenes = scenes_registry();
    const SceneUnit& unit = scenes.find("city");
    std::unique_ptr<Scene> scene;
    std::unique_ptr<SceneRenderer> culled;
    const double ready_s = time_call([&] {
        const std::vector<ParameterOverride> largest{{"detail", "64"}};
        scene = unit.open(unit.parameters.resolve(largest, {}));
        culled = std::make_unique<SceneRenderer>(gl, *scene);
        const GBuffer gbuffer(gl, kSize, kBaseChannels, {});
        context->reset_state();
        culled->render(gbuffer, make_frame_view(scene->get_walkthrough(), 0, kSize, true));
        gl.Finish();
    });
    const double ready_gib = read_peak_gib();
    const SceneSize size = count_size(*scene);
    std::printf("# city: %zu vertices, %zu triangles, %zu objects\n", size.vertices, size.triangles,
                scene->get_objects().size());
    SceneRenderer all(gl, *scene, Culling::none);
    bool met = measure(*context, *scene, *culled, all, kSize, true);
    // Filling pixels costs both alike, so that the ratio falls with the size: told, not gated.
    met = measure(*context, *scene, *culled, all, kLarge, false) && met;
    met = print_target("  seconds until its first frame", kReadyS, false, {ready_s}) && met;
    met = print_target("  GiB until then", kMostGiB, false, {ready_gib}) && met;
    return met ? 0 : 3;
}
