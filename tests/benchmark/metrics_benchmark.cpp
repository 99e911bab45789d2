// The metrics that a run computes a frame, against OpenCV's QualitySSIM on one thread, 1024x768,
// all with their maps. Ours use all cores.

#include "core/contract/temporal_metric.hpp"
#include "metrics/registry.hpp"
#include "tests/benchmark/ratio.hpp"

#include <cmath>
#include <cstdio>
#include <thread>

#include <opencv2/core.hpp>
#include <opencv2/quality/qualityssim.hpp>

namespace {

using namespace alcove;

constexpr ImageSize kSize{1024, 768};
constexpr int kPairs = 31;

/// Codes in [0,1] with structure at every scale, other in each channel.
Image make_image(double phase, int channels) {
    Image image(kSize, channels);
    std::uint32_t state = 7;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            for (int c = 0; c < channels; ++c) {
                state = 1664525u * state + 1013904223u;
                const double noise = static_cast<double>(state >> 8) * 0x1p-24;
                const double wave = std::sin(0.05 * x + 0.03 * y + phase + 0.5 * c);
                image.at(x, y, c) = static_cast<float>(0.45 + 0.4 * wave + 0.1 * noise);
            }
        }
    }
    return image;
}

class Benchmark {
  public:
    Benchmark() {
        // OpenCV's constants are those of codes 0..255.
        m_cv_test = cv::Mat(kSize.height, kSize.width, CV_32F, m_test.values().data()) * 255.0;
        m_cv_reference =
            cv::Mat(kSize.height, kSize.width, CV_32F, m_reference.values().data()) * 255.0;
    }

    /// Same quantity, or the comparison says nothing: borders are 3 % of the pixels.
    bool compares_the_same() {
        const double ours = create("ssim")->evaluate({m_test, m_reference}).value.value_or(0.0);
        const double theirs = run_opencv();
        std::printf("# ssim: ours %.6f, OpenCV %.6f (its region includes the reflected borders); "
                    "%u cores\n",
                    ours, theirs, std::thread::hardware_concurrency());
        return std::abs(ours - theirs) <= 0.01;
    }

    bool hold(const std::string& name, const std::string& metric, int channels, double bound) {
        const auto unit_metric = create(metric);
        const Image test = make_image(0.0, channels);
        const Image reference = make_image(0.3, channels);
        return compare(name, bound, [&] {
            static_cast<void>(unit_metric->evaluate({test, reference}));
        });
    }

    /// One frame of a sequence, with halves of the reference, along a pan of half a pixel.
    bool hold_flicker(double bound) {
        const MetricUnit& unit = m_registry.find("temporal_flicker");
        const auto metric = unit.create_temporal(unit.parameters.resolve({}, {}));
        EarlierFrame earlier{1, make_identity_correspondence(kSize), m_reference, m_reference,
                             m_test};
        for (int y = 0; y < kSize.height; ++y) {
            for (int x = 0; x < kSize.width; ++x) {
                earlier.correspondence.position.at(x, y, 0) += 0.5f;
            }
        }
        const Image surface(kSize, 1, 1.0f);
        const Image moves(kSize, 1);
        metric->reset();
        static_cast<void>(
            metric->add({m_test, m_reference, &m_reference, &m_test, {}, surface, moves}));
        return compare("TF / OpenCV QualitySSIM", bound, [&] {
            static_cast<void>(metric->add({m_test, m_reference, &m_reference, &m_test,
                                           std::span(&earlier, 1), surface, moves}));
        });
    }

  private:
    std::unique_ptr<Metric> create(const std::string& name) const {
        const MetricUnit& unit = m_registry.find(name);
        return unit.create(unit.parameters.resolve({}, {}));
    }
    double run_opencv() {
        return cv::quality::QualitySSIM::compute(m_cv_test, m_cv_reference, m_cv_map)[0];
    }
    bool compare(const std::string& name, double bound, const std::function<void()>& ours) {
        return print_target(name + ", 1024x768", bound, false,
                            time_in_turn(
                                ours, [&] { run_opencv(); }, kPairs));
    }

    Registry<MetricUnit> m_registry = metrics_registry();
    Image m_test = make_image(0.0, 1);
    Image m_reference = make_image(0.3, 1);
    cv::Mat m_cv_test;
    cv::Mat m_cv_reference;
    cv::Mat m_cv_map;
};

} // namespace

int main() {
    cv::setNumThreads(1);
    Benchmark benchmark;
    if (!benchmark.compares_the_same()) {
        std::printf("the two do not measure the same thing\n");
        return 1;
    }
    bool met = benchmark.hold("SSIM / OpenCV QualitySSIM", "ssim", 1, 0.16);
    met = benchmark.hold("MS-SSIM / OpenCV QualitySSIM", "ms_ssim", 1, 0.35) && met;
    met = benchmark.hold("FLIP of colour / OpenCV QualitySSIM", "flip", 3, 1.3) && met;
    met = benchmark.hold("FLIP of grey / OpenCV QualitySSIM", "flip", 1, 1.3) && met;
    met = benchmark.hold_flicker(0.15) && met;
    return met ? 0 : 3;
}
