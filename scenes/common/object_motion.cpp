#include "scenes/common/object_motion.hpp"

#include "core/base/assert.hpp"

#include <algorithm>
#include <numbers>

#include <glm/gtc/matrix_transform.hpp>

namespace alcove {
namespace {

struct Place {
    glm::dvec3 translation{0.0};
    double degrees = 0.0;
};

Place interpolate(const std::vector<TrackKey>& keys, double frame) {
    ALCOVE_ASSERT(!keys.empty(), "a track has a key");
    const auto after = std::find_if(keys.begin(), keys.end(),
                                    [frame](const TrackKey& key) { return key.frame > frame; });
    if (after == keys.begin()) {
        return {after->translation, after->degrees};
    }
    const TrackKey& a = *(after - 1);
    if (after == keys.end()) {
        return {a.translation, a.degrees};
    }
    // a + s (b - a): exactly a on its frame and between equal keys.
    const double s = (frame - a.frame) / (after->frame - a.frame);
    return {a.translation + s * (after->translation - a.translation),
            a.degrees + s * (after->degrees - a.degrees)};
}

} // namespace

glm::dmat4 compute_motion(const ObjectTrack& track, double frame) {
    const Place place = interpolate(track.keys, frame);
    const double radians = place.degrees * (std::numbers::pi / 180.0);
    glm::dmat4 motion = glm::rotate(glm::dmat4(1.0), radians, track.axis);
    const glm::dvec3 turned_pivot(motion * glm::dvec4(track.pivot, 0.0));
    motion[3] = glm::dvec4(place.translation + (track.pivot - turned_pivot), 1.0);
    return motion;
}

bool has_two_places(const ObjectTrack& track) {
    ALCOVE_ASSERT(!track.keys.empty(), "a track has a key");
    const TrackKey& first = track.keys.front();
    return std::any_of(track.keys.begin(), track.keys.end(), [&first](const TrackKey& key) {
        return key.translation != first.translation || key.degrees != first.degrees;
    });
}

} // namespace alcove
