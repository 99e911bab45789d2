#include "scenes/common/walkthrough_tracks.hpp"

#include <algorithm>
#include <string>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

std::vector<TrackKey> read_keys(const JsonPlace& place, std::int64_t frames) {
    std::vector<TrackKey> keys;
    for (std::size_t i = 0; i < place.count(); ++i) {
        const JsonPlace key = place.at(i);
        key.check_keys({"frame", "translation", "degrees"});
        const auto frame = static_cast<int>(key.get("frame").read_integer(0, frames - 1));
        if (!keys.empty() && frame <= keys.back().frame) {
            key.get("frame").fail("does not ascend",
                                  "more than " + std::to_string(keys.back().frame));
        }
        keys.push_back(
            {frame, key.get("translation").read_vector(), key.get("degrees").read_number()});
    }
    if (keys.empty()) {
        place.fail("has no keys", "at least one");
    }
    return keys;
}

ObjectTrack read_track(const JsonPlace& place, std::int64_t frames) {
    place.check_keys({"object", "pivot", "axis", "keys"});
    ObjectTrack track;
    track.object = place.get("object").read_text();
    track.pivot = place.get("pivot").read_vector();
    const glm::dvec3 axis = place.get("axis").read_vector();
    if (!(glm::length(axis) > 1e-6)) {
        place.get("axis").fail("has no direction", "a vector of some length");
    }
    track.axis = glm::normalize(axis);
    track.keys = read_keys(place.get("keys"), frames);
    return track;
}

} // namespace

std::vector<ObjectTrack> read_walkthrough_tracks(const JsonPlace& place, std::int64_t frames) {
    std::vector<ObjectTrack> tracks;
    for (std::size_t i = 0; i < place.count(); ++i) {
        ObjectTrack track = read_track(place.at(i), frames);
        if (std::any_of(tracks.begin(), tracks.end(), [&track](const ObjectTrack& other) {
                return other.object == track.object;
            })) {
            place.at(i).get("object").fail("has a track already", "one track an object");
        }
        tracks.push_back(std::move(track));
    }
    return tracks;
}

} // namespace alcove
