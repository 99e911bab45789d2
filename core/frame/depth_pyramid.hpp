#pragma once
// The farthest eye depth over squares of an image, level by level, and the question whether a box
// is hidden behind it. This work is based on: Greene, Kass, Miller. Hierarchical Z-buffer
// visibility. 1993.

#include "core/frame/gbuffer.hpp"
#include "core/frame/view_volume.hpp"

#include <vector>

namespace alcove {

class DepthPyramid {
  public:
    /// `eye_depth`: one value a pixel, rows from the bottom, metres, +infinity on the background.
    DepthPyramid(std::vector<float> eye_depth, ImageSize size);

    /// True only if every pixel of `bounds` holds less than `limit_m`.
    [[nodiscard]] bool is_nearer(const ScreenBounds& bounds, double limit_m) const;

  private:
    struct Level {
        ImageSize size;
        std::vector<float> farthest;
    };
    [[nodiscard]] bool is_nearer(std::size_t level, int x, int y, const ScreenBounds& bounds,
                                 double limit_m) const;
    std::vector<Level> m_levels; ///< from pixels to one square
};

/// Two surfaces whose eye depths near `depth_m` differ by more than this many metres are ordered
/// alike by the depth test: a few units in the last place of the raster depth, with the rounding
/// of the projection and of interpolation.
[[nodiscard]] double compute_depth_margin(const Camera& camera, const Precision& precision,
                                          double depth_m);

} // namespace alcove
