#include "core/frame/gbuffer_part.hpp"

#include "core/base/assert.hpp"
#include "core/frame/view_volume.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace alcove {
namespace {

Camera displace(const Camera& camera, const ExtraView& extra, const BoundingSphere& scene) {
    const glm::dvec3 forward = -camera.world_from_view[2];
    const double ahead = std::max(glm::dot(scene.centre - camera.position, forward),
                                  std::max(0.1 * scene.radius_m, 2.0 * camera.near_m));
    const glm::dvec3 target = camera.position + ahead * forward;
    const glm::dvec3 shift = camera.world_from_view * (extra.displacement * scene.radius_m);
    return make_look_at_camera(camera.position + shift, target, camera.world_from_view[1],
                               camera.fov_y_radians, camera.near_m,
                               camera.far_m + glm::length(shift));
}

} // namespace

bool operator<(const GBufferPart& a, const GBufferPart& b) {
    const auto key = [](const GBufferPart& part) {
        const glm::dvec3& shift = part.view.displacement;
        return std::tuple(part.kind, part.index, shift.x, shift.y, shift.z, part.view.resolution);
    };
    return key(a) < key(b);
}

std::string to_text(const GBufferPart& part) {
    switch (part.kind) {
    case PartKind::nearest:
        return {};
    case PartKind::layer:
        return "layer" + std::to_string(part.index);
    case PartKind::back_faces:
        return "back_faces";
    case PartKind::view:
        return "view" + std::to_string(part.index);
    case PartKind::multisampled:
        break;
    }
    return "msaa" + std::to_string(part.index);
}

BoundingSphere compute_bounding_sphere(const Scene& scene) {
    glm::dvec3 low(std::numeric_limits<double>::infinity());
    glm::dvec3 high(-std::numeric_limits<double>::infinity());
    std::vector<std::pair<glm::vec3, glm::vec3>> boxes;
    for (const Mesh& mesh : scene.get_meshes()) {
        boxes.emplace_back(mesh.positions.front(), mesh.positions.front());
        for (const glm::vec3& position : mesh.positions) {
            boxes.back().first = glm::min(boxes.back().first, position);
            boxes.back().second = glm::max(boxes.back().second, position);
        }
    }
    const Pose pose = scene.compute_pose(0.0);
    for (std::size_t i = 0; i < pose.object_to_world.size(); ++i) {
        const auto& [box_low, box_high] = boxes[scene.get_objects()[i].mesh];
        const OrientedBox box = place_box(box_low, box_high, pose.object_to_world[i]);
        const glm::dvec3 reach =
            glm::abs(box.half[0]) + glm::abs(box.half[1]) + glm::abs(box.half[2]);
        low = glm::min(low, box.centre - reach);
        high = glm::max(high, box.centre + reach);
    }
    return {0.5 * (low + high), 0.5 * glm::distance(low, high)};
}

ImageSize get_part_size(const GBufferPart& part, ImageSize size, const Border& border) {
    const auto shrink = [&part](int side) {
        return std::max(1, static_cast<int>(std::lround(side * part.view.resolution)));
    };
    switch (part.kind) {
    case PartKind::view:
        ALCOVE_ASSERT(part.view.resolution > 0.0 && part.view.resolution <= 1.0,
                      "a resolution in (0, 1]");
        return {shrink(size.width), shrink(size.height)};
    case PartKind::multisampled:
        return size;
    default:
        return {size.width + 2 * border.x, size.height + 2 * border.y};
    }
}

FrameView make_part_view(const GBufferPart& part, const FrameView& view, const Border& border,
                         const BoundingSphere& scene) {
    if (part.kind == PartKind::multisampled) {
        return view;
    }
    if (part.kind != PartKind::view) {
        // The camera without border is the walkthrough's own, free of rounding.
        return border == Border{} ? view : extend(view, border);
    }
    FrameView placed = view;
    placed.camera = displace(view.camera, part.view, scene);
    placed.previous_camera = displace(view.previous_camera, part.view, scene);
    placed.size = get_part_size(part, view.size, border);
    return placed;
}

} // namespace alcove
