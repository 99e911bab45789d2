#pragma once
// What is drawn in one pass over the scene, as instance data and indirect commands. Objects of one
// mesh stay instances. The order (back faces, mesh, object, triangles) does not depend on what
// culling left out, so that surfaces at equal depth are decided alike.

#include "core/frame/scene_culler.hpp"
#include "core/frame/scene_geometry.hpp"

#include <functional>

namespace alcove {

/// The parameters of glMultiDrawElementsIndirect.
struct DrawCommand {
    GLuint index_count;
    GLuint instance_count;
    GLuint first_index;
    GLint base_vertex;
    GLuint base_instance;
};

/// Commands that share all state.
struct DrawGroup {
    std::size_t batch = 0;
    bool culls_back_faces = false;
    std::optional<std::size_t> texture;
    glm::mat3 previous_world_from_object{1.0f}; ///< of an object that deforms
    std::size_t first_command = 0;
    std::size_t command_count = 0;
};

/// Which faces are rasterised: those of each group's rule, all, or those seen from behind.
enum class FaceRule { as_listed, both, back };

class DrawList {
  public:
    explicit DrawList(const gl::Functions& gl) : m_gl(gl) {}

    /// Takes those objects of `visible` that `includes(object)` lets in, seen by `camera`.
    void build(const Scene& scene, SceneGeometry& geometry, const VisibleSet& visible,
               const FramePose& pose, const Camera& camera,
               const std::function<bool(std::uint32_t object)>& includes);
    [[nodiscard]] bool empty() const noexcept { return m_groups.empty(); }
    /// Calls `prepare(group)` and draws, group by group.
    void draw(const SceneGeometry& geometry, FaceRule faces,
              const std::function<void(const DrawGroup&)>& prepare) const;

  private:
    /// Buffers that grow to a frame's need.
    struct Stream {
        gl::BufferHandle buffer;
        std::size_t capacity = 0;
    };
    void upload(Stream& stream, std::span<const std::byte> bytes);

    const gl::Functions& m_gl;
    std::vector<DrawGroup> m_groups;
    Stream m_placements;
    Stream m_motions;
    Stream m_commands;
};

} // namespace alcove
