#include "scenes/common/animated_scene.hpp"

#include "core/base/assert.hpp"
#include "scenes/common/clusters.hpp"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

void check_object(const AnimatedSceneContent& content, const AnimatedObject& object) {
    ALCOVE_ASSERT(object.object.mesh < content.meshes.size(), "an object of a mesh that exists");
    if (object.procedure) {
        ALCOVE_ASSERT(!object.skin && !object.is_morphed &&
                          object.object.motion == ObjectMotion::deforming,
                      "one way to deform");
        return;
    }
    if (!object.skin && !object.is_morphed) {
        ALCOVE_ASSERT(object.object.motion != ObjectMotion::deforming, "only deformers deform");
        return;
    }
    ALCOVE_ASSERT(object.object.motion == ObjectMotion::deforming, "deformers deform");
    const MeshDeformers& deformers = content.deformers[object.object.mesh];
    ALCOVE_ASSERT(!object.is_morphed || content.weights, "weights of morph targets");
    if (object.skin) {
        ALCOVE_ASSERT(*object.skin < content.skins.size(), "a skin that exists");
        const std::size_t joints = content.skins[*object.skin].joints.size();
        ALCOVE_ASSERT(deformers.influences &&
                          std::all_of(deformers.influences->joints.begin(),
                                      deformers.influences->joints.end(),
                                      [joints](std::uint16_t joint) { return joint < joints; }),
                      "influences of joints of the skin");
    }
}

/// A node that is scaled to nothing for a moment leaves a light's direction as it was.
void turn(glm::dvec3& direction, const glm::dvec3& to) {
    if (glm::length(to) > 0.0) {
        direction = glm::normalize(to);
    }
}

} // namespace

Deformation deform_object(const AnimatedSceneContent& content, std::size_t index,
                          const std::vector<glm::dmat4>& nodes, double time_s) {
    const AnimatedObject& object = content.objects[index];
    if (object.procedure) {
        return object.procedure(time_s);
    }
    ALCOVE_ASSERT(object.skin || object.is_morphed, "an object that deforms");
    const Mesh& mesh = content.meshes[object.object.mesh];
    const MeshDeformers& deformers = content.deformers[object.object.mesh];
    Deformation result;
    if (object.is_morphed) {
        result = morph_vertices(mesh, deformers.targets, content.weights(index, time_s));
    }
    if (object.skin) {
        const Skin& skin = content.skins[*object.skin];
        std::vector<glm::dmat4> matrices;
        for (std::size_t i = 0; i < skin.joints.size(); ++i) {
            matrices.push_back(nodes.at(skin.joints[i]) * skin.inverse_bind[i]);
        }
        result =
            object.is_morphed
                ? skin_vertices(result.positions, result.normals, *deformers.influences, matrices)
                : skin_vertices(mesh.positions, mesh.normals, *deformers.influences, matrices);
    }
    if (deformers.is_flat) {
        // Skinned vertices are in the world already, where their triangles are counter-clockwise.
        make_flat_normals(mesh.indices, deformers.is_turned && !object.skin, result);
    }
    return result;
}

AnimatedScene::AnimatedScene(AnimatedSceneContent content) : m_content(std::move(content)) {
    m_content.deformers.resize(m_content.meshes.size());
    for (const Skin& skin : m_content.skins) {
        ALCOVE_ASSERT(skin.joints.size() == skin.inverse_bind.size(), "a matrix a joint");
    }
    for (const AnimatedObject& object : m_content.objects) {
        check_object(m_content, object);
        m_objects.push_back(object.object);
    }
    m_tracks = ObjectTracks(m_content.walkthrough, m_objects);
    for (std::size_t i = 0; i < m_objects.size(); ++i) {
        if (m_objects[i].motion == ObjectMotion::still && m_tracks.moves(i)) {
            m_objects[i].motion = ObjectMotion::rigid;
        }
        m_is_static = m_is_static && m_objects[i].motion == ObjectMotion::still;
    }
    m_is_static = m_is_static || (m_content.is_at_rest && !m_tracks.move_any());
    // Boxes and cones of a mesh at rest say nothing of where it is moved to.
    std::vector<bool> deforms(m_content.meshes.size(), false);
    for (const Object& object : m_objects) {
        deforms[object.mesh] = deforms[object.mesh] || object.motion == ObjectMotion::deforming;
    }
    for (std::size_t i = 0; i < m_content.meshes.size(); ++i) {
        if (!deforms[i]) {
            build_clusters(m_content.meshes[i]);
        }
    }
    ALCOVE_ASSERT(m_content.directional_nodes.size() <= m_content.lights.directional.size() &&
                      m_content.point_nodes.size() <= m_content.lights.points.size(),
                  "nodes of lights that exist");
    place_walkthrough(m_content.walkthrough, m_content.origin);
}

AnimatedScene::Nodes AnimatedScene::find_nodes(double time_s) const {
    const std::lock_guard lock(m_mutex);
    if (!m_known[0].nodes || m_known[0].time_s != time_s) {
        std::swap(m_known[0], m_known[1]);
    }
    if (!m_known[0].nodes || m_known[0].time_s != time_s) {
        m_known[0] = {time_s,
                      std::make_shared<const std::vector<glm::dmat4>>(m_content.nodes(time_s))};
    }
    return m_known[0].nodes;
}

Pose AnimatedScene::compute_pose(double time_s) const {
    const Nodes nodes = find_nodes(time_s);
    Pose pose;
    for (const AnimatedObject& object : m_content.objects) {
        pose.object_to_world.push_back(object.skin ? glm::dmat4(1.0) : nodes->at(object.node));
    }
    m_tracks.apply(m_content.walkthrough, time_s, pose.object_to_world);
    for (glm::dmat4& transform : pose.object_to_world) {
        transform[3] += glm::dvec4(m_content.origin, 0.0);
    }
    return pose;
}

Lights AnimatedScene::compute_lights(double time_s) const {
    Lights lights = m_content.lights;
    const Nodes nodes = find_nodes(time_s);
    for (std::size_t i = 0; i < m_content.directional_nodes.size(); ++i) {
        if (const auto node = m_content.directional_nodes[i]) {
            turn(lights.directional[i].to_light, glm::dvec3(nodes->at(*node)[2]));
        }
    }
    for (std::size_t i = 0; i < m_content.point_nodes.size(); ++i) {
        if (const auto node = m_content.point_nodes[i]) {
            PointLight& light = lights.points[i];
            light.position = glm::dvec3(nodes->at(*node)[3]) + m_content.origin;
            if (light.cone) {
                turn(light.cone->direction, -glm::dvec3(nodes->at(*node)[2]));
            }
        }
    }
    return lights;
}

Deformation AnimatedScene::deform(std::size_t object, double time_s) const {
    return deform_object(m_content, object, *find_nodes(time_s), time_s);
}

} // namespace alcove
