#pragma once
// The contract of a metric over time: a function of a sequence of images, of where each surface
// point was before, and of what the method says of its history. No OpenGL, no files.

#include "core/base/correspondence.hpp"
#include "core/contract/metric.hpp"

#include <array>
#include <span>

namespace alcove {

/// How far back a temporal metric can look, in frames.
inline constexpr std::array kEarlierSteps{1, 2, 4, 8};

/// Truth some frames ago, as seen from now: warped along the surfaces' own motion, 0 where the
/// correspondence is not valid.
struct EarlierFrame {
    int steps = 1; ///< one of kEarlierSteps
    /// Valid where the point was inside the image, of the same object, at the same depth within 1 %
    /// and turned alike (cosine over 0.9), eroded by one pixel; over several steps, at each of
    /// them.
    Correspondence correspondence;
    Image reference; ///< the mean of the halves
    std::optional<Image> reference_a;
    std::optional<Image> reference_b;
};

/// One frame of a sequence. All images have one size and one channel unless said otherwise, and
/// hold linear visibility, or the luminance of pictures in linear light. Geometry comes from the
/// full-precision G-buffer, whatever the method saw.
struct TemporalFrame {
    const Image& test;
    const Image& reference; ///< the mean of the halves where there are halves
    const Image* reference_a = nullptr;
    const Image* reference_b = nullptr; ///< both or none
    /// Ascending in `steps`; empty on the first frame, and only as far as the sequence reaches
    /// back.
    std::span<const EarlierFrame> earlier;
    const Image& surface; ///< 1 where the pixel shows a surface, 0 on the background
    const Image& moves;   ///< 1 where the object under the pixel has moved since the last frame
    /// Four channels as HistoryChannel says; nothing for methods without a history.
    const Image* history_state = nullptr;
    bool is_last = false; ///< of the sequence: what needs all of it answers here
};

/// Follows one sequence. `add` is called for every frame in order; `reset` before the first one and
/// at each cut.
class TemporalMetric {
  public:
    TemporalMetric() = default;
    virtual ~TemporalMetric() = default;
    TemporalMetric(const TemporalMetric&) = delete;
    TemporalMetric& operator=(const TemporalMetric&) = delete;

    virtual void reset() = 0;
    /// This frame's value, or nothing where the metric has nothing to say of this frame by its
    /// nature (a first frame, a method without history, a sum that is told on the last frame). A
    /// value that is undefined is a result without value and with its reason. `map`, where there is
    /// one, has the frame's size. Throws InputError on NaN or infinity in the test image.
    [[nodiscard]] virtual std::optional<MetricResult> add(const TemporalFrame& frame) = 0;
};

/// Throws InputError unless sizes and channels are as TemporalFrame says and all values of `test`
/// are finite. What every temporal metric checks first.
void check_temporal_frame(const TemporalFrame& frame, std::string_view metric);

} // namespace alcove
