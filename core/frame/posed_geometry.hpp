#pragma once
// Geometry for methods that trace: float, relative to a double origin that stays fixed over a
// walkthrough, with object transforms apart, so that the tree over a static scene is built once.
// Tracers subtract the origin from the camera in double.

#include "core/contract/scene.hpp"

#include <optional>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>

namespace alcove {

struct PosedObject {
    const Mesh* mesh = nullptr;
    ObjectMotion motion = ObjectMotion::rigid;
    std::optional<Deformation> deformation; ///< replaces the mesh's vertices if it deforms
    glm::mat4 origin_from_object{1.0f};     ///< composed in double, then rounded
    std::uint32_t instance_id = 0;          ///< as in the G-buffer: index of the object + 1

    [[nodiscard]] std::span<const glm::vec3> positions() const {
        return deformation ? deformation->positions : mesh->positions;
    }
    [[nodiscard]] std::span<const glm::vec3> normals() const {
        return deformation ? deformation->normals : mesh->normals;
    }
};

struct PosedGeometry {
    const Scene* scene =
        nullptr; ///< identity of the geometry: equal scene and is_static = same tree
    double time_s = 0.0;
    bool is_static = true;
    glm::dvec3 origin{0.0};
    std::vector<PosedObject> objects;
};

[[nodiscard]] PosedGeometry pose_geometry(const Scene& scene, double time_s);

} // namespace alcove
