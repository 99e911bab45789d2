// The far plane and the stored depth: neither may be seen in the image.
#include "harness/stability/image_checks.hpp"
#include "harness/stability/scene_rig.hpp"
#include "harness/stability/stability_cases.hpp"
#include "scenes/hard_cases/yard.hpp"

namespace alcove {
namespace {

struct PrecisionFamily {
    const char* name;
    const char* title;
    const char* what;
    const char* source;
    std::vector<RasterDepth> raster_depths;
    EyeDepth eye_depth;
};

Image render(const StabilitySubject& subject, SceneRig& rig) {
    const std::unique_ptr<Method> method =
        subject.create(rig.scene().get_ao_radius_m(), rig.size());
    return rig.settle(*method, 0, subject.frames()).visibility;
}

/// 16 bits leave 2.4 mm a step at 4 m and 1 m at the end of the floor; an angle of view of 40
/// degrees makes pixels finer, with that end and the sky still in the image.
YardSettings make_yard(double far_m) {
    YardSettings settings;
    settings.far_m = far_m;
    settings.fov_y_degrees = 40.0;
    return settings;
}

StabilityScore measure(const StabilitySubject& subject, ImageSize size, double far_m,
                       const PrecisionFamily& family) {
    const std::unique_ptr<Scene> full_scene = make_yard_case(make_yard(100.0));
    SceneRig full(subject.context(), *full_scene, size);
    const Image expected = render(subject, full);
    const std::unique_ptr<Scene> scene = make_yard_case(make_yard(far_m));
    WorstScore worst;
    Image picture;
    for (const RasterDepth raster_depth : family.raster_depths) {
        for (const bool reversed : {false, true}) {
            Precision precision;
            precision.raster_depth = raster_depth;
            precision.reversed = reversed;
            precision.eye_depth = family.eye_depth;
            SceneRig rig(subject.context(), *scene, size, precision);
            picture = render(subject, rig);
            worst.check(picture, rig.read_depth(rig.get_view(0)));
            worst.add(compute_rms_codes(picture, expected), 1.0);
        }
    }
    return worst.finish(std::move(picture));
}

StabilityCase make_case(const PrecisionFamily& family) {
    StabilityCase made;
    made.about = {
        family.name,
        family.title,
        "a floor of 80 m before the sky, near plane at 0.1 m; the far plane moves away while " +
            std::string(family.what) + ", normal and reversed",
        family.source,
        "far plane",
        "m",
        label_severities({100.0, 1e3, 1e4, 1e5}, "m"),
        "the image is that of full precision with the far plane at 100 m",
        "RMS difference from the full-precision image, the worse of normal and reversed depth",
        "codes",
        "one code of 8 bits: under it no display shows how the depth was stored",
    };
    made.measure = [family](const StabilitySubject& subject, ImageSize size, double severity) {
        return measure(subject, size, severity, family);
    };
    return made;
}

} // namespace

std::vector<StabilityCase> make_precision_cases() {
    const std::vector<RasterDepth> all{RasterDepth::float32, RasterDepth::unorm24,
                                       RasterDepth::unorm16};
    const std::vector<PrecisionFamily> families{
        {"far_plane_eye_32f", "Far plane, eye depth 32F",
         "the depth test resolves in 32F, 24 and 16 bits and eye depth is stored in 32F",
         "reported: stair-steps and black stripes as the far plane moves away "
         "(godotengine/godot#53784), black far end (Unity-Technologies/"
         "ScriptableRenderPipeline#5727)",
         all, EyeDepth::float32},
        {"far_plane_eye_16f",
         "Far plane, eye depth 16F",
         "eye depth is stored in 16F",
         "reported: wrong occlusion, then stripes, with 16-bit linear depth "
         "(turanszkij/WickedEngine#31), rings (mrdoob/three.js#33632)",
         {RasterDepth::float32},
         EyeDepth::float16},
        {"far_plane_raster_32f",
         "Far plane, eye depth from a 32F depth buffer",
         "eye depth is rebuilt from a depth buffer of 32F",
         "reported: reversed depth breaks fixed-sign tests (N8python/n8ao#43)",
         {RasterDepth::float32},
         EyeDepth::from_raster},
        {"far_plane_raster_24",
         "Far plane, eye depth from a 24-bit depth buffer",
         "eye depth is rebuilt from a depth buffer of 24 bits",
         "reported: banding that remains with 24 bits (SaschaWillems/Vulkan#635), an inexact 1.0 "
         "at the far plane (drsnuggles8/OloEngineBase#674)",
         {RasterDepth::unorm24},
         EyeDepth::from_raster},
        {"far_plane_raster_16",
         "Far plane, eye depth from a 16-bit depth buffer",
         "eye depth is rebuilt from a depth buffer of 16 bits",
         "depth-resolution speckle with 16 bits (\"Know your SSAO artifacts\"); reported: a flat "
         "surface occludes itself (BabylonJS/Babylon.js#13652)",
         {RasterDepth::unorm16},
         EyeDepth::from_raster},
    };
    std::vector<StabilityCase> cases;
    for (const PrecisionFamily& family : families) {
        cases.push_back(make_case(family));
    }
    return cases;
}

} // namespace alcove
