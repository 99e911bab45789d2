#include "core/frame/reprojection.hpp"

#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

namespace alcove {
namespace {

constexpr float kDepthTolerance = 0.01f;
constexpr float kSeenTolerance = 0.02f;
constexpr float kNormalCosine = 0.9f;
/// Closer to a pixel's centre than this it is the centre: rounding of a camera that stands still.
constexpr float kSnapPixels = 1e-3f;

float snap_to_centre(float place) {
    const float centre = std::floor(place) + 0.5f;
    return std::abs(place - centre) < kSnapPixels ? centre : place;
}

glm::vec3 get_vector(const Image& image, int x, int y) {
    return {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)};
}

/// What became of one pixel's surface point.
struct Match {
    bool is_surface = false;
    bool is_seen = false;  ///< at least one pixel near the place shows it
    bool is_valid = false; ///< all of them do
    glm::vec2 place{0.0f}; ///< pixels of the earlier image
};

/// Finds each pixel's place in the earlier image and what stood there.
class PixelMatcher {
  public:
    PixelMatcher(const FrameView& view, const SurfaceImages& now, const SurfaceImages& before)
        : m_now(now), m_before(before), m_size(view.size),
          m_tangents(compute_tangents(view.camera, view.size)) {
        const Reprojection exact = make_reprojection(view);
        m_previous_from_view = glm::mat3(exact.previous_from_view);
        m_previous_from_world = glm::mat3(exact.previous_from_world);
        m_offset = glm::vec3(exact.previous_offset);
        m_previous_tangents = glm::vec2(exact.previous_tangents);
    }

