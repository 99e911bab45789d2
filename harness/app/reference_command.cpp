#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "core/base/image_file.hpp"
#include "core/base/text.hpp"
#include "harness/app/verbs.hpp"
#include "harness/run/experiment.hpp"
#include "harness/run/plan.hpp"
#include "harness/run/scene_source.hpp"
#include "methods/common/ray_tracer.hpp"
#include "scenes/common/camera_file.hpp"

#include <cmath>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace alcove {
namespace {

struct ReferenceFlags {
    std::string scene;
    std::string camera;
    double radius_m = 0.0;
    std::string falloff = "none";
    std::string normals = "geometric";
    std::string weighting = "cosine";
    int rays = 0;
    std::string size = "384x288";
    std::string out;
};

int trace(const ReferenceFlags& flags) {
    constexpr int kMostRays = 1 << 20;
    if (flags.rays < 2 || flags.rays % 2 != 0 || flags.rays > kMostRays) {
        throw InputError("--spp", "out of range", std::to_string(flags.rays),
                         "an even number of rays a pixel, 2 to 1048576: two halves of N/2");
    }
    if (!(flags.radius_m > 0.0) || !std::isfinite(flags.radius_m)) {
        throw InputError("--radius", "out of range", format_number(flags.radius_m),
                         "a positive finite number of metres");
    }
    if (!flags.out.ends_with(".exr")) {
        throw InputError("--out", "not an EXR file", flags.out, "a name that ends in .exr");
    }
    TraceSettings settings;
    settings.target = {flags.radius_m, parse_falloff(flags.falloff),
                       parse_weighting(flags.weighting), parse_normals(flags.normals)};
    settings.rays_per_half = flags.rays / 2;
    // Evaluated where the ray through the pixel centre hits, not above it.
    settings.terminator_safe = false;
    const ImageSize size = parse_size(flags.size);
    std::vector<std::string> warnings;
    const std::unique_ptr<Scene> scene = open_scene(get_units().scenes, flags.scene, warnings);
    for (const std::string& warning : warnings) {
        fmt::print(stderr, "alcove: warning: {}\n", warning);
    }
    const Camera camera = read_camera_file(flags.camera);
    RayTracer tracer;
    tracer.update(pose_geometry(*scene, 0.0));
    const ReferencePair pair = tracer.trace(camera, size, settings);
    write_exr(flags.out, compute_mean(pair), Domain::visibility);
    fmt::print("{}: {}x{}, {} rays a pixel, noise RMS(A-B)/2 = {}\n", flags.out, size.width,
               size.height, flags.rays, format_rounded(compute_noise(pair)));
    return 0;
}

} // namespace

Action add_reference_verb(CLI::App& app) {
    auto flags = std::make_shared<ReferenceFlags>();
    app.add_option("scene", flags->scene, "a .gltf or .glb file, or a scene's name")->required();
    app.add_option("--camera", flags->camera, "CAM.json")->required();
    app.add_option("--radius", flags->radius_m, "metres")->required();
    app.add_option("--falloff", flags->falloff, "none, linear, quadratic")->capture_default_str();
    app.add_option("--normals", flags->normals, "geometric, shading")->capture_default_str();
    app.add_option("--weighting", flags->weighting, "cosine, uniform")->capture_default_str();
    app.add_option("--spp", flags->rays, "rays a pixel in all, even")->required();
    app.add_option("--size", flags->size, "WxH in pixels")->capture_default_str();
    app.add_option("--out", flags->out, "VIS.exr")->required();
    return [flags] { return trace(*flags); };
}

} // namespace alcove
