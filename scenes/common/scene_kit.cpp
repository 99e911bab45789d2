#include "scenes/common/scene_kit.hpp"

#include "scenes/common/grid.hpp"

#include <string>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>

namespace alcove {

std::size_t SceneKit::add_mesh(Mesh mesh) {
    m_content.meshes.push_back(std::move(mesh));
    return m_content.meshes.size() - 1;
}

std::string SceneKit::place(std::size_t mesh, const glm::dmat4& transform) {
    const std::string name =
        m_content.meshes[mesh].name + "#" + std::to_string(m_content.objects.size());
    add_object(name, mesh, transform);
    return name;
}

void SceneKit::add(Mesh mesh, const glm::dmat4& transform) {
    std::string name = mesh.name;
    const std::size_t index = add_mesh(std::move(mesh));
    add_object(std::move(name), index, transform);
}

void SceneKit::add_object(std::string name, std::size_t mesh, const glm::dmat4& transform) {
    glm::dmat4 snapped = transform;
    snapped[3] = glm::dvec4(snap_to_grid(glm::dvec3(transform[3])), 1.0);
    m_content.objects.push_back({std::move(name), mesh});
    m_content.transforms.push_back(snapped);
}

RigidSceneContent SceneKit::take() {
    return std::move(m_content);
}

glm::dmat4 make_place(const glm::dvec3& position, double radians, const glm::dvec3& scale) {
    const glm::dmat4 moved = glm::translate(glm::dmat4(1.0), position);
    return glm::scale(glm::rotate(moved, radians, glm::dvec3(0.0, 1.0, 0.0)), scale);
}

} // namespace alcove
