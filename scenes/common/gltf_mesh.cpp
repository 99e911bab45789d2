#include "scenes/common/gltf_mesh.hpp"

#include "core/base/error.hpp"
#include "scenes/common/gltf_accessor.hpp"

#include <algorithm>
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

/// Three vertices a triangle, each with the face's normal.
void make_flat(Mesh& mesh) {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    positions.reserve(mesh.indices.size());
    normals.reserve(mesh.indices.size());
    for (std::size_t triangle = 0; triangle < mesh.indices.size() / 3; ++triangle) {
        for (std::size_t place = 0; place < 3; ++place) {
            positions.push_back(mesh.positions[mesh.indices[3 * triangle + place]]);
            normals.push_back(compute_face_normal(mesh, triangle));
        }
    }
    mesh.positions = std::move(positions);
    mesh.normals = std::move(normals);
    std::iota(mesh.indices.begin(), mesh.indices.end(), 0u);
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

glm::vec3 find_albedo(const GltfDocument& document, int material, const std::string& where) {
    if (material < 0) {
        return glm::vec3(1.0f);
    }
    if (static_cast<std::size_t>(material) >= document.model->materials.size()) {
        throw InputError(where + ".material", "no such material", std::to_string(material),
                         "less than " + std::to_string(document.model->materials.size()));
    }
    const std::vector<double>& factor =
        document.model->materials[static_cast<std::size_t>(material)]
            .pbrMetallicRoughness.baseColorFactor;
    const bool in_range = factor.size() == 4 &&
                          std::all_of(factor.begin(), factor.end(),
                                      [](double value) { return value >= 0.0 && value <= 1.0; });
    if (!in_range) {
        throw InputError(document.name("materials", material) + ".baseColorFactor", "out of range",
                         {}, "four numbers from 0 to 1");
    }
    return glm::vec3(glm::dvec3(factor[0], factor[1], factor[2]));
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

Mesh read_primitive(const GltfDocument& document, int mesh, int primitive) {
    const tinygltf::Primitive& source = find_primitive(document, mesh, primitive);
    const std::string where = name_primitive(document, mesh, primitive);
    Mesh result;
    const std::string& name = document.model->meshes[static_cast<std::size_t>(mesh)].name;
    result.name =
        (name.empty() ? "mesh" + std::to_string(mesh) : name) + "." + std::to_string(primitive);
    result.albedo = find_albedo(document, source.material, where);
    result.positions = read_vectors(document, find_attribute(source, "POSITION"));
    std::vector<std::uint32_t> corners(result.positions.size());
    if (source.indices >= 0) {
        corners = read_indices(document, source.indices, result.positions.size());
    } else {
        std::iota(corners.begin(), corners.end(), 0u);
    }
    result.indices = list_triangles(corners, source.mode, where);
    const int normals = find_attribute(source, "NORMAL");
    if (normals < 0) {
        make_flat(result);
        return result;
    }
    result.normals = read_vectors(document, normals);
    if (result.normals.size() != result.positions.size()) {
        throw InputError(where, "NORMAL and POSITION differ in number",
                         std::to_string(result.normals.size()),
                         std::to_string(result.positions.size()));
    }
    normalise(result);
    return result;
}

} // namespace alcove
