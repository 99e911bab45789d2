#include "harness/run/effects_planner.hpp"

#include "core/frame/frame_view.hpp"

#include <optional>

namespace alcove {
namespace {

/// What was found out about frames that follow another one.
struct Count {
    std::size_t frames = 0;
    std::size_t moved = 0;
    std::optional<int> first;

    void add(int frame, bool moves) {
        ++frames;
        moved += moves ? 1 : 0;
        if (moves && !first) {
            first = frame;
        }
    }
};

bool is_same(const Camera& a, const Camera& b) {
    return a.position == b.position && a.world_from_view == b.world_from_view &&
           a.fov_y_radians == b.fov_y_radians && a.near_m == b.near_m && a.far_m == b.far_m;
}

std::string describe_count(const std::string& what, const Count& count) {
    if (count.frames == 0) {
        return "no frame is replayed behind another one";
    }
    const std::string all = std::to_string(count.frames);
    if (count.moved == 0) {
        return what + " on none of " + all + " frames that follow another";
    }
    return what + " on " + std::to_string(count.moved) + " of " + all +
           " frames that follow another, first on frame " + std::to_string(*count.first);
}

} // namespace

std::vector<EffectRecord> plan_effects(const Scene& scene,
                                       const std::vector<SegmentRecord>& segments,
                                       bool measures_pictures) {
    Count objects;
    Count camera;
    constexpr ImageSize kAnySize{1, 1};
    for (const SegmentRecord& segment : segments) {
        for (int frame = segment.begin; frame < segment.end; ++frame) {
            FrameView view =
                make_frame_view(scene.get_walkthrough(), frame, kAnySize, frame == segment.begin);
            if (!view.history_valid) {
                continue;
            }
            detect_motion(scene, view);
            objects.add(frame, view.objects_may_move);
            camera.add(frame, !is_same(view.camera, view.previous_camera));
        }
    }
    const std::string objects_text = describe_count("objects move", objects);
    const std::string camera_text = describe_count("the camera moves", camera);
    std::vector<EffectRecord> decisions;
    for (const EffectInfo& info : kEffects) {
        EffectRecord decision{std::string(info.name), true, {}};
        switch (info.effect) {
        case Effect::object_motion:
            decision.is_needed = objects.moved > 0;
            decision.evidence = objects_text;
            break;
        case Effect::reprojection:
            decision.is_needed = objects.moved > 0 || camera.moved > 0;
            decision.evidence = objects.moved > 0 ? objects_text : camera_text;
            break;
        case Effect::light_buffers:
            decision.is_needed = measures_pictures;
            decision.evidence =
                measures_pictures ? "the target is radiance" : "the target is visibility";
            break;
        }
        decisions.push_back(std::move(decision));
    }
    return decisions;
}

EffectSet choose_effects(const std::vector<EffectRecord>& decisions) {
    EffectSet effects = EffectSet::all();
    for (const EffectRecord& decision : decisions) {
        for (const EffectInfo& info : kEffects) {
            if (info.name == decision.effect && !decision.is_needed) {
                effects.remove(info.effect);
            }
        }
    }
    return effects;
}

} // namespace alcove
