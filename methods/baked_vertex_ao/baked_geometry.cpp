#include "methods/baked_vertex_ao/baked_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace alcove {
namespace {

/// The largest triangle at a vertex: what its rays start on.
struct Facet {
    glm::vec3 center;
    glm::vec3 area_normal{0.0f}; ///< twice its area long; 0: the vertex has no triangle
};

std::vector<Facet> find_facets(std::span<const glm::vec3> positions,
                               std::span<const std::uint32_t> indices) {
    std::vector<Facet> facets(positions.size());
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const glm::vec3& a = positions[indices[i]];
        const glm::vec3& b = positions[indices[i + 1]];
        const glm::vec3& c = positions[indices[i + 2]];
        const Facet facet{(a + b + c) / 3.0f, glm::cross(b - a, c - a)};
        for (std::size_t corner = i; corner < i + 3; ++corner) {
            Facet& known = facets[indices[corner]];
            if (glm::dot(facet.area_normal, facet.area_normal) >
                glm::dot(known.area_normal, known.area_normal)) {
                known = facet;
            }
        }
    }
    return facets;
}

/// Above the facet by what floats of this size are off by, as rays of the reference start.
constexpr float kLift = 0x1p-18f;

constexpr GLuint kPositionBinding = 0;
constexpr GLuint kVisibilityBinding = 1;

} // namespace

std::vector<SurfacePoint> list_vertex_points(const PosedGeometry& geometry, double inset) {
    std::vector<SurfacePoint> points;
    for (const PosedObject& object : geometry.objects) {
        const std::span<const glm::vec3> positions = object.positions();
        const std::span<const glm::vec3> normals = object.normals();
        const std::vector<Facet> facets = find_facets(positions, object.mesh->indices);
        const glm::mat3 linear(object.origin_from_object);
        const glm::mat3 normal_matrix = glm::transpose(glm::inverse(linear));
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const glm::vec3 normal = glm::normalize(normal_matrix * normals[i]);
            if (facets[i].area_normal == glm::vec3(0.0f)) {
                points.push_back(
                    {glm::vec3(object.origin_from_object * glm::vec4(positions[i], 1.0f)), normal});
                continue;
            }
            const glm::vec3 moved =
                glm::mix(positions[i], facets[i].center, static_cast<float>(inset));
            glm::vec3 place(object.origin_from_object * glm::vec4(moved, 1.0f));
            const glm::vec3 facing = glm::normalize(normal_matrix * facets[i].area_normal);
            const float size = std::max({std::abs(place.x), std::abs(place.y), std::abs(place.z)});
            place += facing * (glm::dot(facing, normal) < 0.0f ? -kLift : kLift) * size;
            points.push_back({place, normal});
        }
    }
    return points;
}

BakedGeometry::BakedGeometry(const gl::Functions& gl, const PosedGeometry& geometry,
                             std::span<const float> visibility)
    : m_gl(&gl) {
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> indices;
    std::map<const Mesh*, std::size_t> first_indices; // of meshes that are placed many times
    for (const PosedObject& object : geometry.objects) {
        const auto [known, is_new] = first_indices.try_emplace(object.mesh, indices.size());
        if (is_new) {
            indices.insert(indices.end(), object.mesh->indices.begin(), object.mesh->indices.end());
        }
        m_places.push_back({static_cast<GLsizei>(object.mesh->indices.size()),
                            known->second * sizeof(std::uint32_t),
                            static_cast<GLint>(positions.size())});
        positions.insert(positions.end(), object.positions().begin(), object.positions().end());
    }
    ALCOVE_ASSERT(visibility.size() == positions.size(), "one visibility a vertex");
    ALCOVE_ASSERT(!indices.empty(), "geometry with triangles");
    m_positions =
        gl::create_buffer(gl, std::as_bytes(std::span(positions)), GL_DYNAMIC_STORAGE_BIT);
    m_visibility = gl::create_buffer(gl, std::as_bytes(visibility));
    m_indices = gl::create_buffer(gl, std::as_bytes(std::span(indices)));
    GLuint name = 0;
    gl.CreateVertexArrays(1, &name);
    m_vertex_array = gl::VertexArrayHandle(gl, name);
    gl.VertexArrayElementBuffer(name, m_indices.get());
    gl.VertexArrayVertexBuffer(name, kPositionBinding, m_positions.get(), 0, sizeof(glm::vec3));
    gl.VertexArrayVertexBuffer(name, kVisibilityBinding, m_visibility.get(), 0, sizeof(float));
    for (const auto& [binding, components] :
         {std::pair{kPositionBinding, 3}, {kVisibilityBinding, 1}}) {
        gl.EnableVertexArrayAttrib(name, binding);
        gl.VertexArrayAttribFormat(name, binding, components, GL_FLOAT, GL_FALSE, 0);
        gl.VertexArrayAttribBinding(name, binding, binding);
    }
}

void BakedGeometry::update(const PosedGeometry& geometry) {
    for (std::size_t i = 0; i < geometry.objects.size(); ++i) {
        const PosedObject& object = geometry.objects[i];
        if (!object.deformation) {
            continue;
        }
        const std::span<const glm::vec3> positions = object.positions();
        m_gl->NamedBufferSubData(m_positions.get(),
                                 static_cast<GLintptr>(m_places[i].base_vertex *
                                                       static_cast<GLintptr>(sizeof(glm::vec3))),
                                 static_cast<GLsizeiptr>(positions.size_bytes()), positions.data());
    }
}

void BakedGeometry::bind() const {
    m_gl->BindVertexArray(m_vertex_array.get());
}

} // namespace alcove
