#pragma once
// One step of a walkthrough, as everything that renders it sees it.

#include "core/contract/scene.hpp"

namespace alcove {

/// State comes from the index alone, never from a clock.
struct FrameView {
    int index = 0;
    double time_s = 0.0;
    double previous_time_s = 0.0;
    Camera camera;
    Camera previous_camera;
    bool history_valid = false; ///< false on frame 0, after a cut and on a segment's first frame
    ImageSize size;
    /// False only where every object stands as it stood one frame ago; true where that is not
    /// known.
    bool objects_may_move = true;
};

/// Frame `index` of the walkthrough. Where the history is invalid (frame 0, a cut,
/// `starts_segment`) previous = current. Asserts that the frame exists.
[[nodiscard]] FrameView make_frame_view(const Walkthrough& walkthrough, int index, ImageSize size,
                                        bool starts_segment);

/// Finds out objects_may_move by comparing the scene's two poses.
void detect_motion(const Scene& scene, FrameView& view);

/// Do both show the same moment through the same cameras, at the same size?
[[nodiscard]] bool shows_same(const FrameView& a, const FrameView& b);

/// Pixels added on each side.
struct Border {
    int x = 0;
    int y = 0;
    friend auto operator<=>(const Border&, const Border&) = default;
};

/// `fraction` of width and height on each side, rounded up. Asserts [0, 0.5].
[[nodiscard]] Border make_border(ImageSize size, double fraction);

/// The same frame on an image that is larger on each side: both cameras see more, and the pixels
/// inside the border are those of the view without it.
[[nodiscard]] FrameView extend(const FrameView& view, const Border& border);

/// The same frame held: previous = current, history valid. For converged replays.
[[nodiscard]] FrameView hold(const FrameView& view);

} // namespace alcove
