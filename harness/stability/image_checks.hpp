#pragma once
// What cases ask of visibility images. All are one channel, row 0 on top, equal in size.

#include "core/base/image.hpp"
#include "harness/stability/stability_case.hpp"

#include <string>

namespace alcove {

/// One code of an 8-bit image: what a display can show.
inline constexpr double kOneCode = 1.0 / 255.0;

/// What is wrong with a visibility whatever the case: the first value that is NaN, infinite or
/// outside [0,1], or the first background pixel (infinite depth) that is not exactly 1, with its
/// place; empty if nothing is.
[[nodiscard]] std::string find_fault(const Image& visibility, const Image& depth);

/// Root mean square of a - b over all pixels, in codes.
[[nodiscard]] double compute_rms_codes(const Image& a, const Image& b);
/// Mean of a - b over the pixels where `mask` is not 0, in codes; 0 where there is none.
[[nodiscard]] double compute_mean_codes(const Image& a, const Image& b, const Image& mask);

/// The largest |mean of a - b| over the blocks of a grid, in codes; only pixels where `mask` is not
/// 0 count, and only blocks that it fills at least by half.
[[nodiscard]] double compute_worst_block_codes(const Image& a, const Image& b, const Image& mask,
                                               ImageSize grid);

/// 1 on surfaces, 0 on the background.
[[nodiscard]] Image make_surface_mask(const Image& depth);

/// Running sum of images.
class MeanImage {
  public:
    void add(const Image& image);
    [[nodiscard]] Image compute() const;

  private:
    Image m_sum;
    int m_count = 0;
};

/// The worst of several scores of one severity, by their margins, and the first fault.
class WorstScore {
  public:
    void add(double score, double bound);
    void check(const Image& visibility, const Image& depth);
    [[nodiscard]] StabilityScore finish(Image picture) const;

  private:
    StabilityScore m_worst;
    bool m_is_empty = true;
};

} // namespace alcove
