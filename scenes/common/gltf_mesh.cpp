#include "scenes/common/gltf_mesh.hpp"

#include "core/base/error.hpp"
#include "scenes/common/gltf_accessor.hpp"
#include "scenes/common/gltf_morph.hpp"
#include "scenes/common/gltf_skin.hpp"
#include "scenes/common/gltf_surface.hpp"

#include <cmath>
#include <numeric>
#include <utility>

#include <glm/geometric.hpp>
#include <tiny_gltf.h>

namespace alcove {
namespace {

const tinygltf::Primitive& find_primitive(const GltfDocument& document, int mesh, int primitive) {
    return document.model->meshes[static_cast<std::size_t>(mesh)]
        .primitives[static_cast<std::size_t>(primitive)];
}

std::string name_primitive(const GltfDocument& document, int mesh, int primitive) {
    return document.name("meshes", mesh) + ".primitives[" + std::to_string(primitive) + "]";
}

int find_attribute(const tinygltf::Primitive& primitive, const char* name) {
    const auto found = primitive.attributes.find(name);
    return found == primitive.attributes.end() ? -1 : found->second;
}

/// Strips and fans as triangles (glTF 2.0, 3.7.2.1). Every other triangle of a strip is turned.
std::vector<std::uint32_t> list_triangles(const std::vector<std::uint32_t>& corners, int mode,
                                          const std::string& where) {
    if (corners.size() < 3 || (mode == TINYGLTF_MODE_TRIANGLES && corners.size() % 3 != 0)) {
        throw InputError(where, "does not hold whole triangles",
                         std::to_string(corners.size()) + " corners");
    }
    if (mode == TINYGLTF_MODE_TRIANGLES) {
        return corners;
    }
    std::vector<std::uint32_t> triangles;
    triangles.reserve((corners.size() - 2) * 3);
    for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
        if (mode == TINYGLTF_MODE_TRIANGLE_FAN) {
            triangles.insert(triangles.end(), {corners[0], corners[i + 1], corners[i + 2]});
        } else {
            const std::size_t odd = i % 2;
            triangles.insert(triangles.end(),
                             {corners[i], corners[i + 1 + odd], corners[i + 2 - odd]});
        }
    }
    return triangles;
}

glm::vec3 compute_face_normal(const Mesh& mesh, std::size_t triangle) {
    const auto corner = [&](std::size_t place) {
        return glm::dvec3(mesh.positions[mesh.indices[3 * triangle + place]]);
    };
    const glm::dvec3 cross = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
    const double length = glm::length(cross);
    return length > 0.0 && std::isfinite(length) ? glm::vec3(cross / length)
                                                 : glm::vec3(0.0f, 1.0f, 0.0f);
}

template <class T>
void reorder(std::vector<T>& values, const std::vector<std::uint32_t>& order) {
    if (values.empty()) {
        return;
    }
    std::vector<T> ordered;
    ordered.reserve(order.size());
    for (const std::uint32_t index : order) {
        ordered.push_back(values[index]);
    }
    values = std::move(ordered);
}

void reorder(SkinInfluences& influences, const std::vector<std::uint32_t>& order) {
    SkinInfluences ordered{influences.per_vertex, {}, {}};
    for (const std::uint32_t index : order) {
        for (std::size_t i = 0; i < influences.per_vertex; ++i) {
            const std::size_t from = index * influences.per_vertex + i;
            ordered.joints.push_back(influences.joints[from]);
            ordered.weights.push_back(influences.weights[from]);
        }
    }
    influences = std::move(ordered);
}

/// Three vertices a triangle, each with the face's normal. Returns the vertices they were made of.
std::vector<std::uint32_t> make_flat(GltfPrimitive& primitive) {
    Mesh& mesh = primitive.mesh;
    const std::vector<std::uint32_t> order = mesh.indices;
    mesh.normals.reserve(order.size());
    for (std::size_t corner = 0; corner < order.size(); ++corner) {
        mesh.normals.push_back(compute_face_normal(mesh, corner / 3));
    }
    reorder(mesh.positions, order);
    reorder(mesh.colors, order);
    reorder(mesh.texture_coordinates, order);
    if (primitive.deformers.influences) {
        reorder(*primitive.deformers.influences, order);
    }
    std::iota(mesh.indices.begin(), mesh.indices.end(), 0u);
    primitive.deformers.is_flat = true;
    return order;
}

/// Normals of any length become unit; those without one take the normal of a face at their vertex.
void normalise(Mesh& mesh) {
    std::vector<bool> missing(mesh.normals.size(), false);
    bool any = false;
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        const glm::dvec3 normal(mesh.normals[i]);
        const double length = glm::length(normal);
        missing[i] = !(length > 1e-12);
        any = any || missing[i];
        mesh.normals[i] = missing[i] ? glm::vec3(0.0f, 1.0f, 0.0f) : glm::vec3(normal / length);
    }
    for (std::size_t i = 0; any && i < mesh.indices.size(); ++i) {
        if (missing[mesh.indices[i]]) {
            mesh.normals[mesh.indices[i]] = compute_face_normal(mesh, i / 3);
        }
    }
}

} // namespace

