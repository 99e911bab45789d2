#include "scenes/common/static_scene.hpp"

#include "core/base/assert.hpp"

#include <utility>

namespace alcove {

StaticScene::StaticScene(StaticSceneContent content) : m_content(std::move(content)) {
    ALCOVE_ASSERT(m_content.transforms.size() == m_content.objects.size(),
                  "one transform an object");
    for (const Object& object : m_content.objects) {
        ALCOVE_ASSERT(object.mesh < m_content.meshes.size(), "an object of a mesh that exists");
    }
    for (glm::dmat4& transform : m_content.transforms) {
        transform[3] += glm::dvec4(m_content.origin, 0.0);
    }
    for (Camera& camera : m_content.walkthrough.cameras) {
        camera.position += m_content.origin;
    }
    std::vector<int>& cuts = m_content.walkthrough.cuts;
    if (cuts.empty() || cuts.front() != 0) {
        cuts.insert(cuts.begin(), 0);
    }
}

Pose StaticScene::compute_pose(double /*time_s*/) const {
    return Pose{m_content.transforms};
}

} // namespace alcove
