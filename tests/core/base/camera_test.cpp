#include "core/base/camera.hpp"

#include "core/base/error.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace alcove {
namespace {

Camera make_camera() {
    return make_look_at_camera({1.0, 2.0, 3.0}, {4.0, 1.0, -2.0}, {0.0, 1.0, 0.0}, 1.0, 0.1, 50.0);
}

TEST(Camera, LooksAtItsTarget) {
    const glm::dmat4 view = compute_view_from_object(make_camera(), glm::dmat4(1.0));
    const glm::dvec4 target = view * glm::dvec4(4.0, 1.0, -2.0, 1.0);
    EXPECT_NEAR(target.x, 0.0, 1e-12);
    EXPECT_NEAR(target.y, 0.0, 1e-12);
    EXPECT_NEAR(target.z, -std::sqrt(35.0), 1e-12);
}

TEST(Camera, PixelDirectionsAgreeWithTheProjection) {
    const Camera camera = make_camera();
    const ImageSize size{320, 200};
    for (const bool reversed : {false, true}) {
        const glm::dmat4 clip = compute_projection(camera, size, reversed) *
                                compute_view_from_object(camera, glm::dmat4(1.0));
        const glm::dvec2 pixel(37.5, 150.25);
        const glm::dvec3 point =
            camera.position + 7.0 * compute_pixel_direction(camera, size, pixel);
        const glm::dvec4 projected = clip * glm::dvec4(point, 1.0);
        EXPECT_NEAR(projected.w, 7.0, 1e-12);
        EXPECT_NEAR((projected.x / projected.w + 1.0) * 160.0, pixel.x, 1e-9);
        EXPECT_NEAR((1.0 - projected.y / projected.w) * 100.0, pixel.y, 1e-9);
    }
}

TEST(Camera, DepthRunsFromNearToFar) {
    const Camera camera = make_camera();
    const auto depth = [&](double distance, bool reversed) {
        const glm::dvec4 clip =
            compute_projection(camera, {1, 1}, reversed) * glm::dvec4(0.0, 0.0, -distance, 1.0);
        return clip.z / clip.w;
    };
    EXPECT_NEAR(depth(0.1, false), -1.0, 1e-12);
    EXPECT_NEAR(depth(50.0, false), 1.0, 1e-12);
    EXPECT_NEAR(depth(0.1, true), 1.0, 1e-12);
    EXPECT_NEAR(depth(50.0, true), 0.0, 1e-12);
}

TEST(Camera, AWorldFarFromZeroLosesNothing) {
    const glm::dvec3 offset(1e7, -1e7, 1e7);
    Camera moved = make_camera();
    moved.position += offset;
    glm::dmat4 object(1.0);
    object[3] = glm::dvec4(offset, 1.0);
    const glm::dmat4 near_zero = compute_view_from_object(make_camera(), glm::dmat4(1.0));
    const glm::dmat4 far_away = compute_view_from_object(moved, object);
    for (int column = 0; column < 4; ++column) {
        // 1e7 in double has steps of 2e-9 m.
        EXPECT_LT(glm::length(near_zero[column] - far_away[column]), 1e-8);
    }
}

TEST(Camera, NonsenseIsAnError) {
    const glm::dvec3 up(0.0, 1.0, 0.0);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto make = [&](glm::dvec3 position, glm::dvec3 target, double fov, double n, double f) {
        return [=] { static_cast<void>(make_look_at_camera(position, target, up, fov, n, f)); };
    };
    const glm::dvec3 a(0.0);
    const glm::dvec3 b(0.0, 0.0, -1.0);
    EXPECT_THROW(make(a, a, 1.0, 0.1, 1.0)(), InputError);
    EXPECT_THROW(make(a, up, 1.0, 0.1, 1.0)(), InputError);
    EXPECT_THROW(make(a, {nan, 0.0, 0.0}, 1.0, 0.1, 1.0)(), InputError);
    EXPECT_THROW(make(a, b, 0.0, 0.1, 1.0)(), InputError);
    EXPECT_THROW(make(a, b, std::numbers::pi, 0.1, 1.0)(), InputError);
    EXPECT_THROW(make(a, b, 1.0, 0.0, 1.0)(), InputError);
    EXPECT_THROW(make(a, b, 1.0, 1.0, 1.0)(), InputError);
}

} // namespace
} // namespace alcove
