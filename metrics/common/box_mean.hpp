#pragma once
// Means over squares of pixels: what fine structure is told from.

#include "core/base/image.hpp"

namespace alcove {

/// Of each pixel (x, y) of a one-channel image, the mean over the `side` x `side` pixels whose
/// first one is (x - before, y - before); 0 where they do not all lie inside. Asserts one channel.
[[nodiscard]] Image compute_box_means(const Image& image, int side, int before);

/// a - b. Asserts equal shapes.
[[nodiscard]] Image subtract_images(const Image& a, const Image& b);

} // namespace alcove
