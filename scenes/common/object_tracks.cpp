#include "scenes/common/object_tracks.hpp"

#include "scenes/common/object_motion.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

namespace alcove {

ObjectTracks::ObjectTracks(const Walkthrough& walkthrough, std::span<const Object> objects) {
    std::map<std::string_view, std::size_t> tracks;
    for (std::size_t i = 0; i < walkthrough.tracks.size(); ++i) {
        tracks.emplace(walkthrough.tracks[i].object, i);
    }
    for (std::size_t i = 0; i < objects.size(); ++i) {
        const auto track = tracks.find(objects[i].name);
        m_moves.push_back(false);
        if (track != tracks.end()) {
            m_tracked.push_back({i, track->second});
            m_moves.back() = has_two_places(walkthrough.tracks[track->second]);
        }
    }
}

bool ObjectTracks::move_any() const {
    return std::find(m_moves.begin(), m_moves.end(), true) != m_moves.end();
}

void ObjectTracks::apply(const Walkthrough& walkthrough, double time_s,
                         std::span<glm::dmat4> object_to_scene) const {
    constexpr double kSnap = 1e-9;
    double frame = time_s / walkthrough.step_s;
    if (std::abs(frame - std::round(frame)) < kSnap) {
        frame = std::round(frame);
    }
    for (const Tracked& tracked : m_tracked) {
        glm::dmat4& transform = object_to_scene[tracked.object];
        transform = compute_motion(walkthrough.tracks[tracked.track], frame) * transform;
    }
}

void place_walkthrough(Walkthrough& walkthrough, const glm::dvec3& origin) {
    for (Camera& camera : walkthrough.cameras) {
        camera.position += origin;
    }
    if (walkthrough.cuts.empty() || walkthrough.cuts.front() != 0) {
        walkthrough.cuts.insert(walkthrough.cuts.begin(), 0);
    }
}

} // namespace alcove
