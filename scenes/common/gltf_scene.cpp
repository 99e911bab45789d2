#include "scenes/common/gltf_scene.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "scenes/common/gltf_document.hpp"
#include "scenes/common/gltf_mesh.hpp"
#include "scenes/common/rigid_scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <tuple>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <tiny_gltf.h>

namespace alcove {
namespace {

constexpr std::size_t kMostVertices = std::size_t{64} * 1024 * 1024;
constexpr std::size_t kMostObjects = 1'000'000;
constexpr int kDeepestNode = 256;
constexpr double kFarthestMetres = 1e9;
constexpr int kFramesPerCamera = 60;
constexpr int kOrbitFrames = 120;

bool is_finite(const glm::dmat4& matrix) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            if (!std::isfinite(matrix[column][row])) {
                return false;
            }
        }
    }
    return true;
}

glm::dmat4 compute_local(const tinygltf::Node& node, const std::string& where) {
    const auto check_size = [&where](const std::vector<double>& values, std::size_t size,
                                     const char* name) {
        if (!values.empty() && values.size() != size) {
            throw InputError(where + "." + name, "wrong number of elements",
                             std::to_string(values.size()), std::to_string(size));
        }
        return !values.empty();
    };
    glm::dmat4 local(1.0);
    if (check_size(node.matrix, 16, "matrix")) {
        for (int i = 0; i < 16; ++i) {
            local[i / 4][i % 4] = node.matrix[static_cast<std::size_t>(i)];
        }
    } else {
        if (check_size(node.rotation, 4, "rotation")) {
            const std::vector<double>& r = node.rotation;
            const glm::dquat rotation(r[3], r[0], r[1], r[2]);
            if (!(glm::length(rotation) > 1e-6)) {
                throw InputError(where + ".rotation", "is not a rotation", {}, "a unit quaternion");
            }
            local = glm::mat4_cast(glm::normalize(rotation));
        }
        if (check_size(node.scale, 3, "scale")) {
            for (int i = 0; i < 3; ++i) {
                local[i] *= node.scale[static_cast<std::size_t>(i)];
            }
        }
        if (check_size(node.translation, 3, "translation")) {
            local[3] =
                glm::dvec4(node.translation[0], node.translation[1], node.translation[2], 1.0);
        }
    }
    const glm::dvec4 last(local[0][3], local[1][3], local[2][3], local[3][3]);
    if (!is_finite(local) || last != glm::dvec4(0.0, 0.0, 0.0, 1.0)) {
        throw InputError(where, "transform is not finite and affine");
    }
    return local;
}

struct Bounds {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};
    void add(const glm::dvec3& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
};

/// Walks the node trees of one scene and collects what they hold.
class SceneReader {
  public:
    SceneReader(const GltfDocument& document, std::set<std::string>& warnings)
        : m_document(document), m_model(*document.model), m_warnings(warnings),
          m_visited(m_model.nodes.size(), false) {}

    void read() {
        for (const int root : find_roots()) {
            visit(root, glm::dmat4(1.0), 0);
        }
        if (m_content.objects.empty()) {
            throw InputError(m_document.file, "the scene holds no triangles");
        }
    }

    [[nodiscard]] RigidSceneContent& content() { return m_content; }
    [[nodiscard]] const Bounds& bounds() const { return m_bounds; }
    /// Cameras of the file with their far plane, if it tells one.
    [[nodiscard]] const std::vector<std::pair<int, glm::dmat4>>& cameras() const {
        return m_cameras;
    }

  private:
    [[nodiscard]] std::vector<int> find_roots() {
        if (!m_model.scenes.empty()) {
            const int index = std::max(m_model.defaultScene, 0);
            if (static_cast<std::size_t>(index) >= m_model.scenes.size()) {
                throw InputError(m_document.file + ": scene", "no such scene",
                                 std::to_string(index),
                                 "less than " + std::to_string(m_model.scenes.size()));
            }
            return m_model.scenes[static_cast<std::size_t>(index)].nodes;
        }
        m_warnings.insert("the file has no scene: every node without a parent is shown");
        std::set<int> children;
        for (const tinygltf::Node& node : m_model.nodes) {
            children.insert(node.children.begin(), node.children.end());
        }
        std::vector<int> roots;
        for (int i = 0; i < static_cast<int>(m_model.nodes.size()); ++i) {
            if (!children.contains(i)) {
                roots.push_back(i);
            }
        }
        return roots;
    }

    void visit(int index, const glm::dmat4& parent, int depth) {
        const std::string where = m_document.name("nodes", index);
        if (index < 0 || static_cast<std::size_t>(index) >= m_model.nodes.size()) {
            throw InputError(where, "no such node", {},
                             "less than " + std::to_string(m_model.nodes.size()));
        }
        if (depth > kDeepestNode) {
            throw InputError(where, "nodes nested too deeply", {},
                             "at most " + std::to_string(kDeepestNode));
        }
        if (m_visited[static_cast<std::size_t>(index)]) {
            throw InputError(where, "is reached twice", {},
                             "nodes that form trees, without cycles");
        }
        m_visited[static_cast<std::size_t>(index)] = true;
        const tinygltf::Node& node = m_model.nodes[static_cast<std::size_t>(index)];
        const glm::dmat4 world = parent * compute_local(node, where);
        if (!is_finite(world)) {
            throw InputError(where, "transform is not finite");
        }
        if (node.skin >= 0) {
            m_warnings.insert("skins are ignored: skinned meshes stand in their bind pose");
        }
        if (node.camera >= 0) {
            m_cameras.emplace_back(node.camera, world);
        }
        if (node.mesh >= 0) {
            place_mesh(node, world, where);
        }
        for (const int child : node.children) {
            visit(child, world, depth + 1);
        }
    }

