// Rays/s of the reference against a bare loop of rtcOccluded16 over the same bundles: at least
// half. Cathedral, 384x288, radius, rays and target of the default suite.

#include "methods/common/ray_tracer.hpp"
#include "methods/common/sobol.hpp"
#include "scenes/cathedral/cathedral.hpp"
#include "tests/benchmark/ratio.hpp"
#include "tests/benchmark/recorded_bundles.hpp"

#include "core/frame/frame_view.hpp"

#include <cstdio>

int main() {
    using namespace alcove;
    const SceneUnit unit = cathedral_unit();
    const std::unique_ptr<Scene> scene = unit.open(unit.parameters.resolve({}, {}));
    constexpr ImageSize kSize{384, 288};
    const FrameView view = make_frame_view(scene->get_walkthrough(), 0, kSize, true);
    const PosedGeometry geometry = pose_geometry(*scene, 0.0);
    RayTracer tracer;
    tracer.update(geometry);
    const RecordedBundles bundles(geometry, view.camera, kSize, scene->get_ao_radius_m(), 64);
    std::printf("# %zu receivers, 128 rays each, radius %g m\n", bundles.receiver_count(),
                scene->get_ao_radius_m());
    bool all = true;
    for (const Falloff falloff : {Falloff::none, Falloff::linear}) {
        TraceSettings settings;
        settings.target.radius_m = scene->get_ao_radius_m();
        settings.target.falloff = falloff;
        std::uint64_t rays = 0;
        // Bare over ours: seconds are inverse to rays/s, and both cast as many.
        const std::vector<double> ratios =
            time_in_turn([&] { bundles.run(); },
                         [&] { rays = tracer.trace(view.camera, kSize, settings).ray_count; }, 7);
        const double seconds =
            time_call([&] { static_cast<void>(tracer.trace(view.camera, kSize, settings)); });
        std::printf(
            "# falloff %s: %.2f M rays/s, bare loop %.2f M rays/s\n",
            std::string(to_text(falloff)).c_str(), static_cast<double>(rays) / seconds * 1e-6,
            static_cast<double>(bundles.ray_count()) / time_call([&] { bundles.run(); }) * 1e-6);
        if (rays != bundles.ray_count()) {
            std::printf("the bundles are not those of the tracer: %llu and %llu rays\n",
                        static_cast<unsigned long long>(rays),
                        static_cast<unsigned long long>(bundles.ray_count()));
            return 1;
        }
        all = print_target("reference rays/s / bare rtcOccluded16, falloff " +
                               std::string(to_text(falloff)),
                           0.5, true, ratios) &&
              all;
    }
    return all ? 0 : 3;
}