    [[nodiscard]] Match match(int x, int y) const {
        Match match;
        const float depth = m_now.eye_depth.at(x, y);
        if (std::isinf(depth)) {
            return match;
        }
        match.is_surface = true;
        const glm::vec2 size(m_size.width, m_size.height);
        const glm::vec2 centre(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
        const glm::vec3 position = depth * make_ray(centre, m_tangents);
        const glm::vec3 old = m_previous_from_view * position + m_offset +
                              m_previous_from_world * get_vector(m_now.motion, x, y);
        if (!(old.z < 0.0f)) {
            return match;
        }
        match.place = {
            snap_to_centre(size.x * (0.5f - 0.5f * old.x / (old.z * m_previous_tangents.x))),
            snap_to_centre(size.y * (0.5f + 0.5f * old.y / (old.z * m_previous_tangents.y)))};
        if (match.place.x >= 0.0f && match.place.y >= 0.0f && match.place.x <= size.x &&
            match.place.y <= size.y) {
            compare(x, y, old, match);
        }
        return match;
    }

  private:
    /// View-space position at depth 1 of a place in pixels, y down.
    [[nodiscard]] glm::vec3 make_ray(const glm::vec2& place, const glm::vec2& tangents) const {
        return {(2.0f * place.x / static_cast<float>(m_size.width) - 1.0f) * tangents.x,
                (1.0f - 2.0f * place.y / static_cast<float>(m_size.height)) * tangents.y, -1.0f};
    }

    void compare(int x, int y, const glm::vec3& old, Match& match) const {
        const float left = match.place.x - 0.5f;
        const float top = match.place.y - 0.5f;
        const int x0 = static_cast<int>(std::floor(left));
        const int y0 = static_cast<int>(std::floor(top));
        const float fx = left - static_cast<float>(x0);
        const float fy = top - static_cast<float>(y0);
        const float id = m_now.instance_id.at(x, y);
        const glm::vec3 expected_normal = m_previous_from_view * get_vector(m_now.normal, x, y);
        const float plane = glm::dot(expected_normal, old);
        float inverse_depth = 0.0f;
        glm::vec3 normal(0.0f);
        bool all_same = true;
        for (int tap = 0; tap < 4; ++tap) {
            const int dx = tap % 2;
            const int dy = tap / 2;
            const float weight = (dx != 0 ? fx : 1.0f - fx) * (dy != 0 ? fy : 1.0f - fy);
            if (weight == 0.0f) {
                continue;
            }
            const int tap_x = x0 + dx;
            const int tap_y = y0 + dy;
            if (!is_inside(tap_x, tap_y) || m_before.instance_id.at(tap_x, tap_y) != id) {
                all_same = false;
                continue;
            }
            inverse_depth += weight / m_before.eye_depth.at(tap_x, tap_y);
            normal += weight * get_vector(m_before.normal, tap_x, tap_y);
        }
        match.is_valid = all_same && std::abs(1.0f + old.z * inverse_depth) < kDepthTolerance &&
                         glm::dot(expected_normal, normal) >
                             kNormalCosine * glm::length(expected_normal) * glm::length(normal);
        match.is_seen = match.is_valid;
        // The nearest pixel and those around it: a sliver that an edge gains by moving a fraction
        // of a pixel has not come into view.
        const int nearest_x = static_cast<int>(std::floor(match.place.x));
        const int nearest_y = static_cast<int>(std::floor(match.place.y));
        for (int tap = 0; tap < 9 && !match.is_seen; ++tap) {
            match.is_seen = shows_surface(nearest_x - 1 + tap % 3, nearest_y - 1 + tap / 3, id,
                                          expected_normal, plane);
        }
    }

    [[nodiscard]] bool is_inside(int x, int y) const {
        return x >= 0 && y >= 0 && x < m_size.width && y < m_size.height;
    }

    /// Does the earlier image show the same object where the point's tangent plane, n . p = plane,
    /// lies?
    [[nodiscard]] bool shows_surface(int x, int y, float id, const glm::vec3& normal,
                                     float plane) const {
        if (!is_inside(x, y) || m_before.instance_id.at(x, y) != id) {
            return false;
        }
        const glm::vec2 centre(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
        const float inverse_depth = glm::dot(normal, make_ray(centre, m_previous_tangents)) / plane;
        return std::abs(1.0f - inverse_depth * m_before.eye_depth.at(x, y)) < kSeenTolerance;
    }

    const SurfaceImages& m_now;
    const SurfaceImages& m_before;
    ImageSize m_size;
    glm::vec2 m_tangents;
    glm::mat3 m_previous_from_view{1.0f};
    glm::mat3 m_previous_from_world{1.0f};
    glm::vec3 m_offset{0.0f};
    glm::vec2 m_previous_tangents{1.0f};
};

/// 1 where the pixel and its neighbours inside the image are 1.
Image erode(const Image& mask) {
    Image rows = mask;
    for (int y = 0; y < mask.height(); ++y) {
        for (int x = 0; x < mask.width(); ++x) {
            const bool left = x == 0 || mask.at(x - 1, y) != 0.0f;
            const bool right = x + 1 == mask.width() || mask.at(x + 1, y) != 0.0f;
            rows.at(x, y) = left && right ? mask.at(x, y) : 0.0f;
        }
    }
    Image eroded = rows;
    for (int y = 0; y < mask.height(); ++y) {
        for (int x = 0; x < mask.width(); ++x) {
            const bool above = y == 0 || rows.at(x, y - 1) != 0.0f;
            const bool below = y + 1 == mask.height() || rows.at(x, y + 1) != 0.0f;
            eroded.at(x, y) = above && below ? rows.at(x, y) : 0.0f;
        }
    }
    return eroded;
}

} // namespace

Reprojection make_reprojection(const FrameView& view) {
    Reprojection reprojection;
    reprojection.previous_from_world = glm::transpose(view.previous_camera.world_from_view);
    reprojection.previous_from_view =
        reprojection.previous_from_world * view.camera.world_from_view;
    reprojection.previous_offset =
        reprojection.previous_from_world * (view.camera.position - view.previous_camera.position);
    reprojection.previous_tangents = compute_tangents(view.previous_camera, view.size);
    // A camera that stands still must reproject without rounding: R^T R is not the identity bit for
    // bit.
    if (view.previous_camera.world_from_view == view.camera.world_from_view) {
        reprojection.previous_from_view = glm::dmat3(1.0);
    }
    return reprojection;
}

glm::dvec3 reproject(const Reprojection& reprojection, const glm::dvec3& position,
                     const glm::dvec3& motion) {
    return reprojection.previous_from_view * position + reprojection.previous_offset +
           reprojection.previous_from_world * motion;
}

std::optional<glm::dvec2> project_previous(const Reprojection& reprojection,
                                           const glm::dvec3& previous_position) {
    if (!(previous_position.z < 0.0)) {
        return std::nullopt;
    }
    const glm::dvec2 tangents = reprojection.previous_tangents;
    return glm::dvec2{0.5 - 0.5 * previous_position.x / (previous_position.z * tangents.x),
                      0.5 + 0.5 * previous_position.y / (previous_position.z * tangents.y)};
}

void set_reprojection_uniforms(const gl::Functions& gl, const gl::Program& program,
                               const Reprojection& reprojection) {
    const glm::mat3 from_view(reprojection.previous_from_view);
    const glm::mat3 from_world(reprojection.previous_from_world);
    const glm::vec3 offset(reprojection.previous_offset);
    const glm::vec2 tangents(reprojection.previous_tangents);
    gl.UniformMatrix3fv(program.location("previous_from_view"), 1, GL_FALSE,
                        glm::value_ptr(from_view));
    gl.UniformMatrix3fv(program.location("previous_from_world"), 1, GL_FALSE,
                        glm::value_ptr(from_world));
    gl.Uniform3f(program.location("previous_offset"), offset.x, offset.y, offset.z);
    gl.Uniform2f(program.location("previous_tangents"), tangents.x, tangents.y);
}

Correspondence make_correspondence(const FrameView& view, const SurfaceImages& now,
                                   const SurfaceImages& before) {
    const ImageSize size = view.size;
    ALCOVE_ASSERT(now.eye_depth.size() == size && before.eye_depth.size() == size,
                  "surfaces of the frame's size");
    Correspondence correspondence{Image(size, 2), Image(size, 1), Image(size, 1)};
    const PixelMatcher matcher(view, now, before);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const Match match = matcher.match(x, y);
            const bool is_seen = match.is_seen && view.history_valid;
            correspondence.position.at(x, y, 0) = match.place.x;
            correspondence.position.at(x, y, 1) = match.place.y;
            correspondence.valid.at(x, y) = match.is_valid && is_seen ? 1.0f : 0.0f;
            correspondence.appeared.at(x, y) = match.is_surface && !is_seen ? 1.0f : 0.0f;
        }
    }
    correspondence.valid = erode(correspondence.valid);
    return correspondence;
}

} // namespace alcove
