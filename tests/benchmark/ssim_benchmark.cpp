// SSIM against OpenCV's QualitySSIM, 1024x768, one thread, both with their map: at most a third of
// its time.

#include "metrics/ssim/ssim.hpp"
#include "tests/benchmark/ratio.hpp"

#include <cmath>
#include <cstdio>

#include <opencv2/core.hpp>
#include <opencv2/quality/qualityssim.hpp>

namespace {

using namespace alcove;

/// Codes in [0,1] with structure at every scale.
Image make_image(double phase) {
    Image image({1024, 768}, 1);
    std::uint32_t state = 7;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            state = 1664525u * state + 1013904223u;
            const double noise = static_cast<double>(state >> 8) * 0x1p-24;
            image.at(x, y) = static_cast<float>(0.45 + 0.4 * std::sin(0.05 * x + 0.03 * y + phase) +
                                                0.1 * noise);
        }
    }
    return image;
}

cv::Mat to_mat(Image& image, double scale) {
    const cv::Mat codes(image.height(), image.width(), CV_32F, image.values().data());
    return codes * scale;
}

} // namespace

int main() {
    cv::setNumThreads(1);
    Image test = make_image(0.0);
    Image reference = make_image(0.3);
    const MetricUnit unit = ssim_unit();
    const auto metric = unit.create(unit.parameters.resolve({}, {}));
    // OpenCV's constants are those of codes 0..255.
    const cv::Mat cv_test = to_mat(test, 255.0);
    const cv::Mat cv_reference = to_mat(reference, 255.0);
    double ours = 0.0;
    double theirs = 0.0;
    const std::vector<double> ratios = time_in_turn(
        [&] {
            ours = metric->evaluate({test, reference}).value.value_or(0.0);
        },
        [&] {
            cv::Mat map;
            theirs = cv::quality::QualitySSIM::compute(cv_test, cv_reference, map)[0];
        },
        31);
    std::printf("# ssim: ours %.6f, OpenCV %.6f (its region includes the reflected borders)\n",
                ours, theirs);
    // Same quantity, or the comparison says nothing: borders are 3 % of the pixels.
    if (std::abs(ours - theirs) > 0.01) {
        std::printf("the two do not measure the same thing\n");
        return 1;
    }
    return print_target("SSIM / OpenCV QualitySSIM, 1024x768, one thread", 1.0 / 3.0, false, ratios)
               ? 0
               : 3;
}
