#include "core/frame/scene_geometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

struct PackedVertex {
    glm::vec3 position;
    std::array<std::int16_t, 2> normal;
};
static_assert(sizeof(PackedVertex) == 16);

std::int16_t to_snorm(float value) {
    return static_cast<std::int16_t>(std::lround(std::clamp(value, -1.0f, 1.0f) * 32767.0f));
}

/// The octahedron |x| + |y| + |z| = 1 unfolded onto a square, the lower half turned outwards.
std::array<std::int16_t, 2> pack_normal(const glm::vec3& n) {
    const float sum = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
    float x = n.x / sum;
    float y = n.y / sum;
    if (n.z < 0.0f) {
        const float folded = (1.0f - std::abs(y)) * std::copysign(1.0f, x);
        y = (1.0f - std::abs(x)) * std::copysign(1.0f, y);
        x = folded;
    }
    return {to_snorm(x), to_snorm(y)};
}

void pack(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
          std::vector<PackedVertex>& packed) {
    for (std::size_t i = 0; i < positions.size(); ++i) {
        packed.push_back({positions[i], pack_normal(normals[i])});
    }
}

/// One float or snorm attribute of a vertex array.
void set_attribute(const gl::Functions& gl, GLuint vertex_array, GLuint attribute, GLuint binding,
                   GLint components, GLenum type, std::size_t offset) {
    gl.EnableVertexArrayAttrib(vertex_array, attribute);
    gl.VertexArrayAttribFormat(vertex_array, attribute, components, type,
                               type == GL_FLOAT ? GL_FALSE : GL_TRUE, static_cast<GLuint>(offset));
    gl.VertexArrayAttribBinding(vertex_array, attribute, binding);
}

constexpr GLsizei kVector3Stride = sizeof(glm::vec3);

} // namespace

SceneGeometry::SceneGeometry(const gl::Functions& gl, const Scene& scene)
    : m_gl(gl), m_scene(scene), m_meshes(scene.get_meshes().size()),
      m_deforming(scene.get_objects().size()) {
    std::vector<bool> is_drawn(scene.get_meshes().size(), false);
    for (const Object& object : scene.get_objects()) {
        is_drawn[object.mesh] = is_drawn[object.mesh] || object.motion != ObjectMotion::deforming;
    }
    std::map<VertexStreams, std::vector<std::size_t>> sorted;
    for (std::size_t i = 0; i < scene.get_meshes().size(); ++i) {
        const Mesh& mesh = scene.get_meshes()[i];
        if (is_drawn[i]) {
            sorted[{!mesh.colors.empty(), mesh.texture.has_value(), false}].push_back(i);
        }
    }
    for (const auto& [streams, meshes] : sorted) {
        std::uint32_t first_index = 0;
        std::int32_t base_vertex = 0;
        for (const std::size_t mesh : meshes) {
            m_meshes[mesh] = {m_batches.size(), first_index, base_vertex};
            first_index += static_cast<std::uint32_t>(scene.get_meshes()[mesh].indices.size());
            base_vertex += static_cast<std::int32_t>(scene.get_meshes()[mesh].positions.size());
        }
        m_batches.push_back(make_batch(streams, meshes));
    }
    for (std::size_t i = 0; i < scene.get_objects().size(); ++i) {
        const Object& object = scene.get_objects()[i];
        if (object.motion == ObjectMotion::deforming) {
            const Mesh& mesh = scene.get_meshes()[object.mesh];
            m_deforming[i] = MeshPlace{m_batches.size(), 0, 0};
            m_batches.push_back(make_batch({!mesh.colors.empty(), mesh.texture.has_value(), true},
                                           {&object.mesh, 1}));
        }
    }
}

