#include "tests/test_scenes.hpp"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace alcove {

TestScene::TestScene(std::vector<Mesh> meshes, std::vector<glm::dmat4> transforms,
                     std::vector<Camera> cameras, double ao_radius_m, glm::dvec3 origin,
                     std::vector<ObjectStep> steps)
    : m_meshes(std::move(meshes)), m_transforms(std::move(transforms)), m_steps(std::move(steps)),
      m_ao_radius_m(ao_radius_m), m_origin(origin) {
    for (std::size_t i = 0; i < m_meshes.size(); ++i) {
        m_objects.push_back({m_meshes[i].name, i});
        m_transforms[i][3] += glm::dvec4(origin, 0.0);
    }
    for (Camera& camera : cameras) {
        camera.position += origin;
    }
    m_walkthrough.cameras = std::move(cameras);
    m_walkthrough.cuts = {0};
    m_lights.directional = {{glm::normalize(glm::dvec3(0.3, 1.0, 0.4)), glm::vec3(1.5f)}};
}

Pose TestScene::compute_pose(double time_s) const {
    Pose pose{m_transforms};
    const double frames = std::round(time_s / m_walkthrough.step_s);
    for (const ObjectStep& step : m_steps) {
        glm::dmat4& transform = pose.object_to_world.at(step.object);
        transform = glm::rotate(transform, frames * step.turn_radians, glm::dvec3(0.0, 1.0, 0.0));
        transform[3] += glm::dvec4(frames * step.translation, 0.0);
    }
    return pose;
}

Mesh make_quad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d) {
    Mesh mesh;
    mesh.name = "quad";
    mesh.positions = {a, b, c, d};
    mesh.normals.assign(4, glm::normalize(glm::cross(b - a, d - a)));
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

Mesh make_box(const glm::vec3& lo, const glm::vec3& hi) {
    Mesh box;
    box.name = "box";
    const auto add = [&box](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
                            const glm::vec3& d) {
        const Mesh quad = make_quad(a, b, c, d);
        const auto first = static_cast<std::uint32_t>(box.positions.size());
        box.positions.insert(box.positions.end(), quad.positions.begin(), quad.positions.end());
        box.normals.insert(box.normals.end(), quad.normals.begin(), quad.normals.end());
        for (const std::uint32_t index : quad.indices) {
            box.indices.push_back(first + index);
        }
    };
    add({lo.x, lo.y, hi.z}, {hi.x, lo.y, hi.z}, {hi.x, hi.y, hi.z}, {lo.x, hi.y, hi.z});
    add({hi.x, lo.y, lo.z}, {lo.x, lo.y, lo.z}, {lo.x, hi.y, lo.z}, {hi.x, hi.y, lo.z});
    add({hi.x, lo.y, hi.z}, {hi.x, lo.y, lo.z}, {hi.x, hi.y, lo.z}, {hi.x, hi.y, hi.z});
    add({lo.x, lo.y, lo.z}, {lo.x, lo.y, hi.z}, {lo.x, hi.y, hi.z}, {lo.x, hi.y, lo.z});
    add({lo.x, hi.y, hi.z}, {hi.x, hi.y, hi.z}, {hi.x, hi.y, lo.z}, {lo.x, hi.y, lo.z});
    add({lo.x, lo.y, lo.z}, {hi.x, lo.y, lo.z}, {hi.x, lo.y, hi.z}, {lo.x, lo.y, hi.z});
    return box;
}

Mesh make_sphere(const glm::vec3& center, float radius, int rings) {
    Mesh sphere;
    sphere.name = "sphere";
    const int columns = 2 * rings;
    for (int i = 0; i <= rings; ++i) {
        const double polar = std::numbers::pi * i / rings;
        for (int j = 0; j <= columns; ++j) {
            const double azimuth = 2.0 * std::numbers::pi * j / columns;
            const glm::vec3 n(std::sin(polar) * std::cos(azimuth), std::cos(polar),
                              -std::sin(polar) * std::sin(azimuth));
            sphere.normals.push_back(n);
            sphere.positions.push_back(center + radius * n);
        }
    }
    const auto index = [columns](int i, int j) {
        return static_cast<std::uint32_t>(i * (columns + 1) + j);
    };
    for (int i = 0; i < rings; ++i) {
        for (int j = 0; j < columns; ++j) {
            if (i > 0) {
                sphere.indices.insert(sphere.indices.end(),
                                      {index(i, j), index(i + 1, j), index(i, j + 1)});
            }
            if (i + 1 < rings) {
                sphere.indices.insert(sphere.indices.end(),
                                      {index(i, j + 1), index(i + 1, j), index(i + 1, j + 1)});
            }
        }
    }
    return sphere;
}

namespace {

Camera make_plane_camera() {
    return make_look_at_camera({0.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0},
                               std::numbers::pi / 3.0, 0.1, 1000.0);
}

} // namespace

TestScene make_plane_scene(double tilt_radians) {
    // Edge-on it would vanish behind the camera: 200 m to each side along the slope are cut at the
    // camera's plane.
    const glm::dvec3 center(0.0, 0.0, -5.0);
    const glm::dvec3 right(200.0, 0.0, 0.0);
    const glm::dvec3 up(0.0, std::cos(tilt_radians), -std::sin(tilt_radians));
    const auto corner = [&](double sx, double along) {
        return glm::vec3(center + sx * right + along * up);
    };
    return {{make_quad(corner(-1, -200), corner(1, -200), corner(1, 200), corner(-1, 200))},
            {glm::dmat4(1.0)},
            {make_plane_camera()},
            0.5};
}

double intersect_test_plane(const glm::dvec3& eye, const glm::dvec3& direction,
                            double tilt_radians) {
    const glm::dvec3 normal(0.0, std::sin(tilt_radians), std::cos(tilt_radians));
    return glm::dot(glm::dvec3(0.0, 0.0, -5.0) - eye, normal) / glm::dot(direction, normal);
}

TestScene make_box_scene(const glm::dvec3& origin) {
    std::vector<Mesh> meshes{
        make_quad({-6, 0, 6}, {6, 0, 6}, {6, 0, -6}, {-6, 0, -6}),
        make_box({-1.0f, -0.1f, -1.0f}, {0.2f, 1.2f, 0.2f}),
        make_box({0.1f, -0.1f, -0.6f}, {1.1f, 0.5f, 0.6f}),
        make_sphere({-0.6f, 0.45f, 0.9f}, 0.5f, 24),
        make_box({1.5f, -0.1f, 0.9f}, {1.56f, 1.5f, 0.96f}),
        // Leaves the image on the left, so that kernels reach over the border.
        make_box({-3.2f, -0.1f, -3.0f}, {-2.9f, 2.2f, 3.0f}),
    };
    const auto camera = [](const glm::dvec3& position) {
        return make_look_at_camera(position, {0.0, 0.5, 0.0}, {0.0, 1.0, 0.0},
                                   std::numbers::pi / 3.0, 0.1, 100.0);
    };
    std::vector<glm::dmat4> transforms(meshes.size(), glm::dmat4(1.0));
    constexpr std::size_t kLowBox = 2;
    // Clear of the floor within the frame, by less than the radius.
    return {std::move(meshes),
            std::move(transforms),
            {camera({1.5, 1.6, 3.6}), camera({1.6, 1.6, 3.55})},
            0.5,
            origin,
            {{kLowBox, {0.02, 0.2, 0.0}}}};
}

} // namespace alcove
