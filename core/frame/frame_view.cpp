#include "core/frame/frame_view.hpp"

#include <algorithm>

namespace alcove {

FrameView make_frame_view(const Walkthrough& walkthrough, int index, ImageSize size,
                          bool starts_segment) {
    ALCOVE_ASSERT(index >= 0 && static_cast<std::size_t>(index) < walkthrough.cameras.size(),
                  "a frame of the walkthrough");
    FrameView view;
    view.index = index;
    view.size = size;
    view.time_s = index * walkthrough.step_s;
    view.camera = walkthrough.cameras[static_cast<std::size_t>(index)];
    const bool is_cut = std::binary_search(walkthrough.cuts.begin(), walkthrough.cuts.end(), index);
    view.history_valid = index > 0 && !is_cut && !starts_segment;
    view.previous_time_s = view.history_valid ? (index - 1) * walkthrough.step_s : view.time_s;
    view.previous_camera =
        view.history_valid ? walkthrough.cameras[static_cast<std::size_t>(index - 1)] : view.camera;
    return view;
}

FrameView hold(const FrameView& view) {
    FrameView held = view;
    held.previous_camera = view.camera;
    held.previous_time_s = view.time_s;
    held.history_valid = true;
    return held;
}

} // namespace alcove
