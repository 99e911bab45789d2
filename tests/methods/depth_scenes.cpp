#include "tests/methods/depth_scenes.hpp"

#include <cmath>
#include <random>

#include <glm/geometric.hpp>

namespace alcove {

void RayCaster::add_plane(const glm::dvec3& point, const glm::dvec3& normal) {
    const glm::dvec3 n = glm::normalize(normal);
    add_hit(glm::dot(point, n) / glm::dot(m_direction, n), n);
}

void RayCaster::add_sphere(const glm::dvec3& center, double radius) {
    const double a = glm::dot(m_direction, m_direction);
    const double b = glm::dot(m_direction, center);
    const double root = b * b - a * (glm::dot(center, center) - radius * radius);
    if (root > 0.0) {
        const double t = (b - std::sqrt(root)) / a;
        add_hit(t, (t * m_direction - center) / radius);
    }
}

void RayCaster::add_hit(double depth, const glm::dvec3& normal) {
    if (depth > 0.0 && depth < m_depth) {
        m_depth = depth;
        m_normal = normal;
    }
}

void write_hit(DepthImage& image, int x, int y, const RayCaster& ray) {
    image.depth.at(x, y) = static_cast<float>(ray.depth());
    for (int c = 0; c < 3; ++c) {
        image.normal.at(x, y, c) = static_cast<float>(ray.normal()[c]);
    }
}

DepthImage make_step_image() {
    DepthImage image = make_wall_image(kDepthSceneSize, 1.9f);
    for (int y = 0; y < kDepthSceneSize.height; ++y) {
        for (int x = kDepthSceneSize.width / 2; x < kDepthSceneSize.width; ++x) {
            RayCaster ray(
                compute_pixel_direction(image.camera, kDepthSceneSize, {x + 0.5, y + 0.5}));
            ray.add_plane({0.0, 0.0, -3.4}, {0.25, 0.15, 1.0});
            write_hit(image, x, y, ray);
        }
    }
    return image;
}

DepthImage make_corner_with_spheres_image() {
    DepthImage image = make_wall_image(kDepthSceneSize, 1.0f);
    for (int y = 0; y < kDepthSceneSize.height; ++y) {
        for (int x = 0; x < kDepthSceneSize.width; ++x) {
            RayCaster ray(
                compute_pixel_direction(image.camera, kDepthSceneSize, {x + 0.5, y + 0.5}));
            ray.add_plane({0.0, -1.1, -3.0}, {0.1, 1.0, 0.15});
            ray.add_plane({-0.3, 0.0, -3.6}, {0.5, 0.1, 1.0});
            ray.add_plane({1.4, 0.0, -3.0}, {-1.0, 0.05, 0.4});
            ray.add_sphere({-0.5, -0.5, -2.7}, 0.45);
            ray.add_sphere({0.6, 0.4, -2.4}, 0.3);
            write_hit(image, x, y, ray);
        }
    }
    return image;
}

DepthImage make_random_blocks_image() {
    DepthImage image = make_wall_image(kDepthSceneSize, 1.0f);
    std::minstd_rand random(7);
    const auto draw = [&random] { return static_cast<double>(random() % 10007u) / 10007.0; };
    for (int row = 0; row < kDepthSceneSize.height; row += 6) {
        for (int column = 0; column < kDepthSceneSize.width; column += 6) {
            const double depth = draw() < 1.0 / 7.0 ? INFINITY : 2.0 + 2.0 * draw();
            const glm::dvec3 n =
                glm::normalize(glm::dvec3(2.0 * draw() - 1.0, 2.0 * draw() - 1.0, 0.3 + draw()));
            const glm::dvec2 slope(0.1 * draw() - 0.05, 0.1 * draw() - 0.05);
            for (int y = row; y < row + 6; ++y) {
                for (int x = column; x < column + 6; ++x) {
                    image.depth.at(x, y) =
                        static_cast<float>(depth + slope.x * (x - column) + slope.y * (y - row));
                    for (int c = 0; c < 3; ++c) {
                        image.normal.at(x, y, c) = static_cast<float>(n[c]);
                    }
                }
            }
        }
    }
    return image;
}

DepthImage make_floor_and_wall_image(double wall_m) {
    const ImageSize size{192, 144};
    DepthImage image = make_wall_image(size, 1.0f);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            RayCaster ray(compute_pixel_direction(image.camera, size, {x + 0.5, y + 0.5}));
            ray.add_plane({0.0, 0.0, -3.0}, {0.0, 0.0, 1.0});
            ray.add_plane({wall_m, 0.0, 0.0}, {-1.0, 0.0, 0.0});
            write_hit(image, x, y, ray);
        }
    }
    return image;
}

} // namespace alcove
