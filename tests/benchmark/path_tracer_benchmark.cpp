// Rays/s of the path-traced reference against a bare loop of Embree's queries over such rays: at
// least half. Cathedral, 192x144, its radius and light, which casts shadows, under a sky of two
// colours.

#include "core/frame/frame_view.hpp"
#include "methods/common/path_tracer.hpp"
#include "scenes/cathedral/cathedral.hpp"
#include "tests/benchmark/ratio.hpp"
#include "tests/benchmark/recorded_paths.hpp"

#include <cstdio>

namespace {

using namespace alcove;

constexpr ImageSize kSize{192, 144};

/// The ratio of both rates, whose ray counts differ a little: other scrambles, other normals.
bool compare(const PathTracer& tracer, const RecordedPaths& bare, const Camera& camera,
             const Lights& lights, const PathSettings& settings, const std::string& name) {
    std::uint64_t rays = 0;
    const auto trace = [&] {
        rays = tracer.trace(camera, kSize, lights, settings).indirect.ray_count;
    };
    std::vector<double> ratios = time_in_turn([&] { bare.run(); }, trace, 7);
    const double per_bare = static_cast<double>(rays) / static_cast<double>(bare.ray_count());
    for (double& ratio : ratios) {
        ratio *= per_bare;
    }
    std::printf("# %s: %.2f M rays/s of %.2f M, bare loop %.2f M rays/s of %.2f M, %.2f M of them "
                "scattered\n",
                name.c_str(), static_cast<double>(rays) / time_call(trace) * 1e-6,
                static_cast<double>(rays) * 1e-6,
                static_cast<double>(bare.ray_count()) / time_call([&] { bare.run(); }) * 1e-6,
                static_cast<double>(bare.ray_count()) * 1e-6,
                static_cast<double>(bare.scattered_count()) * 1e-6);
    return print_target("path-traced rays/s / bare Embree, " + name, 0.5, true, ratios);
}

} // namespace

int main() {
    const SceneUnit unit = cathedral_unit();
    const std::unique_ptr<Scene> scene = unit.open(unit.parameters.resolve({}, {}));
    const FrameView view = make_frame_view(scene->get_walkthrough(), 0, kSize, true);
    const PosedGeometry geometry = pose_geometry(*scene, 0.0);
    Lights lights = scene->get_lights();
    for (DirectionalLight& light : lights.directional) {
        light.casts_shadow = true;
    }
    lights.environment = std::make_shared<const Environment>(
        [](const glm::dvec3& d) {
            return d.y > 0.0 ? glm::vec3(0.3f, 0.5f, 1.0f) : glm::vec3(0.4f, 0.2f, 0.1f);
        },
        "benchmark");
    lights.environment_turn_radians = 0.5;
    PathTracer tracer;
    tracer.update(geometry);
    PathSettings settings;
    settings.radius_m = scene->get_ao_radius_m();
    settings.rays_per_half = 32;
    PathRecording recording;
    recording.rays_per_half = settings.rays_per_half;
    recording.to_light = glm::vec3(lights.directional.front().to_light);
    recording.reach_m = static_cast<float>(settings.radius_m);
    bool all = true;
    {
        const RecordedPaths near(geometry, view.camera, kSize, recording);
        all = compare(tracer, near, view.camera, lights, settings, "near, linear");
        settings.falloff = Falloff::none;
        all = compare(tracer, near, view.camera, lights, settings, "near, none") && all;
    }
    recording.reach_m = std::numeric_limits<float>::infinity();
    settings.reach = PathReach::full;
    const RecordedPaths full(geometry, view.camera, kSize, recording);
    all = compare(tracer, full, view.camera, lights, settings, "full") && all;
    return all ? 0 : 3;
}
