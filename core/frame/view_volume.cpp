#include "core/frame/view_volume.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace alcove {
namespace {

/// Vertices reach the GPU through one float matrix: a handful of roundings of 2^-24, relative to
/// the distances that take part, and as many again in the projection.
constexpr double kRelativeMargin = 1e-5;
constexpr double kAbsoluteMarginM = 1e-6;

} // namespace

OrientedBox place_box(const glm::vec3& low, const glm::vec3& high,
                      const glm::dmat4& world_from_object) {
    const glm::dvec3 centre = 0.5 * (glm::dvec3(low) + glm::dvec3(high));
    const glm::dvec3 half = 0.5 * (glm::dvec3(high) - glm::dvec3(low));
    OrientedBox box;
    box.centre = glm::dvec3(world_from_object * glm::dvec4(centre, 1.0));
    for (int i = 0; i < 3; ++i) {
        box.half[i] = half[i] * glm::dvec3(world_from_object[i]);
    }
    return box;
}

ViewVolume::ViewVolume(const Camera& camera, ImageSize size)
    : m_camera(camera), m_size(size), m_tangents(compute_tangents(camera, size)) {}

ViewVolume::ViewBox ViewVolume::to_view(const OrientedBox& box) const {
    const glm::dmat3 view_from_world = glm::transpose(m_camera.world_from_view);
    ViewBox view{view_from_world * (box.centre - m_camera.position), view_from_world * box.half,
                 0.0};
    const double reach = glm::length(view.centre) + glm::length(view.half[0]) +
                         glm::length(view.half[1]) + glm::length(view.half[2]);
    view.margin = kRelativeMargin * reach + kAbsoluteMarginM;
    return view;
}

bool ViewVolume::may_show(const OrientedBox& box) const {
    const ViewBox view = to_view(box);
    // A plane with normal n and offset d holds the box outside if even the point farthest along n
    // lies behind it.
    const auto reaches = [&view](const glm::dvec3& n, double offset) {
        const double radius = std::abs(glm::dot(n, view.half[0])) +
                              std::abs(glm::dot(n, view.half[1])) +
                              std::abs(glm::dot(n, view.half[2]));
        return glm::dot(n, view.centre) + radius + offset >= -view.margin * glm::length(n);
    };
    return reaches({0.0, 0.0, -1.0}, -m_camera.near_m) &&
           reaches({0.0, 0.0, 1.0}, m_camera.far_m) && reaches({1.0, 0.0, -m_tangents.x}, 0.0) &&
           reaches({-1.0, 0.0, -m_tangents.x}, 0.0) && reaches({0.0, 1.0, -m_tangents.y}, 0.0) &&
           reaches({0.0, -1.0, -m_tangents.y}, 0.0);
}

bool ViewVolume::is_beyond_near(const OrientedBox& box) const {
    const ViewBox view = to_view(box);
    const double radius =
        std::abs(view.half[0].z) + std::abs(view.half[1].z) + std::abs(view.half[2].z);
    return -view.centre.z - radius > m_camera.near_m + view.margin;
}

std::optional<ScreenBounds> ViewVolume::project(const OrientedBox& box) const {
    const ViewBox view = to_view(box);
    glm::dvec2 low(std::numeric_limits<double>::infinity());
    glm::dvec2 high(-std::numeric_limits<double>::infinity());
    double nearest = std::numeric_limits<double>::infinity();
    for (unsigned corner = 0; corner < 8; ++corner) {
        glm::dvec3 point = view.centre;
        for (unsigned axis = 0; axis < 3; ++axis) {
            point += ((corner >> axis & 1u) != 0 ? 1.0 : -1.0) * view.half[static_cast<int>(axis)];
        }
        const double depth = -point.z;
        if (depth <= m_camera.near_m + view.margin) {
            return std::nullopt;
        }
        const glm::dvec2 place(point.x / (depth * m_tangents.x), point.y / (depth * m_tangents.y));
        low = glm::dvec2(std::min(low.x, place.x), std::min(low.y, place.y));
        high = glm::dvec2(std::max(high.x, place.x), std::max(high.y, place.y));
        nearest = std::min(nearest, depth);
    }
    // A pixel more on each side: rounding moves a projected point by less than that.
    const auto to_pixel = [](double place, int count) {
        return static_cast<int>(
            std::floor(std::clamp((0.5 * place + 0.5) * count, -2.0, count + 2.0)));
    };
    const ScreenBounds bounds{std::max(to_pixel(low.x, m_size.width) - 1, 0),
                              std::max(to_pixel(low.y, m_size.height) - 1, 0),
                              std::min(to_pixel(high.x, m_size.width) + 1, m_size.width - 1),
                              std::min(to_pixel(high.y, m_size.height) + 1, m_size.height - 1),
                              nearest - view.margin};
    if (bounds.left > bounds.right || bounds.bottom > bounds.top) {
        return std::nullopt;
    }
    return bounds;
}

} // namespace alcove
