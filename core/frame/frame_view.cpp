#include "core/frame/frame_view.hpp"

#include <algorithm>
#include <cmath>

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

void detect_motion(const Scene& scene, FrameView& view) {
    view.objects_may_move = false;
    if (view.time_s == view.previous_time_s || scene.is_static()) {
        return;
    }
    const std::span<const Object> objects = scene.get_objects();
    const bool deforms = std::any_of(objects.begin(), objects.end(), [](const Object& object) {
        return object.motion == ObjectMotion::deforming;
    });
    view.objects_may_move = deforms || scene.compute_pose(view.time_s).object_to_world !=
                                           scene.compute_pose(view.previous_time_s).object_to_world;
}

bool shows_same(const FrameView& a, const FrameView& b) {
    const auto is_same_camera = [](const Camera& x, const Camera& y) {
        return x.position == y.position && x.world_from_view == y.world_from_view &&
               x.fov_y_radians == y.fov_y_radians && x.near_m == y.near_m && x.far_m == y.far_m;
    };
    return a.time_s == b.time_s && a.previous_time_s == b.previous_time_s && a.size == b.size &&
           is_same_camera(a.camera, b.camera) &&
           is_same_camera(a.previous_camera, b.previous_camera);
}

Border make_border(ImageSize size, double fraction) {
    ALCOVE_ASSERT(fraction >= 0.0 && fraction <= 0.5, "a border of at most half the image");
    return {static_cast<int>(std::ceil(fraction * size.width)),
            static_cast<int>(std::ceil(fraction * size.height))};
}

FrameView extend(const FrameView& view, const Border& border) {
    FrameView extended = view;
    extended.size = {view.size.width + 2 * border.x, view.size.height + 2 * border.y};
    // The horizontal tangent follows from the vertical one and the ratio of the sides, which gives
    // exactly (W + 2 b_x) / W of the old one.
    const double grown = static_cast<double>(extended.size.height) / view.size.height;
    for (Camera* camera : {&extended.camera, &extended.previous_camera}) {
        camera->fov_y_radians = 2.0 * std::atan(grown * std::tan(0.5 * camera->fov_y_radians));
    }
    return extended;
}

FrameView hold(const FrameView& view) {
    FrameView held = view;
    held.previous_camera = view.camera;
    held.previous_time_s = view.time_s;
    held.history_valid = true;
    held.objects_may_move = false;
    return held;
}

} // namespace alcove
