#pragma once
// A scene's vertices with the visibility that was traced at each, and their way to the GPU.

#include "core/base/target.hpp"
#include "core/frame/posed_geometry.hpp"
#include "core/gl/handles.hpp"
#include "methods/common/ray_tracer.hpp"

#include <cstdint>
#include <vector>

namespace alcove {

/// Where the rays of each vertex start: on its largest triangle, `inset` of the way from the vertex
/// to the triangle's centre, so that one in a crease does not lie in the neighbour's plane; around
/// its shading normal. Relative to the geometry's origin, object after object; vertices without
/// triangles stay.
[[nodiscard]] std::vector<SurfacePoint> list_vertex_points(const PosedGeometry& geometry,
                                                           double inset);

class BakedGeometry {
  public:
    struct Place {
        GLsizei index_count = 0;
        std::size_t first_index = 0; ///< in bytes
        GLint base_vertex = 0;
    };

    /// `visibility`: one a vertex, in the order of list_vertex_points.
    BakedGeometry(const gl::Functions& gl, const PosedGeometry& geometry,
                  std::span<const float> visibility);

    /// Uploads the vertices of the objects that deform.
    void update(const PosedGeometry& geometry);
    void bind() const;
    /// One an object, in order.
    [[nodiscard]] const std::vector<Place>& places() const noexcept { return m_places; }

  private:
    const gl::Functions* m_gl;
    std::vector<Place> m_places;
    gl::BufferHandle m_positions;
    gl::BufferHandle m_visibility;
    gl::BufferHandle m_indices;
    gl::VertexArrayHandle m_vertex_array;
};

} // namespace alcove
