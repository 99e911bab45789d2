#include "scenes/common/rigid_scene.hpp"

#include "core/base/assert.hpp"
#include "scenes/common/clusters.hpp"
#include "scenes/common/object_motion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace alcove {

RigidScene::RigidScene(RigidSceneContent content) : m_content(std::move(content)) {
    ALCOVE_ASSERT(m_content.transforms.size() == m_content.objects.size(),
                  "one transform an object");
    const std::vector<ObjectTrack>& tracks = m_content.walkthrough.tracks;
    for (Object& object : m_content.objects) {
        ALCOVE_ASSERT(object.mesh < m_content.meshes.size(), "an object of a mesh that exists");
        const auto track =
            std::find_if(tracks.begin(), tracks.end(),
                         [&object](const ObjectTrack& t) { return t.object == object.name; });
        m_tracks.emplace_back();
        if (track != tracks.end()) {
            m_tracks.back() = static_cast<std::size_t>(track - tracks.begin());
        }
        const bool moves = track != tracks.end() && has_two_places(*track);
        object.motion = moves ? ObjectMotion::rigid : ObjectMotion::still;
    }
    for (Mesh& mesh : m_content.meshes) {
        build_clusters(mesh);
    }
    m_is_static = std::none_of(tracks.begin(), tracks.end(), has_two_places);
    for (Camera& camera : m_content.walkthrough.cameras) {
        camera.position += m_content.origin;
    }
    std::vector<int>& cuts = m_content.walkthrough.cuts;
    if (cuts.empty() || cuts.front() != 0) {
        cuts.insert(cuts.begin(), 0);
    }
}

Pose RigidScene::compute_pose(double time_s) const {
    constexpr double kSnap = 1e-9;
    double frame = time_s / m_content.walkthrough.step_s;
    if (std::abs(frame - std::round(frame)) < kSnap) {
        frame = std::round(frame);
    }
    Pose pose{m_content.transforms};
    for (std::size_t i = 0; i < pose.object_to_world.size(); ++i) {
        glm::dmat4& transform = pose.object_to_world[i];
        if (m_tracks[i]) {
            transform =
                compute_motion(m_content.walkthrough.tracks[*m_tracks[i]], frame) * transform;
        }
        transform[3] += glm::dvec4(m_content.origin, 0.0);
    }
    return pose;
}

} // namespace alcove
