// What a history may not do to an image: drift while nothing moves, spoil a view that is returned
// to, or change with the number of samples that it is allowed to count.
#include "core/base/text.hpp"
#include "harness/stability/image_checks.hpp"
#include "harness/stability/scene_rig.hpp"
#include "harness/stability/stability_cases.hpp"
#include "scenes/hard_cases/foreground.hpp"
#include "scenes/hard_cases/yard.hpp"

#include <cmath>
#include <limits>

namespace alcove {
namespace {

constexpr std::string_view kCapSymbol = "n_max";

/// The yard with what the method would make of it with very many samples.
struct HistoryRig {
    HistoryRig(const StabilitySubject& subject, ImageSize size, const YardSettings& settings = {})
        : scene(make_yard_case(settings)), rig(subject.context(), *scene, size),
          depth(rig.read_depth(rig.get_view(0))), mask(make_surface_mask(depth)) {
        if (subject.unit().converged_preset) {
            limit = rig.settle(*subject.create_converged(scene->get_ao_radius_m(), size), 0, 1)
                        .visibility;
        }
    }

    std::unique_ptr<Scene> scene;
    SceneRig rig;
    Image depth;
    Image mask;
    Image limit; ///< empty if the method has none
};

std::string find_limit_obstacle(const StabilitySubject& subject) {
    return subject.unit().converged_preset ? "" : "it has no limit of many samples to compare with";
}

StabilityScore measure_cap(const StabilitySubject& subject, ImageSize size, double cap,
                           int frames) {
    HistoryRig history(subject, size);
    const std::vector<ParameterOverride> forced{
        {*subject.find_symbol(kCapSymbol), format_number(cap), Provenance::command_line}};
    const std::unique_ptr<Method> method =
        subject.create(history.scene->get_ao_radius_m(), size, forced);
    const Image picture = history.rig.settle(*method, 0, frames).visibility;
    WorstScore worst;
    worst.check(picture, history.depth);
    worst.add(std::abs(compute_mean_codes(picture, history.limit, history.mask)), 2.0);
    return worst.finish(picture);
}

StabilityCase make_cap_case(const char* name, const char* title, const char* trigger,
                            std::initializer_list<double> values, int frames) {
    StabilityCase made;
    made.about = {
        name,
        title,
        trigger,
        "Mattausch et al. 2010, equation (6): numerical cases n_max = 1, k > n_max and n_max = inf",
        "n_max",
        "samples",
        label_severities(values, ""),
        "how many samples a history counts for changes the noise, not the mean",
        "|mean difference| over surfaces from the method's own limit of many samples, after " +
            std::to_string(frames) + " frames of a still camera",
        "codes",
        "2 codes: the mean of some 5000 pixels with a standard deviation of 0.1 each is good to "
        "0.4 codes, and filters at edges move it by about one",
    };
    made.find_obstacle = [](const StabilitySubject& subject) -> std::string {
        if (!subject.has_history() || !subject.find_symbol(kCapSymbol)) {
            return "no history with a cap";
        }
        return find_limit_obstacle(subject);
    };
    made.measure = [frames](const StabilitySubject& subject, ImageSize size, double severity) {
        return measure_cap(subject, size, severity, frames);
    };
    return made;
}

constexpr std::string_view kSampleSymbols[] = {"n", "k1", "k2"};

/// Where nearly every sample is blocked and no history evens them out, weights show that do not sum
/// to 1: every frame is looked at for faults.
void check_slit(const StabilitySubject& subject, ImageSize size,
                std::vector<ParameterOverride> forced, WorstScore& worst) {
    if (const std::optional<std::string> name = subject.find_symbol(kCapSymbol)) {
        forced.push_back({*name, "1", Provenance::command_line});
    }
    const std::unique_ptr<Scene> scene = make_slit_case();
    SceneRig rig(subject.context(), *scene, size);
    const std::unique_ptr<Method> method = subject.create(scene->get_ao_radius_m(), size, forced);
    const FrameView first = rig.get_view(0, true);
    const Image depth = rig.read_depth(first);
    constexpr int kFrames = 16;
    for (int frame = 0; frame < kFrames; ++frame) {
        worst.check(rig.shoot(*method, frame == 0 ? first : hold(first)).visibility, depth);
    }
}

StabilityScore measure_samples(const StabilitySubject& subject, ImageSize size, double samples) {
    HistoryRig history(subject, size);
    std::vector<ParameterOverride> forced;
    for (const std::string_view symbol : kSampleSymbols) {
        if (const std::optional<std::string> name = subject.find_symbol(symbol)) {
            forced.push_back({*name, format_number(samples), Provenance::command_line});
        }
    }
    const std::unique_ptr<Method> method =
        subject.create(history.scene->get_ao_radius_m(), size, forced);
    const Image picture = history.rig.settle(*method, 0, subject.frames()).visibility;
    WorstScore worst;
    worst.check(picture, history.depth);
    worst.add(std::abs(compute_mean_codes(picture, history.limit, history.mask)), 2.0);
    check_slit(subject, size, std::move(forced), worst);
    return worst.finish(picture);
}

StabilityCase make_samples_case() {
    StabilityCase made;
    made.about = {
        "few_samples",
        "Few samples",
        "the samples of a frame fall to one, in the yard and, with a history that counts one "
        "sample, "
        "behind a slit where nearly all are blocked",
        "\"Know your SSAO artifacts\": N samples that are turned about the normal sweep N cones; "
        "reported: bands with few samples (google/filament#3074)",
        "samples a frame",
        "samples",
        label_severities({64.0, 32.0, 16.0, 8.0, 4.0, 1.0}, ""),
        "fewer samples are noisier, not brighter or darker, and no weight drives the visibility "
        "out of [0,1]",
        "|mean difference| over surfaces from the method's own limit of many samples",
        "codes",
        "2 codes, as for the cap of a history: the mean over the image averages the noise out",
    };
    made.find_obstacle = [](const StabilitySubject& subject) -> std::string {
        for (const std::string_view symbol : kSampleSymbols) {
            if (subject.find_symbol(symbol)) {
                return find_limit_obstacle(subject);
            }
        }
        return "it declares no number of samples (n, k1, k2)";
    };
    made.measure = measure_samples;
    return made;
}

/// A to B, B for a while, and back.
StabilityScore measure_return(const StabilitySubject& subject, ImageSize size, double frames_away) {
    HistoryRig history(subject, size);
    SceneRig& rig = history.rig;
    const std::unique_ptr<Method> method = subject.create(history.scene->get_ao_radius_m(), size);
    WorstScore worst;
    const Image fresh = rig.settle(*method, 0, 1).visibility;
    worst.check(fresh, history.depth);
    static_cast<void>(rig.shoot(*method, rig.get_view(1)));
    const FrameView away = hold(rig.get_view(1));
    for (int frame = 1; frame < static_cast<int>(frames_away); ++frame) {
        static_cast<void>(rig.shoot(*method, away));
    }
    const Image returned = rig.shoot(*method, rig.get_view(2)).visibility;
    worst.check(returned, history.depth);
    worst.add(compute_rms_codes(returned, history.limit),
              compute_rms_codes(fresh, history.limit) + 1.0);
    return worst.finish(returned);
}

StabilityScore measure_drift(const StabilitySubject& subject, ImageSize size, double frames) {
    constexpr int kSettled = 16;
    HistoryRig history(subject, size);
    const std::unique_ptr<Method> method = subject.create(history.scene->get_ao_radius_m(), size);
    const Image before = history.rig.settle(*method, 0, kSettled).visibility;
    const FrameView held = hold(history.rig.get_view(0));
    Image after = before;
    for (int frame = 0; frame < static_cast<int>(frames); ++frame) {
        after = history.rig.shoot(*method, held).visibility;
    }
    WorstScore worst;
    worst.check(after, history.depth);
    worst.add(std::abs(compute_mean_codes(after, before, history.mask)), 1.0);
    return worst.finish(after);
}

} // namespace

std::vector<StabilityCase> make_history_cases() {
    StabilityCase back;
    back.about = {
        "camera_return",
        "Camera goes and comes back",
        "the camera steps 0.4 m (a radius) aside, stays there, and steps back",
        "ours (A-B-A); reported: trails after movement (nem0/LumixEngine#1486), stale history "
        "(Unity-Technologies/Graphics#3457)",
        "frames away",
        "frames",
        label_severities({1.0, 4.0, 16.0, 64.0}, ""),
        "the image after the return is no worse than a first frame",
        "RMS difference from the method's own limit of many samples, after the return",
        "codes",
        "what a first frame of the same view has, and one code: a history that is kept must be "
        "worth at least as much as none",
    };
    back.find_obstacle = find_limit_obstacle;
    back.measure = measure_return;
    StabilityCase drift;
    drift.about = {
        "still_drift",
        "Drift under a still camera",
        "nothing moves, camera and seed are held",
        "ours (zero drift); reported: moving lines from histories fetched off their texels "
        "(Unity-Technologies/Graphics#4895, #5249)",
        "frames",
        "frames",
        label_severities({1.0, 16.0, 64.0, 200.0}, ""),
        "the mean brightness of surfaces stays what it was after 16 frames",
        "|mean change| over surfaces since the 16th frame",
        "codes",
        "one code: the noise of the mean of some 5000 pixels is below half a code after 16 frames",
    };
    drift.measure = measure_drift;
    std::vector<StabilityCase> cases;
    cases.push_back(make_cap_case("history_cap_low", "Low cap of the history",
                                  "the cap falls below the samples of one frame",
                                  {1000.0, 100.0, 32.0, 8.0, 1.0}, 16));
    cases.push_back(make_cap_case("history_cap_high", "History without a cap",
                                  "the cap rises until the history counts without end",
                                  {1000.0, 1e4, 1e6, std::numeric_limits<double>::infinity()}, 64));
    cases.push_back(make_samples_case());
    cases.push_back(std::move(back));
    cases.push_back(std::move(drift));
    return cases;
}

} // namespace alcove
