#include "scenes/common/walkthrough_writer.hpp"

#include "scenes/common/walkthrough_file.hpp"

#include <algorithm>
#include <numbers>

#include <nlohmann/json.hpp>

namespace alcove {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

Json write_pose(const Camera& camera) {
    return {{"position", to_json(camera.position)},
            {"target", to_json(camera.position - camera.world_from_view[2])},
            {"up", to_json(camera.world_from_view[1])},
            {"fov_y_degrees", camera.fov_y_radians * (180.0 / std::numbers::pi)}};
}

Json write_track(const ObjectTrack& track) {
    Json keys = Json::array();
    for (const TrackKey& key : track.keys) {
        keys.push_back({{"frame", key.frame},
                        {"translation", to_json(key.translation)},
                        {"degrees", key.degrees}});
    }
    return {{"object", track.object},
            {"pivot", to_json(track.pivot)},
            {"axis", to_json(track.axis)},
            {"keys", std::move(keys)}};
}

} // namespace

std::string write_walkthrough(const Walkthrough& walkthrough) {
    Json poses = Json::array();
    double near_m = walkthrough.cameras.front().near_m;
    double far_m = walkthrough.cameras.front().far_m;
    for (const Camera& camera : walkthrough.cameras) {
        poses.push_back(write_pose(camera));
        near_m = std::min(near_m, camera.near_m);
        far_m = std::max(far_m, camera.far_m);
    }
    Json cuts = Json::array();
    for (const int cut : walkthrough.cuts) {
        if (cut != 0) { // always is one
            cuts.push_back(cut);
        }
    }
    Json events = Json::array();
    for (const WalkthroughEvent& event : walkthrough.events) {
        events.push_back({{"frame", event.frame}, {"label", event.label}});
    }
    Json tracks = Json::array();
    for (const ObjectTrack& track : walkthrough.tracks) {
        tracks.push_back(write_track(track));
    }
    const Json root{{"version", kWalkthroughVersion},
                    {"name", walkthrough.name},
                    {"step_seconds", walkthrough.step_s},
                    {"frames", walkthrough.cameras.size()},
                    {"near", near_m},
                    {"far", far_m},
                    {"cuts", std::move(cuts)},
                    {"poses", std::move(poses)},
                    {"events", std::move(events)},
                    {"tracks", std::move(tracks)}};
    return root.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace alcove
