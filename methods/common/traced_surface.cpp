#include "methods/common/traced_surface.hpp"

#include <algorithm>
#include <cmath>

#include <embree3/rtcore.h>
#include <glm/geometric.hpp>

namespace alcove {
namespace {

/// Moves the point off the planes that the vertex normals span, so that shading normals do not
/// start rays below facets that are only facets. This work is based on: Hanika. Hacking the shadow
/// terminator. Ray Tracing Gems II. 2021.
glm::vec3 lift_off_terminator(const TracedSurface& surface, float side) {
    glm::vec3 lifted = surface.point;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::vec3 normal = side * surface.triangle.normals[i];
        const float below =
            std::min(0.0f, glm::dot(surface.point - surface.triangle.corners[i], normal));
        lifted -= surface.barycentric[i] * below * normal;
    }
    return lifted;
}

} // namespace

float compute_lift(const glm::vec3& point, float farthest) {
    return 0x1p-18f * std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z), farthest});
}

TracedSurface find_surface(const TracedTriangle& triangle, float u, float v,
                           const glm::vec3& direction, float distance, const SurfaceRules& rules) {
    const std::array<glm::vec3, 3>& corners = triangle.corners;
    TracedSurface surface{glm::vec3(0.0f), glm::vec3(0.0f), glm::vec3(0.0f), triangle, {}};
    surface.barycentric = {1.0f - u - v, u, v};
    for (std::size_t i = 0; i < 3; ++i) {
        surface.point += surface.barycentric[i] * corners[i];
        surface.normal += surface.barycentric[i] * triangle.normals[i];
    }
    glm::vec3 geometric =
        glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    // Counter-clockwise is the front, as for the rasteriser: seen from behind, both normals turn
    // over.
    const float side = glm::dot(geometric, direction) > 0.0f ? -1.0f : 1.0f;
    geometric *= side;
    const bool uses_shading = rules.normals == Normals::shading;
    surface.normal = uses_shading ? side * glm::normalize(surface.normal) : geometric;
    const glm::vec3 start =
        uses_shading && rules.terminator_safe ? lift_off_terminator(surface, side) : surface.point;
    surface.origin = start + geometric * compute_lift(start, distance);
    return surface;
}

std::optional<TracedSurface> find_seen_surface(const TracedScene& scene, const glm::vec3& eye,
                                               const glm::vec3& direction, const Camera& camera,
                                               const SurfaceRules& rules) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit query{};
    query.ray.org_x = eye.x;
    query.ray.org_y = eye.y;
    query.ray.org_z = eye.z;
    query.ray.dir_x = direction.x;
    query.ray.dir_y = direction.y;
    query.ray.dir_z = direction.z;
    // The direction has unit length along the view axis: ray distances are eye depths.
    query.ray.tnear = static_cast<float>(camera.near_m);
    query.ray.tfar = static_cast<float>(camera.far_m);
    query.ray.mask = 0xffffffffu;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene.top(), &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
        return std::nullopt;
    }
    return find_surface(
        scene.get_triangle({query.hit.instID[0], query.hit.geomID, query.hit.primID}), query.hit.u,
        query.hit.v, direction, query.ray.tfar, rules);
}

} // namespace alcove
