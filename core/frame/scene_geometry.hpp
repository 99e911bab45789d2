#pragma once
// A scene's triangles on the GPU. Meshes that carry the same streams share buffers, so that many
// are drawn by one call; objects that deform have buffers of their own, filled every frame.
// A vertex takes 16 bytes: a float position and an octahedral normal of 2 x 16 bits (Meyer et al.
// On floating-point normal vectors. 2010), within 4e-5 of the normal, exact along the axes.

#include "core/contract/scene.hpp"
#include "core/gl/handles.hpp"

#include <optional>
#include <vector>

namespace alcove {

/// What vertices carry beyond position and normal.
struct VertexStreams {
    bool has_colors = false;
    bool has_texture = false; ///< coordinates, for a mesh that names a texture
    bool deforms = false;     ///< the way of each vertex since the frame before
    friend auto operator<=>(const VertexStreams&, const VertexStreams&) = default;
};

/// Where the attributes of gbuffer.vert.glsl lie, and which buffer binding feeds them.
struct VertexLayout {
    static constexpr GLuint kVertexBinding = 0;
    static constexpr GLuint kColorBinding = 1;
    static constexpr GLuint kCoordinateBinding = 2;
    static constexpr GLuint kDeltaBinding = 3;
    static constexpr GLuint kPlacementBinding = 4;
    static constexpr GLuint kMotionBinding = 5;
};

/// Where a mesh lies in the buffers of its batch.
struct MeshPlace {
    std::size_t batch = 0;
    std::uint32_t first_index = 0;
    std::int32_t base_vertex = 0;
};

class SceneGeometry {
  public:
    /// Uploads all meshes; the scene must outlive this.
    SceneGeometry(const gl::Functions& gl, const Scene& scene);

    struct Batch {
        VertexStreams streams;
        gl::BufferHandle vertices;
        gl::BufferHandle colors;
        gl::BufferHandle coordinates;
        gl::BufferHandle deltas;
        gl::BufferHandle indices;
        gl::VertexArrayHandle vertex_array;
    };
    [[nodiscard]] const Batch& batch(std::size_t index) const { return m_batches[index]; }
    /// An object's triangles: its mesh's, or its own if it deforms.
    [[nodiscard]] const MeshPlace& place(std::size_t object) const;
    /// Replaces the vertices of a deforming object; the deltas are before - now.
    void update(std::size_t object, const Deformation& now, const Deformation& before);
    /// Connects a frame's instance data to every batch.
    void bind_instances(GLuint placements, GLsizei placement_stride, GLuint motions,
                        GLsizei motion_stride) const;

  private:
    Batch make_batch(VertexStreams streams, std::span<const std::size_t> meshes);

    const gl::Functions& m_gl;
    const Scene& m_scene;
    std::vector<Batch> m_batches;
    std::vector<MeshPlace> m_meshes;
    std::vector<std::optional<MeshPlace>> m_deforming; ///< one an object
};

} // namespace alcove
