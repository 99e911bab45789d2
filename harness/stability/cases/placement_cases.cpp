// Where the scene stands and how large it is told: neither may be seen in the image.
#include "harness/stability/image_checks.hpp"
#include "harness/stability/scene_rig.hpp"
#include "harness/stability/stability_cases.hpp"
#include "scenes/hard_cases/yard.hpp"

namespace alcove {
namespace {

/// The image after the camera has gone to B and come back: frames 0 to 2.
Image replay(const StabilitySubject& subject, SceneRig& rig, WorstScore* worst) {
    const std::unique_ptr<Method> method =
        subject.create(rig.scene().get_ao_radius_m(), rig.size());
    Image image;
    for (const int frame : {0, 1, 2}) {
        const FrameView view = rig.get_view(frame, frame == 0);
        image = rig.shoot(*method, view).visibility;
        if (worst != nullptr) {
            worst->check(image, rig.read_depth(view));
        }
    }
    return image;
}

StabilityScore compare(const StabilitySubject& subject, ImageSize size,
                       const std::vector<YardSettings>& variants) {
    const std::unique_ptr<Scene> plain_scene = make_yard_case({});
    SceneRig plain(subject.context(), *plain_scene, size);
    const Image expected = replay(subject, plain, nullptr);
    WorstScore worst;
    Image picture;
    for (const YardSettings& settings : variants) {
        const std::unique_ptr<Scene> scene = make_yard_case(settings);
        SceneRig rig(subject.context(), *scene, size);
        picture = replay(subject, rig, &worst);
        worst.add(compute_rms_codes(picture, expected), 1.0);
    }
    return worst.finish(std::move(picture));
}

} // namespace

std::vector<StabilityCase> make_placement_cases() {
    StabilityCase offset;
    offset.about = {
        "world_offset",
        "Far from the world's zero",
        "scene and camera stand away from zero in all three axes, and the camera moves",
        "reported: tiles that turn black at a camera height of 3.36e6 (N8python/n8ao#14), black "
        "planes in open worlds (Facepunch/sbox-issues#5863)",
        "offset",
        "m",
        label_severities({0.0, 1e3, 1e5, 1e7, 1e9}, "m"),
        "the image is that at zero",
        "RMS difference from the image at zero",
        "codes",
        "one code of 8 bits. Double precision still resolves 1.2e-7 m at 1e9 m, a millionth of a "
        "pixel here",
    };
    offset.measure = [](const StabilitySubject& subject, ImageSize size, double severity) {
        YardSettings settings;
        settings.origin = glm::dvec3(severity, -severity, severity);
        return compare(subject, size, {settings});
    };
    StabilityCase scale;
    scale.about = {
        "scale",
        "Scale of the scene",
        "geometry, camera path, near and far plane and radius times k and times 1/k; k is a power "
        "of 2, so that rounding stays the same",
        "ours: whoever works in millimetres or kilometres sees constants that were meant in "
        "metres; "
        "reported: huge scales (N8python/n8ao#14)",
        "k",
        "",
        label_severities({1.0, 8.0, 64.0, 512.0, 2048.0}, ""),
        "the image does not change",
        "RMS difference from the image at k = 1",
        "codes",
        "one code of 8 bits; the numbers differ in their exponents alone, so that only a hidden "
        "constant in metres can show",
    };
    scale.find_obstacle = [](const StabilitySubject& subject) {
        return std::string(subject.has_radius() ? "" : "no radius reaches it");
    };
    scale.measure = [](const StabilitySubject& subject, ImageSize size, double severity) {
        YardSettings larger;
        larger.scale = severity;
        YardSettings smaller;
        smaller.scale = 1.0 / severity;
        return compare(subject, size, {larger, smaller});
    };
    return {std::move(offset), std::move(scale)};
}

} // namespace alcove
