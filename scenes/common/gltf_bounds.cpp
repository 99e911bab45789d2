#include "core/base/error.hpp"
#include "core/base/text.hpp"
#include "scenes/common/gltf_objects.hpp"

#include <algorithm>

#include <glm/common.hpp>

namespace alcove {
namespace {

constexpr double kFarthestMetres = 1e9;
constexpr int kTimes = 16;

Bounds measure_points(const std::vector<glm::vec3>& points) {
    Bounds bounds;
    for (const glm::vec3& point : points) {
        bounds.add(glm::dvec3(point));
    }
    return bounds;
}

} // namespace

Bounds measure_bounds(const GltfDocument& document, const GltfTree& tree,
                      const AnimatedSceneContent& content, double duration_s) {
    std::vector<Bounds> meshes;
    for (const Mesh& mesh : content.meshes) {
        meshes.push_back(measure_points(mesh.positions));
    }
    Bounds bounds;
    const int times = content.is_at_rest ? 1 : kTimes;
    for (int i = 0; i < times; ++i) {
        const double time_s = duration_s * i / times;
        const std::vector<glm::dmat4> nodes = content.nodes(time_s);
        for (std::size_t k = 0; k < content.objects.size(); ++k) {
            const AnimatedObject& object = content.objects[k];
            const bool deforms = object.object.motion == ObjectMotion::deforming;
            if (i > 0 && object.object.motion == ObjectMotion::still) {
                continue;
            }
            bounds.add(deforms ? measure_points(deform_object(content, k, nodes, time_s).positions)
                               : meshes[object.object.mesh],
                       object.skin ? glm::dmat4(1.0) : nodes[object.node]);
            const glm::dvec3 reach = glm::max(glm::abs(bounds.low), glm::abs(bounds.high));
            if (!(std::max({reach.x, reach.y, reach.z}) <= kFarthestMetres)) {
                throw InputError(tree.name(document, object.node), "lies too far out", {},
                                 "coordinates of at most " + format_number(kFarthestMetres) + " m");
            }
        }
    }
    return bounds;
}

} // namespace alcove
