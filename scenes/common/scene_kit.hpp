#pragma once
// A rigid scene while it is being built: its meshes, and where they are placed.

#include "scenes/common/rigid_scene.hpp"

#include <cstddef>
#include <string>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace alcove {

class SceneKit {
  public:
    /// Returns its index, for `place`.
    std::size_t add_mesh(Mesh mesh);
    /// An object with the name of its mesh and, behind a #, its own number. Positions snap
    /// to the grid of 2^-20 m (grid.hpp). Returns its name, for tracks.
    std::string place(std::size_t mesh, const glm::dmat4& transform);
    /// A mesh with one object that has its name, so that a track can move it.
    void add(Mesh mesh, const glm::dmat4& transform = glm::dmat4(1.0));

    /// Meshes, objects and transforms; lights, walkthrough and radius are left to the scene.
    [[nodiscard]] RigidSceneContent take();

  private:
    void add_object(std::string name, std::size_t mesh, const glm::dmat4& transform);

    RigidSceneContent m_content;
};

/// Scaled along its own axes, turned about +y (from z towards x), then moved.
[[nodiscard]] glm::dmat4 make_place(const glm::dvec3& position, double radians = 0.0,
                                    const glm::dvec3& scale = glm::dvec3(1.0));

} // namespace alcove
