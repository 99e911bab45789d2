#pragma once
// Which frames of a walkthrough are replayed.

#include "reports/record/record.hpp"

#include <string_view>
#include <vector>

namespace alcove {

/// The default for N frames: bursts of 16 at 0, (N-16)/2 and N-16, singles at floor((k+0.5) N/8), k
/// = 0..7. Shorter walkthroughs (N < 48) have one burst of min(16, N). Ordered: bursts first, then
/// singles.
[[nodiscard]] std::vector<SegmentRecord> make_default_segments(int frame_count);

/// `--quick`: the first burst and the singles, 24 frames.
[[nodiscard]] std::vector<SegmentRecord> make_quick_segments(int frame_count);

/// Reads "A:B", a half-open range with 0 <= A < B <= frame_count. Throws InputError.
[[nodiscard]] SegmentRecord parse_frames(std::string_view text, int frame_count);

/// The burst that is kept as a film: the middle one of the bursts, its first kMostFilmFrames
/// frames; empty where there is no burst.
inline constexpr int kMostFilmFrames = 128;
[[nodiscard]] SegmentRecord choose_film(const std::vector<SegmentRecord>& segments);

/// Frames whose pictures are kept: all singles, or, where there are none, up to 4 spread over the
/// segments.
[[nodiscard]] std::vector<int> choose_image_frames(const std::vector<SegmentRecord>& segments);

} // namespace alcove
