// Edges of things before something far away: the sky, or a wall.
#include "harness/stability/image_checks.hpp"
#include "harness/stability/scene_rig.hpp"
#include "harness/stability/stability_cases.hpp"
#include "methods/common/ray_tracer.hpp"
#include "scenes/hard_cases/bars.hpp"
#include "scenes/hard_cases/foreground.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace alcove {
namespace {

constexpr int kSeeds = 4;
constexpr int kBandPixels = 2;
constexpr double kBound = 4.0;

Image trace(const Scene& scene, const FrameView& view) {
    TraceSettings settings;
    settings.target.radius_m = scene.get_ao_radius_m();
    settings.rays_per_half = 128;
    settings.seed = 1;
    RayTracer tracer;
    tracer.update(pose_geometry(scene, view.time_s));
    return compute_mean(tracer.trace(view.camera, view.size, settings));
}

/// 1 on pixels that `is_inside` and that have one `is_edge` within kBandPixels.
template <class Inside, class Edge>
Image make_band(const Image& depth, const Inside& is_inside, const Edge& is_edge) {
    Image band(depth.size(), 1);
    for (int y = 0; y < depth.height(); ++y) {
        for (int x = 0; x < depth.width(); ++x) {
            bool near_edge = false;
            for (int dy = -kBandPixels; dy <= kBandPixels; ++dy) {
                for (int dx = -kBandPixels; dx <= kBandPixels; ++dx) {
                    const int px = std::clamp(x + dx, 0, depth.width() - 1);
                    const int py = std::clamp(y + dy, 0, depth.height() - 1);
                    near_edge = near_edge || is_edge(depth.at(px, py));
                }
            }
            band.at(x, y) = near_edge && is_inside(depth.at(x, y)) ? 1.0f : 0.0f;
        }
    }
    return band;
}

template <class Inside, class Edge>
StabilityScore measure(const StabilitySubject& subject, ImageSize size, const Scene& scene,
                       const Inside& is_inside, const Edge& is_edge) {
    SceneRig rig(subject.context(), scene, size);
    const FrameView view = rig.get_view(0);
    const Image depth = rig.read_depth(view);
    const Image band = make_band(depth, is_inside, is_edge);
    const std::unique_ptr<Method> method = subject.create(scene.get_ao_radius_m(), size);
    MeanImage mean;
    WorstScore worst;
    for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
        ShotOptions options;
        options.seed = seed;
        mean.add(rig.settle(*method, 0, subject.frames(), options).visibility);
    }
    Image picture = mean.compute();
    worst.check(picture, depth);
    worst.add(std::abs(compute_mean_codes(picture, trace(scene, view), band)), kBound);
    return worst.finish(std::move(picture));
}

/// Pixels of the image's height that one metre covers at 1 m for the bars' camera of 60 degrees.
double compute_pixels_at_1_m(ImageSize size) {
    return size.height / (2.0 * std::tan(std::numbers::pi / 6.0));
}

} // namespace

std::vector<StabilityCase> make_silhouette_cases() {
    StabilityCase sky;
    sky.about = {
        "sky_edges",
        "Silhouettes before the sky",
        "bars before the sky at two depths that block nothing of each other; they get thinner down "
        "to a pixel",
        "reported: black lines at silhouettes (turanszkij/WickedEngine#639), a sky that gets "
        "occlusion (drsnuggles8/OloEngineBase#674), white outlines (godotengine/godot#107011)",
        "width of a near bar",
        "px",
        label_severities({16.0, 8.0, 4.0, 2.0, 1.0}, "px"),
        "the sky is exactly 1, and the pixels along silhouettes are as bright as ray-traced",
        "|mean error| against the ray-traced reference over surface pixels within 2 pixels of the "
        "sky, four seeds",
        "codes",
        "4 codes: twice what the contract tests allow a plane at 75 degrees, since the sides of a "
        "bar are seen at up to 90. The mean, not the RMS: noise is no fringe",
    };
    sky.measure = [](const StabilitySubject& subject, ImageSize size, double width_px) {
        constexpr double kDistance = 5.0;
        const std::unique_ptr<Scene> scene =
            make_bars_case(width_px * kDistance / compute_pixels_at_1_m(size));
        const auto is_sky = [](float depth) { return std::isinf(depth); };
        return measure(
            subject, size, *scene, [](float depth) { return !std::isinf(depth); }, is_sky);
    };
    StabilityCase foreground;
    foreground.about = {
        "foreground",
        "Foreground before a wall",
        "a post comes nearer to the wall behind it, but not as near as the radius of 0.5 m",
        "\"Know your SSAO artifacts\": wrong darkening by distant foreground; reported: shadows "
        "behind thin objects (google/filament#9101, o3de/sig-graphics-audio#124)",
        "gap between post and wall",
        "m",
        label_severities({8.0, 4.0, 2.0, 1.25, 0.75, 0.55}, "m"),
        "the wall beside the post is as bright as ray-traced",
        "|mean error| against the ray-traced reference over wall pixels within 2 pixels of the "
        "post, four seeds",
        "codes",
        "4 codes, as for silhouettes before the sky",
    };
    foreground.measure = [](const StabilitySubject& subject, ImageSize size, double gap_m) {
        const std::unique_ptr<Scene> scene = make_foreground_case(gap_m);
        // The post's front lies 0.2 m before its back; the wall is at 10 m.
        const auto is_post = [gap_m](float depth) {
            return depth < 10.0f - 0.5f * static_cast<float>(gap_m);
        };
        const auto is_wall = [&is_post](float depth) { return !is_post(depth); };
        return measure(subject, size, *scene, is_wall, is_post);
    };
    return {std::move(sky), std::move(foreground)};
}

} // namespace alcove
