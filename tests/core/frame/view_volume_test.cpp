#include "core/frame/view_volume.hpp"

#include <random>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace alcove {
namespace {

constexpr ImageSize kSize{160, 90};

Camera make_camera() {
    return make_look_at_camera({3.0, 2.0, 5.0}, {0.0, 1.0, -4.0}, {0.0, 1.0, 0.0}, 1.0, 0.1, 40.0);
}

/// The pixel, rows from the bottom, and the eye depth of a point; nothing if it is not in the view.
std::optional<glm::dvec3> look_at(const Camera& camera, const glm::dvec3& point) {
    const glm::dvec3 view = glm::transpose(camera.world_from_view) * (point - camera.position);
    const glm::dvec2 tangents = compute_tangents(camera, kSize);
    const double depth = -view.z;
    const glm::dvec2 place = glm::dvec2(view) / (depth * tangents);
    if (depth < camera.near_m || depth > camera.far_m || std::abs(place.x) > 1.0 ||
        std::abs(place.y) > 1.0) {
        return std::nullopt;
    }
    return glm::dvec3((0.5 * place.x + 0.5) * kSize.width, (0.5 * place.y + 0.5) * kSize.height,
                      depth);
}

TEST(ViewVolumeTest, NoBoxWithAPointInTheImageIsLeftOutAndItsBoundsHoldThePoint) {
    const Camera camera = make_camera();
    const ViewVolume volume(camera, kSize);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    int shown = 0;
    int left_out = 0;
    int bounded = 0;
    for (int i = 0; i < 4000; ++i) {
        glm::dmat4 placing = glm::translate(
            glm::dmat4(1.0), 14.0 * glm::dvec3(unit(random), unit(random), unit(random)));
        placing = glm::rotate(placing, 3.0 * unit(random),
                              glm::normalize(glm::dvec3(unit(random), 1.1, unit(random))));
        const glm::vec3 high(0.1 + std::abs(unit(random)), 0.1 + std::abs(unit(random)), 2.0);
        const OrientedBox box = place_box(-high, high, placing);
        bool sees = false;
        const std::optional<ScreenBounds> bounds = volume.project(box);
        for (int k = 0; k < 60; ++k) {
            const glm::dvec3 inside(unit(random), unit(random), unit(random));
            const auto seen = look_at(camera, box.centre + box.half * inside);
            sees = sees || seen.has_value();
            if (seen && bounds) {
                EXPECT_GE(seen->x, bounds->left);
                EXPECT_LE(seen->x, bounds->right + 1.0);
                EXPECT_GE(seen->y, bounds->bottom);
                EXPECT_LE(seen->y, bounds->top + 1.0);
                EXPECT_GE(seen->z, bounds->nearest_m);
            }
            if (volume.is_beyond_near(box)) {
                const glm::dvec3 point = box.centre + box.half * inside;
                EXPECT_GT(-(glm::transpose(camera.world_from_view) * (point - camera.position)).z,
                          camera.near_m);
            }
        }
        if (sees) {
            EXPECT_TRUE(volume.may_show(box));
        }
        shown += sees ? 1 : 0;
        bounded += sees && bounds ? 1 : 0;
        left_out += volume.may_show(box) ? 0 : 1;
    }
    // The test says something only if boxes of all kinds took part.
    EXPECT_GT(shown, 300);
    EXPECT_GT(bounded, 250);
    EXPECT_GT(left_out, 2000);
}

} // namespace
} // namespace alcove