    void place_mesh(const tinygltf::Node& node, const glm::dmat4& world, const std::string& where) {
        if (static_cast<std::size_t>(node.mesh) >= m_model.meshes.size()) {
            throw InputError(where + ".mesh", "no such mesh", std::to_string(node.mesh),
                             "less than " + std::to_string(m_model.meshes.size()));
        }
        const double determinant = glm::determinant(glm::dmat3(world));
        if (determinant == 0.0 || !std::isfinite(determinant)) {
            m_warnings.insert(where + " is scaled to nothing and ignored");
            return;
        }
        const auto count = m_model.meshes[static_cast<std::size_t>(node.mesh)].primitives.size();
        for (int primitive = 0; primitive < static_cast<int>(count); ++primitive) {
            const auto vertices = count_vertices(m_document, node.mesh, primitive);
            const std::string name =
                node.name.empty() ? where.substr(where.rfind(' ') + 1) : node.name;
            if (!vertices) {
                m_warnings.insert(
                    "points and lines are ignored: " + m_document.name("meshes", node.mesh) +
                    ".primitives[" + std::to_string(primitive) + "]");
                continue;
            }
            m_vertices += *vertices; // each at most 2^32, so the sum cannot wrap before the test
            if (m_vertices > kMostVertices || m_content.objects.size() >= kMostObjects) {
                throw InputError(where, "the scene is too large", {},
                                 "at most " + std::to_string(kMostVertices) + " vertices and " +
                                     std::to_string(kMostObjects) + " objects");
            }
            const std::size_t mesh = find_mesh(node.mesh, primitive, determinant < 0.0);
            m_content.objects.push_back({name + "." + std::to_string(primitive), mesh});
            m_content.transforms.push_back(world);
            grow_bounds(mesh, world, where);
        }
    }

    std::size_t find_mesh(int mesh, int primitive, bool mirrored) {
        const auto key = std::make_tuple(mesh, primitive, mirrored);
        if (const auto known = m_meshes.find(key); known != m_meshes.end()) {
            return known->second;
        }
        Mesh made = read_primitive(m_document, mesh, primitive);
        if (mirrored) {
            made.name += ".mirrored";
            for (std::size_t i = 0; i < made.indices.size(); i += 3) {
                std::swap(made.indices[i + 1], made.indices[i + 2]);
            }
        }
        Bounds bounds;
        for (const glm::vec3& position : made.positions) {
            bounds.add(glm::dvec3(position));
        }
        m_content.meshes.push_back(std::move(made));
        m_mesh_bounds.push_back(bounds);
        return m_meshes.emplace(key, m_content.meshes.size() - 1).first->second;
    }

    /// By the eight corners of the mesh's box: never too small.
    void grow_bounds(std::size_t mesh, const glm::dmat4& world, const std::string& where) {
        const Bounds& own = m_mesh_bounds[mesh];
        for (unsigned corner = 0; corner < 8; ++corner) {
            const glm::dvec3 local((corner & 1u) != 0 ? own.high.x : own.low.x,
                                   (corner & 2u) != 0 ? own.high.y : own.low.y,
                                   (corner & 4u) != 0 ? own.high.z : own.low.z);
            m_bounds.add(glm::dvec3(world * glm::dvec4(local, 1.0)));
        }
        const glm::dvec3 reach = glm::max(glm::abs(m_bounds.low), glm::abs(m_bounds.high));
        if (!(std::max({reach.x, reach.y, reach.z}) <= kFarthestMetres)) {
            throw InputError(where, "lies too far out", {},
                             "coordinates of at most " + format_number(kFarthestMetres) + " m");
        }
    }

    const GltfDocument& m_document;
    const tinygltf::Model& m_model;
    std::set<std::string>& m_warnings;
    std::vector<bool> m_visited;
    std::map<std::tuple<int, int, bool>, std::size_t> m_meshes;
    std::vector<Bounds> m_mesh_bounds;
    RigidSceneContent m_content;
    Bounds m_bounds;
    std::size_t m_vertices = 0;
    std::vector<std::pair<int, glm::dmat4>> m_cameras;
};

