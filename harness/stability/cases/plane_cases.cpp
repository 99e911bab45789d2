// An infinite plane blocks nothing of itself, whatever the radius, the angle of view, the distance
// and the tilt.
#include "harness/stability/image_checks.hpp"
#include "harness/stability/scene_rig.hpp"
#include "harness/stability/stability_cases.hpp"
#include "scenes/hard_cases/plane.hpp"

#include <cmath>

#include <glm/trigonometric.hpp>

namespace alcove {
namespace {

constexpr double kRadius = 0.5;

struct PlaneView {
    PlaneSettings plane;
    double radius_m = kRadius;
};

/// The angle of view at which pixels of this image are as fine as the contract tests' (384x288 at
/// 60 degrees), for which tolerances are declared.
double compute_contract_fov(ImageSize size) {
    constexpr double kContractHeight = 288.0;
    return glm::degrees(2.0 *
                        std::atan(std::tan(glm::radians(30.0)) * size.height / kContractHeight));
}

enum class Tolerance { up_to_60_degrees, at_75_degrees };

StabilityScore measure(const StabilitySubject& subject, ImageSize size,
                       const std::vector<PlaneView>& views, Tolerance tolerance) {
    constexpr ImageSize kBlocks{4, 3};
    const double bound = tolerance == Tolerance::at_75_degrees ? subject.preset().plane_tolerance_75
                                                               : subject.preset().plane_tolerance;
    WorstScore worst;
    Image picture;
    for (const PlaneView& shown : views) {
        const std::unique_ptr<Scene> scene = make_plane_case(shown.plane);
        SceneRig rig(subject.context(), *scene, size);
        const std::unique_ptr<Method> method = subject.create(shown.radius_m, size);
        picture = rig.settle(*method, 0, subject.frames()).visibility;
        const Image depth = rig.read_depth(rig.get_view(0));
        worst.check(picture, depth);
        const Image expected(size, 1, static_cast<float>(*subject.unit().plane_response));
        worst.add(compute_worst_block_codes(picture, expected, make_surface_mask(depth), kBlocks),
                  bound);
    }
    return worst.finish(std::move(picture));
}

std::string find_obstacle(const StabilitySubject& subject, bool needs_radius) {
    if (!subject.unit().plane_response) {
        return "its definition gives no response of an infinite plane";
    }
    return needs_radius && !subject.has_radius() ? "no radius reaches it" : "";
}

struct PlaneFamily {
    StabilityCaseRecord about;
    Tolerance tolerance = Tolerance::up_to_60_degrees;
    bool needs_radius = true;
    std::function<std::vector<PlaneView>(double severity, ImageSize size)> make_views;
};

StabilityCase make_case(PlaneFamily family) {
    StabilityCase made;
    made.about = std::move(family.about);
    made.about.invariant = "the plane stays at the method's response to an infinite plane";
    made.about.score = "largest |mean - plane response| over 4 x 3 blocks of the image";
    made.about.score_unit = "codes";
    made.about.bound_reason =
        family.tolerance == Tolerance::at_75_degrees
            ? "the preset's own tolerance for a plane at 75 degrees (2 codes unless its paper's "
              "form needs more); the contract tests hold it in the image's centre, here every "
              "block must keep it"
            : "the preset's own tolerance for planes up to 60 degrees (1 code unless its paper's "
              "form needs more); the contract tests hold it in the image's centre, here every "
              "block must keep it";
    made.find_obstacle = [needs = family.needs_radius](const StabilitySubject& subject) {
        return find_obstacle(subject, needs);
    };
    made.measure = [tolerance = family.tolerance, make_views = family.make_views](
                       const StabilitySubject& subject, ImageSize size, double severity) {
        return measure(subject, size, make_views(severity, size), tolerance);
    };
    return made;
}

StabilityCaseRecord describe(const char* name, const char* title, const char* trigger,
                             const char* source, const char* axis, const char* unit,
                             std::initializer_list<double> values) {
    StabilityCaseRecord about;
    about.name = name;
    about.title = title;
    about.trigger = trigger;
    about.source = source;
    about.axis = axis;
    about.axis_unit = unit;
    about.severities = label_severities(values, unit);
    return about;
}

/// A plane that faces the camera and one that leans 60 degrees, at 5 m.
std::vector<PlaneView> make_radius_views(double radius_m, ImageSize size) {
    const double fov = compute_contract_fov(size);
    return {{{5.0, 0.0, fov}, radius_m}, {{5.0, 60.0, fov}, radius_m}};
}

std::vector<PlaneView> make_fov_views(double degrees, ImageSize) {
    return {{{5.0, 0.0, degrees}, kRadius}};
}

} // namespace

std::vector<StabilityCase> make_plane_cases() {
    const char* const kRadiusSource =
        "reported: dotted shadows at a radius of 0.002 (o3de/o3de#5124), radii beyond what a "
        "denoiser reaches (DiligentFX)";
    const char* const kFovSource =
        "reported: black fighting pixels on walls away from 90 degrees (hzqst/MetaHookSv#42); an "
        "axis that is not normalised errs with the angle of view (DiligentGraphics/DiligentFX, "
        "commit 4c1d1e80)";
    std::vector<StabilityCase> cases;
    cases.push_back(
        make_case({describe("radius_small", "Tiny radius",
                            "planes at 5 m, facing and at 60 degrees; the "
                            "radius shrinks far below a pixel's footprint",
                            kRadiusSource, "radius", "m", {0.5, 0.05, 5e-3, 1e-3, 1e-4}),
                   Tolerance::up_to_60_degrees, true, make_radius_views}));
    cases.push_back(make_case({describe("radius_large", "Huge radius",
                                        "the same planes; the radius grows until kernels "
                                        "reach behind the camera and far over the image",
                                        kRadiusSource, "radius", "m", {0.5, 5.0, 50.0, 500.0, 1e3}),
                               Tolerance::up_to_60_degrees, true, make_radius_views}));
    cases.push_back(make_case(
        {describe("fov_narrow", "Narrow field of view",
                  "a facing plane at 5 m; the vertical angle "
                  "of view falls until the radius is larger than the image",
                  kFovSource, "vertical field of view", "deg", {60.0, 40.0, 20.0, 10.0, 5.0}),
         Tolerance::up_to_60_degrees, false, make_fov_views}));
    cases.push_back(make_case(
        {describe("fov_wide", "Wide field of view",
                  "a facing plane at 5 m; the vertical angle of "
                  "view grows until rays at the corners are at 79 degrees to the plane's normal",
                  kFovSource, "vertical field of view", "deg", {60.0, 90.0, 120.0, 140.0, 150.0}),
         Tolerance::at_75_degrees, false, make_fov_views}));
    cases.push_back(make_case(
        {describe("surface_near", "Surface at the camera",
                  "a plane at 30 degrees comes nearer "
                  "than the radius of 0.5 m, so that samples fall behind the camera",
                  "reported: areas close to the camera go dark (DiligentGraphics/DiligentFX#118); "
                  "samples with w <= 0 (Mattausch et al. 2010, edge cases of section 3)",
                  "distance", "m", {5.0, 1.0, 0.5, 0.1, 0.02}),
         Tolerance::up_to_60_degrees, false, [](double distance_m, ImageSize size) {
             return std::vector<PlaneView>{
                 {{distance_m, 30.0, compute_contract_fov(size)}, kRadius}};
         }}));
    cases.push_back(make_case(
        {describe("plane_grazing", "Grazing plane",
                  "a plane at 5 m leans away until its depth "
                  "changes by metres within a pixel",
                  "reported: a flat plane darkens itself (qgis/QGIS#49702); depth-resolution "
                  "speckle of rays almost parallel to the surface (\"Know your SSAO artifacts\")",
                  "tilt", "deg", {60.0, 75.0, 80.0, 85.0, 88.0}),
         Tolerance::at_75_degrees, false, [](double degrees, ImageSize size) {
             return std::vector<PlaneView>{{{5.0, degrees, compute_contract_fov(size)}, kRadius}};
         }}));
    return cases;
}

} // namespace alcove
