#pragma once
// Sequences on which metrics over time are known by hand or by theory: what their checks and tests
// run on (no files needed).

#include "core/contract/temporal_metric.hpp"

#include <cstdint>
#include <vector>

namespace alcove {

/// How what is seen moves from one frame to the next.
enum class PlantedMotion {
    still,
    pan_one_pixel,  ///< everything moves 1 pixel to the left
    pan_half_pixel, ///< everything moves 0.5 pixels to the left
    rotating_disc   ///< a disc turns by 0.07 rad about the middle of a still image
};

struct PlantedFrame {
    Image test;
    Image reference;
    std::optional<Image> reference_a; ///< both halves or none; `reference` is their mean
    std::optional<Image> reference_b;
    Correspondence to_previous; ///< not looked at on the first frame
    Image surface;
    Image moves;
    std::optional<Image> history_state;
};

/// All surface, test and reference 0.5, no halves. Valid where all four pixels of the bilinear
/// fetch lie inside the image and on the same side of the disc's edge; appeared where they lie
/// outside.
[[nodiscard]] PlantedFrame make_planted_frame(ImageSize size, PlantedMotion motion);

/// A point of the surface: where in frame 0 it is seen, in pixels, or would be seen outside.
struct PlantedPoint {
    double x = 0.0;
    double y = 0.0;
};
[[nodiscard]] PlantedPoint find_planted_point(ImageSize size, PlantedMotion motion, int frame,
                                              int x, int y);

/// Independent values of mean 0 and variance 1, uniform; the same for the same seed everywhere.
[[nodiscard]] Image make_planted_noise(ImageSize size, std::uint32_t seed);

/// image += scale x other. Asserts equal sizes and channels.
void add_scaled(Image& image, const Image& other, double scale);

/// The frames with `scale` x what `make` gives for each frame's number added to the test image.
template <class Make>
[[nodiscard]] std::vector<PlantedFrame> plant_errors(ImageSize size, PlantedMotion motion,
                                                     int count, double scale, const Make& make) {
    std::vector<PlantedFrame> frames(static_cast<std::size_t>(count),
                                     make_planted_frame(size, motion));
    for (int t = 0; t < count; ++t) {
        add_scaled(frames[static_cast<std::size_t>(t)].test, make(t), scale);
    }
    return frames;
}

/// Resets the metric and feeds it the frames, with all earlier ones that the contract asks for.
[[nodiscard]] std::vector<std::optional<MetricResult>>
follow_planted(TemporalMetric& metric, const std::vector<PlantedFrame>& frames);

/// The value of the last frame. Throws FailureError where it has none.
[[nodiscard]] double get_last_planted_value(TemporalMetric& metric,
                                            const std::vector<PlantedFrame>& frames);

} // namespace alcove