SceneGeometry::Batch SceneGeometry::make_batch(VertexStreams streams,
                                               std::span<const std::size_t> meshes) {
    std::vector<PackedVertex> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<glm::vec3> colors;
    std::vector<glm::vec2> coordinates;
    for (const std::size_t i : meshes) {
        const Mesh& mesh = m_scene.get_meshes()[i];
        pack(mesh.positions, mesh.normals, vertices);
        indices.insert(indices.end(), mesh.indices.begin(), mesh.indices.end());
        if (streams.has_colors) {
            colors.insert(colors.end(), mesh.colors.begin(), mesh.colors.end());
        }
        if (streams.has_texture) {
            coordinates.insert(coordinates.end(), mesh.texture_coordinates.begin(),
                               mesh.texture_coordinates.end());
        }
    }
    using L = VertexLayout;
    Batch batch;
    batch.streams = streams;
    const GLbitfield flags = streams.deforms ? GL_DYNAMIC_STORAGE_BIT : 0;
    batch.vertices = gl::create_buffer(m_gl, std::as_bytes(std::span(vertices)), flags);
    batch.indices = gl::create_buffer(m_gl, std::as_bytes(std::span(indices)));
    GLuint name = 0;
    m_gl.CreateVertexArrays(1, &name);
    batch.vertex_array = gl::VertexArrayHandle(m_gl, name);
    m_gl.VertexArrayElementBuffer(name, batch.indices.get());
    m_gl.VertexArrayVertexBuffer(name, L::kVertexBinding, batch.vertices.get(), 0,
                                 sizeof(PackedVertex));
    set_attribute(m_gl, name, 0, L::kVertexBinding, 3, GL_FLOAT, 0);
    set_attribute(m_gl, name, 1, L::kVertexBinding, 2, GL_SHORT, sizeof(glm::vec3));
    if (streams.has_colors) {
        batch.colors = gl::create_buffer(m_gl, std::as_bytes(std::span(colors)));
        m_gl.VertexArrayVertexBuffer(name, L::kColorBinding, batch.colors.get(), 0, kVector3Stride);
        set_attribute(m_gl, name, 2, L::kColorBinding, 3, GL_FLOAT, 0);
    }
    if (streams.has_texture) {
        batch.coordinates = gl::create_buffer(m_gl, std::as_bytes(std::span(coordinates)));
        m_gl.VertexArrayVertexBuffer(name, L::kCoordinateBinding, batch.coordinates.get(), 0,
                                     sizeof(glm::vec2));
        set_attribute(m_gl, name, 3, L::kCoordinateBinding, 2, GL_FLOAT, 0);
    }
    if (streams.deforms) {
        const std::vector<glm::vec3> none(vertices.size(), glm::vec3(0.0f));
        batch.deltas = gl::create_buffer(m_gl, std::as_bytes(std::span(none)), flags);
        m_gl.VertexArrayVertexBuffer(name, L::kDeltaBinding, batch.deltas.get(), 0, kVector3Stride);
        set_attribute(m_gl, name, 4, L::kDeltaBinding, 3, GL_FLOAT, 0);
    }
    // Three rows of a matrix each, then albedo and instance id: draw_list.hpp.
    for (GLuint row = 0; row < 3; ++row) {
        set_attribute(m_gl, name, 5 + row, L::kPlacementBinding, 4, GL_FLOAT,
                      row * sizeof(glm::vec4));
        set_attribute(m_gl, name, 8 + row, L::kMotionBinding, 4, GL_FLOAT, row * sizeof(glm::vec4));
    }
    set_attribute(m_gl, name, 11, L::kPlacementBinding, 3, GL_FLOAT, 3 * sizeof(glm::vec4));
    m_gl.EnableVertexArrayAttrib(name, 12);
    m_gl.VertexArrayAttribIFormat(name, 12, 1, GL_UNSIGNED_INT,
                                  3 * sizeof(glm::vec4) + sizeof(glm::vec3));
    m_gl.VertexArrayAttribBinding(name, 12, L::kPlacementBinding);
    m_gl.VertexArrayBindingDivisor(name, L::kPlacementBinding, 1);
    m_gl.VertexArrayBindingDivisor(name, L::kMotionBinding, 1);
    return batch;
}

const MeshPlace& SceneGeometry::place(std::size_t object) const {
    return m_deforming[object] ? *m_deforming[object]
                               : m_meshes[m_scene.get_objects()[object].mesh];
}

void SceneGeometry::update(std::size_t object, const Deformation& now, const Deformation& before) {
    ALCOVE_ASSERT(m_deforming[object].has_value(), "an object that deforms");
    const Mesh& mesh = m_scene.get_meshes()[m_scene.get_objects()[object].mesh];
    ALCOVE_ASSERT(now.positions.size() == mesh.positions.size() &&
                      before.positions.size() == mesh.positions.size() &&
                      now.normals.size() == mesh.positions.size(),
                  "a deformation keeps the number of vertices");
    const Batch& batch = m_batches[m_deforming[object]->batch];
    std::vector<PackedVertex> vertices;
    vertices.reserve(now.positions.size());
    pack(now.positions, now.normals, vertices);
    std::vector<glm::vec3> deltas(now.positions.size());
    for (std::size_t i = 0; i < deltas.size(); ++i) {
        deltas[i] = before.positions[i] - now.positions[i];
    }
    const auto upload = [this](const gl::BufferHandle& buffer, std::span<const std::byte> bytes) {
        m_gl.NamedBufferSubData(buffer.get(), 0, static_cast<GLsizeiptr>(bytes.size()),
                                bytes.data());
    };
    upload(batch.vertices, std::as_bytes(std::span(vertices)));
    upload(batch.deltas, std::as_bytes(std::span(deltas)));
}

void SceneGeometry::bind_instances(GLuint placements, GLsizei placement_stride, GLuint motions,
                                   GLsizei motion_stride) const {
    for (const Batch& batch : m_batches) {
        const GLuint name = batch.vertex_array.get();
        m_gl.VertexArrayVertexBuffer(name, VertexLayout::kPlacementBinding, placements, 0,
                                     placement_stride);
        m_gl.VertexArrayVertexBuffer(name, VertexLayout::kMotionBinding, motions, 0, motion_stride);
    }
}

} // namespace alcove
