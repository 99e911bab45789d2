#include "scenes/common/rigid_scene.hpp"

#include "core/base/assert.hpp"
#include "scenes/common/clusters.hpp"

#include <utility>

#include <glm/gtx/rotate_vector.hpp>
#include <glm/trigonometric.hpp>

namespace alcove {

RigidScene::RigidScene(RigidSceneContent content)
    : m_content(std::move(content)), m_tracks(m_content.walkthrough, m_content.objects) {
    ALCOVE_ASSERT(m_content.transforms.size() == m_content.objects.size(),
                  "one transform an object");
    for (std::size_t i = 0; i < m_content.objects.size(); ++i) {
        Object& object = m_content.objects[i];
        ALCOVE_ASSERT(object.mesh < m_content.meshes.size(), "an object of a mesh that exists");
        object.motion = m_tracks.moves(i) ? ObjectMotion::rigid : ObjectMotion::still;
    }
    for (Mesh& mesh : m_content.meshes) {
        build_clusters(mesh);
    }
    place_walkthrough(m_content.walkthrough, m_content.origin);
}

Lights RigidScene::compute_lights(double time_s) const {
    Lights lights = m_content.lights;
    if (m_content.light_degrees_per_s != 0.0) {
        const double angle = glm::radians(m_content.light_degrees_per_s * time_s);
        for (DirectionalLight& light : lights.directional) {
            light.to_light = glm::rotateY(light.to_light, angle);
        }
    }
    return lights;
}

Pose RigidScene::compute_pose(double time_s) const {
    Pose pose{m_content.transforms};
    m_tracks.apply(m_content.walkthrough, time_s, pose.object_to_world);
    if (m_content.origin != glm::dvec3(0.0)) {
        for (glm::dmat4& transform : pose.object_to_world) {
            transform[3] += glm::dvec4(m_content.origin, 0.0);
        }
    }
    return pose;
}

} // namespace alcove
