// Odd and even sizes: no bright or dark line through the centre or along the border.
#include "harness/stability/image_checks.hpp"
#include "harness/stability/scene_rig.hpp"
#include "harness/stability/stability_cases.hpp"
#include "scenes/hard_cases/groove.hpp"

#include <algorithm>
#include <cmath>

namespace alcove {
namespace {

constexpr int kSeeds = 4;

/// Mean of every line across the groove's axis, in codes.
std::vector<double> compute_profile(const Image& image, GrooveAxis axis) {
    const bool is_horizontal = axis == GrooveAxis::horizontal;
    const int lines = is_horizontal ? image.width() : image.height();
    const int length = is_horizontal ? image.height() : image.width();
    std::vector<double> profile(static_cast<std::size_t>(lines));
    for (int line = 0; line < lines; ++line) {
        double sum = 0.0;
        for (int i = 0; i < length; ++i) {
            sum += static_cast<double>(is_horizontal ? image.at(line, i) : image.at(i, line));
        }
        profile[static_cast<std::size_t>(line)] = sum / (kOneCode * length);
    }
    return profile;
}

/// How much a line stands out from those two lines away on both sides; at the border from what the
/// next lines inside lead on to, since kernels that leave the image make a slope there.
double compute_contrast(const std::vector<double>& profile, std::size_t line) {
    const std::size_t last = profile.size() - 1;
    if (line == 0) {
        return std::abs(profile[0] - 2.0 * profile[1] + profile[2]);
    }
    if (line == last) {
        return std::abs(profile[last] - 2.0 * profile[last - 1] + profile[last - 2]);
    }
    const double low = profile[line < 2 ? 0 : line - 2];
    const double high = profile[std::min(line + 2, last)];
    return std::abs(profile[line] - 0.5 * (low + high));
}

void judge_lines(const std::vector<double>& profile, WorstScore& worst) {
    const std::size_t last = profile.size() - 1;
    const std::size_t centre = profile.size() / 2;
    std::vector<double> others;
    for (std::size_t line = 4; line + 4 <= last; ++line) {
        const bool is_centre = line + 3 > centre && line < centre + 3;
        if (!is_centre) {
            others.push_back(compute_contrast(profile, line));
        }
    }
    std::sort(others.begin(), others.end());
    // 1.48 times the median of |x| is the standard deviation of a normal x; 6 of them leave room
    // for the few hundred lines that are looked at.
    const double noise = 6.0 * 1.48 * others[others.size() / 2];
    const double bound = std::max(2.0, noise);
    for (const std::size_t line : {std::size_t{0}, centre - 1, centre, centre + 1, last}) {
        worst.add(compute_contrast(profile, line), bound);
    }
}

void judge_size(const StabilitySubject& subject, ImageSize size, WorstScore& worst,
                Image& picture) {
    for (const GrooveAxis axis : {GrooveAxis::horizontal, GrooveAxis::vertical}) {
        const std::unique_ptr<Scene> scene = make_groove_case(axis);
        SceneRig rig(subject.context(), *scene, size);
        const std::unique_ptr<Method> method = subject.create(scene->get_ao_radius_m(), size);
        MeanImage mean;
        for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
            ShotOptions options;
            options.seed = seed;
            mean.add(rig.settle(*method, 0, subject.frames(), options).visibility);
        }
        picture = mean.compute();
        worst.check(picture, rig.read_depth(rig.get_view(0)));
        judge_lines(compute_profile(picture, axis), worst);
    }
}

StabilityScore measure(const StabilitySubject& subject, ImageSize wish, double added) {
    // A multiple of 8, so that what is added decides about halves and quarters.
    const ImageSize base{std::max(32, wish.width / 8 * 8), std::max(32, wish.height / 8 * 8)};
    const int more = static_cast<int>(added);
    WorstScore worst;
    Image picture;
    judge_size(subject, {base.width + more, base.height + more}, worst, picture);
    if (more > 0) {
        judge_size(subject, {base.width + more, base.height}, worst, picture);
        judge_size(subject, {base.width, base.height + more}, worst, picture);
    }
    return worst.finish(std::move(picture));
}

} // namespace

std::vector<StabilityCase> make_size_cases() {
    StabilityCase made;
    made.about = {
        "size_odd",
        "Odd sizes",
        "a groove that is the same along one axis of the image, at sizes n, n+1, n+2 and n+3 in "
        "width, height and both; n is a multiple of 8",
        "reported: a dark line in the centre at sizes not divisible by 4 (godotengine/godot#62881, "
        "#59471), streaks at odd sizes (godotengine/godot#73697), half-pixel offsets "
        "(Unity-Technologies/Graphics#4895), border lines (turanszkij/WickedEngine#926)",
        "pixels over a multiple of 8",
        "px",
        label_severities({0.0, 1.0, 2.0, 3.0}, "px"),
        "neither the centre lines nor the border lines stand out from their neighbours",
        "contrast of a line's mean against the lines around it, over four seeds; the worst of "
        "centre and border",
        "codes",
        "the larger of 2 codes, which is where a line a pixel wide begins to be seen, and six "
        "standard deviations of the contrast of all other lines of the same image, which is the "
        "method's own noise",
    };
    made.measure = measure;
    return {std::move(made)};
}

} // namespace alcove