std::optional<std::size_t> count_vertices(const GltfDocument& document, int mesh, int primitive) {
    const tinygltf::Primitive& source = find_primitive(document, mesh, primitive);
    if (source.mode < TINYGLTF_MODE_TRIANGLES || source.mode > TINYGLTF_MODE_TRIANGLE_FAN) {
        return std::nullopt;
    }
    const int positions = find_attribute(source, "POSITION");
    if (positions < 0) {
        throw InputError(name_primitive(document, mesh, primitive), "has no POSITION");
    }
    const std::size_t vertices = count_elements(document, positions);
    if (find_attribute(source, "NORMAL") >= 0) {
        return vertices;
    }
    const std::size_t corners =
        source.indices >= 0 ? count_elements(document, source.indices) : vertices;
    return source.mode == TINYGLTF_MODE_TRIANGLES ? corners : corners * 3;
}

GltfPrimitive read_primitive(const GltfDocument& document, int mesh, int primitive,
                             GltfTextures& textures, GltfWarnings& warnings) {
    const tinygltf::Primitive& source = find_primitive(document, mesh, primitive);
    const std::string where = name_primitive(document, mesh, primitive);
    GltfPrimitive result;
    Mesh& made = result.mesh;
    const std::string& name = document.model->meshes[static_cast<std::size_t>(mesh)].name;
    made.name =
        (name.empty() ? "mesh" + std::to_string(mesh) : name) + "." + std::to_string(primitive);
    made.positions =
        read_vectors(document, find_attribute(source, "POSITION"), GltfNumbers::quantised);
    const std::size_t vertices = made.positions.size();
    std::vector<std::uint32_t> corners;
    if (source.indices >= 0) {
        corners = read_indices(document, source.indices, 1, vertices);
    } else {
        document.charge(vertices * sizeof(std::uint32_t), where);
        corners.resize(vertices);
        std::iota(corners.begin(), corners.end(), 0u);
    }
    document.charge(3 * corners.size() * sizeof(std::uint32_t), where);
    made.indices = list_triangles(corners, source.mode, where);
    read_surface(document, source, where, textures, warnings, made);
    result.deformers.influences = read_influences(document, source, vertices, where, warnings);
    const int normals = find_attribute(source, "NORMAL");
    std::vector<std::uint32_t> order;
    if (normals < 0) {
        constexpr std::size_t kMostBytesAVertex = 128;
        document.charge(made.indices.size() * kMostBytesAVertex, where);
        order = make_flat(result);
    } else {
        made.normals = read_vectors(document, normals, GltfNumbers::quantised);
        if (made.normals.size() != vertices) {
            throw InputError(where, "NORMAL and POSITION differ in number",
                             std::to_string(made.normals.size()), std::to_string(vertices));
        }
        normalise(made);
        order.resize(vertices);
        std::iota(order.begin(), order.end(), 0u);
    }
    result.deformers.targets = read_morph_targets(document, source, order, vertices, where);
    return result;
}

void turn_triangles(GltfPrimitive& primitive) {
    std::vector<std::uint32_t>& indices = primitive.mesh.indices;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        std::swap(indices[i + 1], indices[i + 2]);
    }
    primitive.deformers.is_turned = !primitive.deformers.is_turned;
}

} // namespace alcove