std::optional<Camera> make_camera(const GltfDocument& document, int index, const glm::dmat4& world,
                                  const glm::dvec3& centre, double radius_m,
                                  std::set<std::string>& warnings) {
    const std::string where = document.name("cameras", index);
    if (static_cast<std::size_t>(index) >= document.model->cameras.size()) {
        throw InputError(where, "no such camera", {},
                         "less than " + std::to_string(document.model->cameras.size()));
    }
    const tinygltf::Camera& source = document.model->cameras[static_cast<std::size_t>(index)];
    if (source.type != "perspective") {
        warnings.insert("orthographic cameras are ignored: " + where);
        return std::nullopt;
    }
    const glm::dvec3 position(world[3]);
    const double near_m =
        source.perspective.znear > 0.0 ? source.perspective.znear : 1e-3 * radius_m;
    const double far_m =
        source.perspective.zfar > 0.0
            ? source.perspective.zfar
            : std::max(glm::distance(position, centre) + 1.01 * radius_m, 2.0 * near_m);
    try {
        // Scale in the node's transform must not stretch the view: only directions are taken.
        return make_look_at_camera(position, position - glm::normalize(glm::dvec3(world[2])),
                                   glm::normalize(glm::dvec3(world[1])), source.perspective.yfov,
                                   near_m, far_m);
    } catch (const InputError& error) {
        throw InputError(where, error.what());
    }
}

Walkthrough make_orbit(const glm::dvec3& centre, double radius_m) {
    constexpr double kFov = std::numbers::pi / 3.0;
    const double distance_m = radius_m / std::sin(0.5 * kFov);
    Walkthrough walkthrough;
    walkthrough.name = "orbit";
    for (int frame = 0; frame < kOrbitFrames; ++frame) {
        const double angle = 2.0 * std::numbers::pi * frame / kOrbitFrames;
        const glm::dvec3 direction =
            glm::normalize(glm::dvec3(std::sin(angle), 0.35, std::cos(angle)));
        walkthrough.cameras.push_back(make_look_at_camera(centre + distance_m * direction, centre,
                                                          {0.0, 1.0, 0.0}, kFov, 0.05 * radius_m,
                                                          distance_m + 1.01 * radius_m));
    }
    return walkthrough;
}

void list_ignored(const tinygltf::Model& model, std::set<std::string>& warnings) {
    if (!model.textures.empty()) {
        warnings.insert("textures are ignored: surfaces have their base colour factor");
    }
    if (!model.animations.empty()) {
        warnings.insert("animations are ignored: nodes stand where the file puts them");
    }
    for (const tinygltf::Mesh& mesh : model.meshes) {
        for (const tinygltf::Primitive& primitive : mesh.primitives) {
            if (!primitive.targets.empty()) {
                warnings.insert("morph targets are ignored");
            }
        }
    }
    for (const std::string& extension : model.extensionsUsed) {
        warnings.insert("extension is ignored: " + extension);
    }
}

} // namespace

std::unique_ptr<Scene> open_gltf_scene(const std::filesystem::path& path,
                                       const GltfOptions& options,
                                       std::vector<std::string>* warnings) {
    if (options.ao_radius_m &&
        !(*options.ao_radius_m > 0.0 && std::isfinite(*options.ao_radius_m))) {
        throw InputError(path.string(), "AO radius out of range",
                         format_number(*options.ao_radius_m), "a positive number of metres");
    }
    const GltfDocument document = load_gltf(path);
    std::set<std::string> notes;
    list_ignored(*document.model, notes);
    SceneReader reader(document, notes);
    reader.read();
    const Bounds& bounds = reader.bounds();
    const glm::dvec3 centre = 0.5 * (bounds.low + bounds.high);
    const double diagonal_m = glm::distance(bounds.low, bounds.high);
    if (!(diagonal_m > 0.0)) {
        throw InputError(document.file, "all vertices lie in one point");
    }

    RigidSceneContent& content = reader.content();
    content.ao_radius_m = options.ao_radius_m.value_or(0.05 * diagonal_m);
    content.lights.directional.push_back(
        {glm::normalize(glm::dvec3(0.4, 1.0, 0.6)), glm::vec3(1.0f)});
    content.lights.ambient = glm::vec3(0.5f);
    for (const auto& [index, world] : reader.cameras()) {
        const auto camera = make_camera(document, index, world, centre, 0.5 * diagonal_m, notes);
        if (camera) {
            std::vector<Camera>& cameras = content.walkthrough.cameras;
            content.walkthrough.cuts.push_back(static_cast<int>(cameras.size()));
            cameras.insert(cameras.end(), kFramesPerCamera, *camera);
        }
    }
    if (content.walkthrough.cameras.empty()) {
        notes.insert("no perspective camera in the file: the walkthrough circles its bounding box");
        content.walkthrough = make_orbit(centre, 0.5 * diagonal_m);
    }
    // Far from zero the scene gets an origin of its own, so that float geometry keeps its
    // precision.
    if (glm::length(centre) > 10.0 * diagonal_m) {
        content.origin = glm::round(centre);
        for (glm::dmat4& transform : content.transforms) {
            transform[3] -= glm::dvec4(content.origin, 0.0);
        }
        for (Camera& camera : content.walkthrough.cameras) {
            camera.position -= content.origin;
        }
    }
    if (warnings != nullptr) {
        warnings->insert(warnings->end(), notes.begin(), notes.end());
    }
    return std::make_unique<RigidScene>(std::move(content));
}

} // namespace alcove
