#pragma once
// Where the surface point that a pixel shows was seen in an earlier image: what temporal metrics
// compare along.

#include "core/base/image.hpp"

#include <span>

namespace alcove {

/// From each pixel of an image to a place in an earlier image of the same size.
struct Correspondence {
    /// Two channels: x and y in pixels of the earlier image, y down, the first pixel's centre at
    /// (0.5, 0.5). Without meaning where the point has appeared.
    Image position;
    /// One channel: 1 where the same surface was seen all around the place, so that values may be
    /// interpolated there, else 0.
    Image valid;
    /// One channel: 1 where a surface point was hidden or outside the image then, else 0. Edges of
    /// what was visible are neither valid nor appeared.
    Image appeared;
};

/// Every pixel stays where it is, is valid and has not appeared.
[[nodiscard]] Correspondence make_identity_correspondence(ImageSize size);

/// The earlier image as seen from now: bilinear between the four pixels around each position,
/// clamped at the border; 0 where not valid. Asserts equal sizes.
/// warp_row gives row y of it, all channels of a pixel together.
void warp_row(const Image& earlier, const Correspondence& correspondence, int y,
              std::span<float> out);
[[nodiscard]] Image warp_image(const Image& earlier, const Correspondence& correspondence);

/// From now over the middle image to an earlier one: `now_to_middle` first, then
/// `middle_to_earlier`, whose displacement is interpolated bilinearly and whose masks are those of
/// the nearest pixel: valid where both are, appeared where one has. Asserts equal sizes.
[[nodiscard]] Correspondence compose_correspondences(const Correspondence& now_to_middle,
                                                     const Correspondence& middle_to_earlier);

} // namespace alcove
