#include "tests/methods/traced_light_rig.hpp"

#include "tests/test_scenes.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>

namespace alcove {

LitScene::LitScene(std::vector<Mesh> meshes, std::vector<Texture> textures, glm::dvec3 origin)
    : m_meshes(std::move(meshes)), m_textures(std::move(textures)), m_origin(origin) {
    for (std::size_t i = 0; i < m_meshes.size(); ++i) {
        m_objects.push_back({m_meshes[i].name, i, ObjectMotion::still});
    }
    m_walkthrough.cameras.push_back(make_forward_camera());
}

Pose LitScene::compute_pose(double /*time_s*/) const {
    return {std::vector<glm::dmat4>(m_meshes.size(), glm::translate(glm::dmat4(1.0), m_origin))};
}

Camera make_forward_camera() {
    return make_look_at_camera({0.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0},
                               std::numbers::pi / 3.0, 0.1, 1000.0);
}

Camera make_camera_above_zero(double y) {
    return make_look_at_camera({0.0, y, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, -1.0},
                               std::numbers::pi / 180.0, 0.01, 1000.0);
}

Lights make_surroundings(const glm::vec3& radiance) {
    Lights lights;
    lights.ambient = radiance;
    return lights;
}

Mesh paint(Mesh mesh, const glm::vec3& albedo) {
    mesh.albedo = albedo;
    return mesh;
}

Mesh make_wall(float half, float z) {
    return make_quad({-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z});
}

Mesh make_floor(float half, float y) {
    return make_quad({-half, y, half}, {half, y, half}, {half, y, -half}, {-half, y, -half});
}

Mesh make_ceiling(float half, float y) {
    return make_quad({-half, y, -half}, {half, y, -half}, {half, y, half}, {-half, y, half});
}

TracedRadiance trace_light(const Scene& scene, const Camera& camera, const Lights& lights,
                           const PathSettings& settings) {
    PathTracer tracer;
    tracer.update(pose_geometry(scene, 0.0));
    return tracer.trace(camera, kTracedSize, lights, settings);
}

glm::vec3 get_pixel(const Image& image, int x, int y) {
    return {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)};
}

glm::dvec3 compute_average(const Image& image) {
    glm::dvec3 sum(0.0);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            sum += glm::dvec3(get_pixel(image, x, y));
        }
    }
    return sum / static_cast<double>(image.size().pixel_count());
}

float find_largest_difference(const Image& a, const Image& b) {
    float largest = 0.0f;
    for (std::size_t i = 0; i < a.values().size(); ++i) {
        largest = std::max(largest, std::abs(a.values()[i] - b.values()[i]));
    }
    return largest;
}

} // namespace alcove
