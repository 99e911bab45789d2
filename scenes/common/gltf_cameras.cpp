#include "scenes/common/gltf_cameras.hpp"

#include "core/base/error.hpp"
#include "scenes/common/orbit.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <tiny_gltf.h>

namespace alcove {
namespace {

constexpr int kFramesPerCamera = 60;
constexpr int kMostFrames = 100'000;

/// Cameras of the file that can be looked through, with their nodes.
std::vector<std::pair<int, std::size_t>>
list_cameras(const GltfDocument& document, const GltfTree& tree, GltfWarnings& warnings) {
    std::vector<std::pair<int, std::size_t>> cameras;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const int index = document.model->nodes[static_cast<std::size_t>(tree.indices[i])].camera;
        if (index < 0) {
            continue;
        }
        const std::string where = document.name("cameras", index);
        if (static_cast<std::size_t>(index) >= document.model->cameras.size()) {
            throw InputError(where, "no such camera", {},
                             "less than " + std::to_string(document.model->cameras.size()));
        }
        if (document.model->cameras[static_cast<std::size_t>(index)].type != "perspective") {
            warnings.insert("orthographic cameras are ignored: " + where);
            continue;
        }
        cameras.emplace_back(index, i);
    }
    return cameras;
}

Camera make_camera(const GltfDocument& document, int index, const glm::dmat4& world,
                   const Bounds& bounds) {
    const double radius_m = 0.5 * bounds.diagonal();
    const tinygltf::PerspectiveCamera& source =
        document.model->cameras[static_cast<std::size_t>(index)].perspective;
    const glm::dvec3 position(world[3]);
    const double near_m = source.znear > 0.0 ? source.znear : 1e-3 * radius_m;
    const double far_m =
        source.zfar > 0.0
            ? source.zfar
            : std::max(glm::distance(position, bounds.centre()) + 1.01 * radius_m, 2.0 * near_m);
    try {
        // Scale in the node's transform must not stretch the view: only directions are taken.
        return make_look_at_camera(position, position - glm::normalize(glm::dvec3(world[2])),
                                   glm::normalize(glm::dvec3(world[1])), source.yfov, near_m,
                                   far_m);
    } catch (const InputError& error) {
        throw InputError(document.name("cameras", index), error.what());
    }
}

/// Frames that a clip needs, at least `least` and at most `most`.
int count_frames(double duration_s, double step_s, int least, int most, GltfWarnings& warnings) {
    const double frames = std::ceil(duration_s / step_s - 1e-6);
    if (frames > most) {
        warnings.insert("the walkthrough ends before the animation does, after " +
                        std::to_string(kMostFrames) + " frames");
        return std::max(most, 1);
    }
    return std::max(least, static_cast<int>(frames));
}

} // namespace

Walkthrough make_gltf_walkthrough(const GltfDocument& document, const GltfTree& tree,
                                  double duration_s, const Bounds& bounds, GltfWarnings& warnings) {
    Walkthrough walkthrough;
    const auto cameras = list_cameras(document, tree, warnings);
    if (cameras.empty()) {
        warnings.insert(
            "no perspective camera in the file: the walkthrough circles its bounding box");
        return make_orbit(bounds, count_frames(duration_s, walkthrough.step_s, kOrbitFrames,
                                               kMostFrames, warnings));
    }
    const bool moves = duration_s > 0.0;
    for (const auto& [index, node] : cameras) {
        const auto begin = static_cast<int>(walkthrough.cameras.size());
        if (begin >= kMostFrames) {
            warnings.insert("more cameras than " + std::to_string(kMostFrames) +
                            " frames have room for");
            break;
        }
        const int frames = count_frames(duration_s, walkthrough.step_s, kFramesPerCamera,
                                        kMostFrames - begin, warnings);
        walkthrough.cuts.push_back(begin);
        const Camera rest =
            make_camera(document, index, compute_nodes(tree.nodes, 0.0)[node], bounds);
        for (int frame = begin; frame < begin + frames; ++frame) {
            walkthrough.cameras.push_back(
                moves ? make_camera(document, index,
                                    compute_nodes(tree.nodes, wrap_time(frame * walkthrough.step_s,
                                                                        duration_s))[node],
                                    bounds)
                      : rest);
        }
    }
    return walkthrough;
}

} // namespace alcove
