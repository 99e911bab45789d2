#include "scenes/common/gltf_objects.hpp"

#include "core/base/error.hpp"
#include "scenes/common/gltf_mesh.hpp"
#include "scenes/common/gltf_skin.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <tuple>
#include <utility>

#include <glm/matrix.hpp>
#include <tiny_gltf.h>

namespace alcove {
namespace {

constexpr std::size_t kMostVertices = std::size_t{64} * 1024 * 1024;
constexpr std::size_t kMostObjects = 1'000'000;

/// Weights of the morph targets of an object.
struct ObjectWeights {
    std::vector<double> rest;
    std::optional<Keyframes> keys;
};

class ObjectPlacer {
  public:
    ObjectPlacer(const GltfDocument& document, const GltfTree& tree, const GltfClip& clip,
                 const std::vector<glm::dmat4>& world, GltfWarnings& warnings)
        : m_document(document), m_model(*document.model), m_tree(tree), m_clip(clip),
          m_world(world), m_warnings(warnings), m_moving(find_moving(tree.nodes)),
          m_textures(document, warnings) {}

    [[nodiscard]] AnimatedSceneContent place() {
        for (std::size_t node = 0; node < m_tree.nodes.size(); ++node) {
            if (source_of(node).mesh >= 0) {
                place_mesh(node);
            }
        }
        if (m_content.objects.empty()) {
            throw InputError(m_document.file, "the scene holds no triangles");
        }
        m_content.textures = m_textures.take();
        m_content.weights = [weights = std::move(m_weights),
                             duration_s = m_clip.duration_s](std::size_t object, double time_s) {
            const ObjectWeights& own = weights.at(object);
            return own.keys ? evaluate_numbers(*own.keys, wrap_time(time_s, duration_s)) : own.rest;
        };
        return std::move(m_content);
    }

  private:
    [[nodiscard]] const tinygltf::Node& source_of(std::size_t node) const {
        return m_model.nodes[static_cast<std::size_t>(m_tree.indices[node])];
    }

    void place_mesh(std::size_t node) {
        const tinygltf::Node& source = source_of(node);
        const std::string where = m_tree.name(m_document, node);
        if (static_cast<std::size_t>(source.mesh) >= m_model.meshes.size()) {
            throw InputError(where + ".mesh", "no such mesh", std::to_string(source.mesh),
                             "less than " + std::to_string(m_model.meshes.size()));
        }
        const auto skin = source.skin >= 0 ? find_skin(source.skin) : std::nullopt;
        const double determinant = glm::determinant(glm::dmat3(m_world[node]));
        if (!skin && (determinant == 0.0 || !std::isfinite(determinant))) {
            m_warnings.insert(where + " is scaled to nothing and ignored");
            return;
        }
        const auto& primitives = m_model.meshes[static_cast<std::size_t>(source.mesh)].primitives;
        for (int i = 0; i < static_cast<int>(primitives.size()); ++i) {
            place_primitive(node, i, skin, determinant < 0.0);
        }
    }

    void place_primitive(std::size_t node, int primitive, std::optional<std::size_t> skin,
                         bool is_mirroring) {
        const tinygltf::Node& source = source_of(node);
        const std::string where = m_tree.name(m_document, node);
        const std::string mesh_name = m_document.name("meshes", source.mesh) + ".primitives[" +
                                      std::to_string(primitive) + "]";
        const auto vertices = count_vertices(m_document, source.mesh, primitive);
        if (!vertices) {
            m_warnings.insert("points and lines are ignored: " + mesh_name);
            return;
        }
        m_vertices += *vertices; // each at most 2^32, so the sum cannot wrap before the test
        if (m_vertices > kMostVertices || m_content.objects.size() >= kMostObjects) {
            throw InputError(where, "the scene is too large", {},
                             "at most " + std::to_string(kMostVertices) + " vertices and " +
                                 std::to_string(kMostObjects) + " objects");
        }
        AnimatedObject made;
        if (skin && has_joints(source.mesh, primitive)) {
            made.object.mesh = find_mesh(source.mesh, primitive, is_turned_by(*skin));
            const auto& influences = m_content.deformers[made.object.mesh].influences;
            if (influences) {
                check_influences(*influences, m_content.skins[*skin], mesh_name);
                made.skin = skin;
            }
        } else if (source.skin >= 0 && skin) {
            m_warnings.insert("skin is ignored, the primitive has no joints: " + mesh_name);
        }
        if (!made.skin) {
            made.object.mesh = find_mesh(source.mesh, primitive, is_mirroring);
        }
        const std::string base =
            source.name.empty() ? where.substr(where.rfind(' ') + 1) : source.name;
        made.object.name = base + "." + std::to_string(primitive);
        made.node = node;
        add_weights(node, m_content.deformers[made.object.mesh].targets.size(), made);
        made.object.motion = made.skin || made.is_morphed ? ObjectMotion::deforming
                             : m_moving[node]             ? ObjectMotion::rigid
                                                          : ObjectMotion::still;
        m_content.objects.push_back(std::move(made));
    }

