// This work is based on: Chu, Xie, Mayer, Leal-Taixe, Thuerey. Learning Temporal Coherence via
// Self-Supervision for GAN-based Video Generation (TecoGAN). 2020, equation (5), tOF; flow by
// Farneback. Two-Frame Motion Estimation Based on Polynomial Expansion. 2003.
#include "metrics/t_of/t_of.hpp"

#include "core/base/domain.hpp"
#include "core/contract/temporal_metric.hpp"
#include "metrics/common/planted_sequence.hpp"

#include <cmath>
#include <limits>

#include <opencv2/video/tracking.hpp>

namespace alcove {
namespace {

/// Codes of 8 bits, which is what the published script estimates flow on.
cv::Mat make_codes(const Image& visibility) {
    cv::Mat codes(visibility.height(), visibility.width(), CV_8UC1);
    for (int y = 0; y < visibility.height(); ++y) {
        for (int x = 0; x < visibility.width(); ++x) {
            codes.at<std::uint8_t>(y, x) =
                static_cast<std::uint8_t>(std::lround(255.0f * encode_srgb(visibility.at(x, y))));
        }
    }
    return codes;
}

/// With the script's constants.
cv::Mat estimate_flow(const cv::Mat& before, const cv::Mat& now) {
    constexpr double kPyramidScale = 0.5;
    constexpr int kLevels = 3;
    constexpr int kWindow = 15;
    constexpr int kIterations = 3;
    constexpr int kNeighbourhood = 5;
    constexpr double kSigma = 1.2;
    cv::Mat flow;
    cv::calcOpticalFlowFarneback(before, now, flow, kPyramidScale, kLevels, kWindow, kIterations,
                                 kNeighbourhood, kSigma, 0);
    return flow;
}

class TOf final : public TemporalMetric {
  public:
    void reset() override { m_previous.reset(); }

    std::optional<MetricResult> add(const TemporalFrame& frame) override {
        check_temporal_frame(frame, "t_of");
        Codes now{make_codes(frame.test), make_codes(frame.reference)};
        std::optional<MetricResult> result;
        if (m_previous && !frame.earlier.empty()) {
            result = compare(estimate_flow(m_previous->test, now.test),
                             estimate_flow(m_previous->reference, now.reference));
        }
        m_previous = std::move(now);
        return result;
    }

  private:
    struct Codes {
        cv::Mat test;
        cv::Mat reference;
    };

    [[nodiscard]] static MetricResult compare(const cv::Mat& test, const cv::Mat& reference) {
        MetricResult result;
        result.map = Image({test.cols, test.rows}, 1);
        double sum = 0.0;
        for (int y = 0; y < test.rows; ++y) {
            for (int x = 0; x < test.cols; ++x) {
                const cv::Vec2f difference =
                    test.at<cv::Vec2f>(y, x) - reference.at<cv::Vec2f>(y, x);
                const float length = std::hypot(difference[0], difference[1]);
                result.map->at(x, y) = length;
                sum += static_cast<double>(length);
            }
        }
        result.value = sum / static_cast<double>(result.map->size().pixel_count());
        return result;
    }

    std::optional<Codes> m_previous;
};

constexpr ImageSize kCheckSize{96, 72};

/// Waves in both directions that a point of the surface carries along.
Image make_waves(PlantedMotion motion, int frame) {
    Image image(kCheckSize, 1);
    for (int y = 0; y < kCheckSize.height; ++y) {
        for (int x = 0; x < kCheckSize.width; ++x) {
            const PlantedPoint point = find_planted_point(kCheckSize, motion, frame, x, y);
            image.at(x, y) =
                static_cast<float>(0.5 + 0.2 * std::sin(0.4 * point.x) * std::cos(0.35 * point.y) +
                                   0.1 * std::sin(0.17 * point.x + 0.23 * point.y));
        }
    }
    return image;
}

/// Truth pans by a pixel a frame; the test does too, or stands.
double run_pan(TemporalMetric& metric, bool stands) {
    std::vector<PlantedFrame> frames(3,
                                     make_planted_frame(kCheckSize, PlantedMotion::pan_one_pixel));
    for (std::size_t t = 0; t < frames.size(); ++t) {
        frames[t].reference = make_waves(PlantedMotion::pan_one_pixel, static_cast<int>(t));
        frames[t].test = stands ? make_waves(PlantedMotion::still, 0) : frames[t].reference;
    }
    return get_last_planted_value(metric, frames);
}

} // namespace

MetricUnit t_of_unit() {
    MetricUnit unit;
    unit.name = "t_of";
    unit.title = "tOF (difference of optical flow)";
    unit.unit = "px";
    unit.definition =
        "Chu et al. 2020: mean over all pixels of the length of F(t_(t-1), t_t) - F(r_(t-1), r_t), "
        "F the optical flow by Farneback on sRGB codes of 8 bits (OpenCV; pyramid 0.5, 3 levels, "
        "window 15, 3 iterations, neighbourhood 5, sigma 1.2). Nothing on a first frame.";
    unit.blind_to = "errors that do not look like motion: a bias, a constant test where truth "
                    "stands, whatever lies on areas without texture; and what the estimated flow "
                    "itself gets wrong, alike in both.";
    unit.on_demand = true;
    unit.maximum = std::numeric_limits<double>::infinity();
    unit.best = 0.0;
    unit.parameters = describe_parameters("t_of", {});
    unit.temporal_checks = {
        {"truth", [](TemporalMetric& metric) { return run_pan(metric, false); }, 0.0, 1e-6,
         "by definition"},
        {"a test that stands while truth pans by a pixel",
         [](TemporalMetric& metric) { return run_pan(metric, true); }, 1.0, 0.1,
         "theory: the length of the pan; borders are estimated badly"},
    };
    unit.create_temporal = [](const ResolvedParameters&) { return std::make_unique<TOf>(); };
    return unit;
}

} // namespace alcove
