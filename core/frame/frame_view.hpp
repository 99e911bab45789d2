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
};

/// Frame `index` of the walkthrough. Where the history is invalid (frame 0, a cut,
/// `starts_segment`) previous = current. Asserts that the frame exists.
[[nodiscard]] FrameView make_frame_view(const Walkthrough& walkthrough, int index, ImageSize size,
                                        bool starts_segment);

/// The same frame held: previous = current, history valid. For converged replays.
[[nodiscard]] FrameView hold(const FrameView& view);

} // namespace alcove