    [[nodiscard]] bool has_joints(int mesh, int primitive) const {
        return m_model.meshes[static_cast<std::size_t>(mesh)]
            .primitives[static_cast<std::size_t>(primitive)]
            .attributes.contains("JOINTS_0");
    }

    /// True if most joints mirror what they carry, at time 0.
    [[nodiscard]] bool is_turned_by(std::size_t index) const {
        const Skin& skin = m_content.skins[index];
        std::size_t count = 0;
        for (std::size_t i = 0; i < skin.joints.size(); ++i) {
            const glm::dmat4 matrix = m_world[skin.joints[i]] * skin.inverse_bind[i];
            count += glm::determinant(glm::dmat3(matrix)) < 0.0 ? 1 : 0;
        }
        return 2 * count > skin.joints.size();
    }

    void add_weights(std::size_t node, std::size_t targets, AnimatedObject& object) {
        ObjectWeights weights;
        if (targets > 0) {
            const tinygltf::Node& source = source_of(node);
            const auto& mesh = m_model.meshes[static_cast<std::size_t>(source.mesh)];
            weights.rest = !source.weights.empty() ? source.weights : mesh.weights;
            if (weights.rest.empty()) {
                weights.rest.assign(targets, 0.0);
            }
            const auto keys = m_clip.weights.find(node);
            if (keys != m_clip.weights.end()) {
                weights.keys = keys->second;
            }
            const bool fits = weights.rest.size() == targets &&
                              (!weights.keys || weights.keys->components == targets) &&
                              std::all_of(weights.rest.begin(), weights.rest.end(),
                                          [](double w) { return std::isfinite(w); });
            if (!fits) {
                throw InputError(m_tree.name(m_document, node) + ".weights",
                                 "needs one finite weight a morph target of each primitive",
                                 std::to_string(weights.rest.size()), std::to_string(targets));
            }
            object.is_morphed =
                weights.keys || std::any_of(weights.rest.begin(), weights.rest.end(),
                                            [](double w) { return w != 0.0; });
        }
        m_weights.push_back(std::move(weights));
    }

    [[nodiscard]] std::optional<std::size_t> find_skin(int index) {
        const auto known = m_skins.find(index);
        if (known != m_skins.end()) {
            return known->second;
        }
        std::optional<std::size_t> place;
        if (auto skin = read_skin(m_document, index, m_tree.places, m_warnings)) {
            place = m_content.skins.size();
            m_content.skins.push_back(std::move(*skin));
        }
        m_skins.emplace(index, place);
        return place;
    }

    [[nodiscard]] std::size_t find_mesh(int mesh, int primitive, bool is_turned) {
        const auto key = std::make_tuple(mesh, primitive, is_turned);
        if (const auto known = m_meshes.find(key); known != m_meshes.end()) {
            return known->second;
        }
        GltfPrimitive made = read_primitive(m_document, mesh, primitive, m_textures, m_warnings);
        if (is_turned) {
            made.mesh.name += ".mirrored";
            turn_triangles(made);
        }
        m_content.meshes.push_back(std::move(made.mesh));
        m_content.deformers.push_back(std::move(made.deformers));
        return m_meshes.emplace(key, m_content.meshes.size() - 1).first->second;
    }

    const GltfDocument& m_document;
    const tinygltf::Model& m_model;
    const GltfTree& m_tree;
    const GltfClip& m_clip;
    const std::vector<glm::dmat4>& m_world;
    GltfWarnings& m_warnings;
    std::vector<bool> m_moving;
    GltfTextures m_textures;
    std::map<std::tuple<int, int, bool>, std::size_t> m_meshes;
    std::map<int, std::optional<std::size_t>> m_skins;
    std::vector<ObjectWeights> m_weights;
    AnimatedSceneContent m_content;
    std::size_t m_vertices = 0;
};

} // namespace

AnimatedSceneContent place_objects(const GltfDocument& document, const GltfTree& tree,
                                   const GltfClip& clip, const std::vector<glm::dmat4>& world,
                                   GltfWarnings& warnings) {
    return ObjectPlacer(document, tree, clip, world, warnings).place();
}

} // namespace alcove
