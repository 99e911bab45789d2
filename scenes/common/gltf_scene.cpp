#include "scenes/common/gltf_scene.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "scenes/common/animated_scene.hpp"
#include "scenes/common/gltf_animation.hpp"
#include "scenes/common/gltf_cameras.hpp"
#include "scenes/common/gltf_document.hpp"
#include "scenes/common/gltf_lights.hpp"
#include "scenes/common/gltf_nodes.hpp"
#include "scenes/common/gltf_objects.hpp"
#include "scenes/common/walkthrough_file.hpp"

#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <tiny_gltf.h>

namespace alcove {
namespace {

void check_options(const std::filesystem::path& path, const GltfOptions& options) {
    if (options.ao_radius_m &&
        !(*options.ao_radius_m > 0.0 && std::isfinite(*options.ao_radius_m))) {
        throw InputError(path.string(), "AO radius out of range",
                         format_number(*options.ao_radius_m), "a positive number of metres");
    }
}

void list_unknown_extensions(const tinygltf::Model& model, GltfWarnings& warnings) {
    for (const std::string& extension : model.extensionsUsed) {
        if (!is_known_gltf_extension(extension)) {
            warnings.insert("extension is ignored: " + extension);
        }
    }
}

/// Nodes relative to `origin` over a clip that repeats.
std::function<std::vector<glm::dmat4>(double)>
make_nodes(std::vector<TreeNode> tree, double duration_s, const glm::dvec3& origin) {
    return [tree = std::move(tree), duration_s, origin](double time_s) {
        std::vector<glm::dmat4> nodes = compute_nodes(tree, wrap_time(time_s, duration_s));
        for (glm::dmat4& node : nodes) {
            node[3] -= glm::dvec4(origin, 0.0);
        }
        return nodes;
    };
}

/// The same for a scene whose nodes never move.
std::function<std::vector<glm::dmat4>(double)> keep_nodes(std::vector<glm::dmat4> nodes,
                                                          const glm::dvec3& origin) {
    for (glm::dmat4& node : nodes) {
        node[3] -= glm::dvec4(origin, 0.0);
    }
    return [nodes = std::move(nodes)](double) { return nodes; };
}

void move_walkthrough(Walkthrough& walkthrough, const glm::dvec3& origin) {
    for (Camera& camera : walkthrough.cameras) {
        camera.position -= origin;
    }
    for (ObjectTrack& track : walkthrough.tracks) {
        track.pivot -= origin;
    }
}

} // namespace

std::unique_ptr<Scene> open_gltf_scene(const std::filesystem::path& path,
                                       const GltfOptions& options,
                                       std::vector<std::string>* warnings) {
    check_options(path, options);
    const GltfDocument document = load_gltf(path);
    GltfWarnings notes;
    list_unknown_extensions(*document.model, notes);
    GltfTree tree = read_nodes(document, notes);
    const GltfClip clip = read_clip(document, options.animation, tree, notes);
    const std::vector<glm::dmat4> world = compute_nodes(tree.nodes, 0.0);
    AnimatedSceneContent content = place_objects(document, tree, clip, world, notes);
    content.is_at_rest = !(clip.duration_s > 0.0);
    const auto make = [&](const glm::dvec3& origin) {
        return content.is_at_rest ? keep_nodes(world, origin)
                                  : make_nodes(tree.nodes, clip.duration_s, origin);
    };
    content.nodes = make(glm::dvec3(0.0));
    const Bounds bounds = measure_bounds(document, tree, content, clip.duration_s);
    const double diagonal_m = bounds.diagonal();
    if (!(diagonal_m > 0.0)) {
        throw InputError(document.file, "all vertices lie in one point");
    }

    content.ao_radius_m = options.ao_radius_m.value_or(0.05 * diagonal_m);
    GltfLights lights = read_lights(document, tree, world, diagonal_m, notes);
    content.lights = std::move(lights.lights);
    content.directional_nodes = std::move(lights.directional_nodes);
    content.point_nodes = std::move(lights.point_nodes);
    if (content.lights.directional.empty() && content.lights.points.empty()) {
        content.lights.directional.push_back(
            {glm::normalize(glm::dvec3(0.4, 1.0, 0.6)), glm::vec3(1.0f)});
    }
    content.lights.ambient = glm::vec3(0.5f);
    content.walkthrough =
        options.walkthrough ? read_walkthrough_file(*options.walkthrough)
                            : make_gltf_walkthrough(document, tree, clip.duration_s, bounds, notes);
    // Far from zero the scene gets an origin of its own, so that float geometry keeps its
    // precision.
    if (glm::length(bounds.centre()) > 10.0 * diagonal_m) {
        content.origin = glm::round(bounds.centre());
        content.nodes = make(content.origin);
        move_walkthrough(content.walkthrough, content.origin);
    }
    if (warnings != nullptr) {
        warnings->insert(warnings->end(), notes.begin(), notes.end());
    }
    return std::make_unique<AnimatedScene>(std::move(content));
}

} // namespace alcove
