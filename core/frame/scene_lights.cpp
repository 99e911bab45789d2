#include "core/frame/scene_lights.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/matrix.hpp>

namespace alcove {
namespace {

constexpr std::size_t kMostLights = kMostDirectionalLights + kMostPointLights;
constexpr std::size_t kFacesOfCube = 6;
constexpr std::size_t kMostFaces = kMostDirectionalLights + kFacesOfCube * kMostPointLights;
constexpr GLuint kBlockBinding = 2;
constexpr GLuint kAtlasUnit = 2;
/// Texels a side: of up to four faces, and of more, for which the atlas would be too large.
constexpr int kFineSide = 2048;
constexpr int kCoarseSide = 1024;
constexpr std::size_t kMostFineFaces = 4;

void check_count(std::size_t count, std::size_t most, const char* what) {
    if (count > most) {
        throw InputError("scene", std::string("too many ") + what + " lights",
                         std::to_string(count), "at most " + std::to_string(most));
    }
}

void push(std::vector<float>& block, const glm::dvec3& value, double w) {
    for (int i = 0; i < 3; ++i) {
        block.push_back(static_cast<float>(value[i]));
    }
    block.push_back(static_cast<float>(w));
}

} // namespace

SceneLights::SceneLights(const gl::Functions& gl, const Scene& scene)
    : m_gl(gl), m_sphere(compute_bounding_sphere(scene)) {
    check_count(scene.get_lights().directional.size(), kMostDirectionalLights, "directional");
    check_count(scene.get_lights().points.size(), kMostPointLights, "point and spot");
}

void SceneLights::set_time(const Scene& scene, double time_s) {
    if (m_time_s == time_s) {
        return;
    }
    m_time_s = time_s;
    m_lights = scene.compute_lights(time_s);
    m_faces.clear();
    m_first_faces.clear();
    const auto add = [this](bool casts_shadow, auto&& views) {
        m_first_faces.push_back(casts_shadow ? static_cast<int>(m_faces.size()) : -1);
        if (casts_shadow) {
            for (const LightView& view : views) {
                m_faces.push_back({view, 0, 0});
            }
        }
    };
    for (const DirectionalLight& light : m_lights.directional) {
        add(light.casts_shadow, std::array{look_along(light, m_sphere)});
    }
    for (const PointLight& light : m_lights.points) {
        if (light.cone) {
            add(light.casts_shadow, std::array{look_along(light, m_sphere)});
        } else {
            add(light.casts_shadow, look_around(light, m_sphere));
        }
    }
    m_is_stale = !m_faces.empty();
    if (m_faces.empty()) {
        return;
    }
    m_side = m_faces.size() <= kMostFineFaces ? kFineSide : kCoarseSide;
    m_columns = static_cast<int>(std::ceil(std::sqrt(double(m_faces.size()))));
    const int count = static_cast<int>(m_faces.size());
    for (int i = 0; i < count; ++i) {
        m_faces[static_cast<std::size_t>(i)].left = i % m_columns * m_side;
        m_faces[static_cast<std::size_t>(i)].bottom = i / m_columns * m_side;
    }
    const ImageSize size{m_columns * m_side, (count + m_columns - 1) / m_columns * m_side};
    if (!m_atlas || !(m_atlas.size() == size)) {
        m_atlas = gl::Texture(m_gl, GL_R32F, size);
        m_raster_depth = gl::Texture(m_gl, GL_DEPTH_COMPONENT32F, size);
        m_framebuffer = gl::create_framebuffer(m_gl, {&m_atlas}, &m_raster_depth);
    }
}

void SceneLights::clear_atlas() {
    constexpr float kNothing = std::numeric_limits<float>::infinity();
    constexpr float kFar = 1.0f;
    m_gl.ClearNamedFramebufferfv(m_framebuffer.get(), GL_COLOR, 0, &kNothing);
    m_gl.ClearNamedFramebufferfv(m_framebuffer.get(), GL_DEPTH, 0, &kFar);
    m_is_stale = false;
}

std::string SceneLights::make_shader_counts() {
    return "const int kMostLights = " + std::to_string(kMostLights) +
           ";\nconst int kMostFaces = " + std::to_string(kMostFaces) + ";\n";
}

void SceneLights::connect(const gl::Program& program) {
    program.bind_block("LightBlock", kBlockBinding);
}

std::vector<float> SceneLights::pack(const Camera& camera) const {
    const glm::dmat3 view_from_world = glm::transpose(camera.world_from_view);
    std::vector<float> block;
    push(block, {double(m_first_faces.size()), double(m_side), 0.0}, 0.0);
    for (int i = 0; i < 3; ++i) {
        push(block, camera.world_from_view[i], 0.0);
    }
    std::size_t index = 0;
    for (const DirectionalLight& light : m_lights.directional) {
        push(block, view_from_world * light.to_light, 0.0);
        push(block, light.irradiance, m_first_faces[index++]);
        push(block, glm::dvec3(0.0), -2.0);
        push(block, {0.0, 1.0, 0.0}, 0.0);
    }
    for (const PointLight& light : m_lights.points) {
        push(block, view_from_world * (light.position - camera.position), 1.0);
        push(block, light.intensity, m_first_faces[index++]);
        if (light.cone) {
            push(block, view_from_world * light.cone->direction,
                 std::cos(light.cone->outer_radians));
            push(block, {std::cos(light.cone->inner_radians), 1.0, 0.0}, 0.0);
        } else {
            push(block, glm::dvec3(0.0), -2.0);
            push(block, {0.0, double(kFacesOfCube), 0.0}, 0.0);
        }
    }
    constexpr std::size_t kFloatsOfHeader = 16;
    constexpr std::size_t kFloatsOfLight = 16;
    constexpr std::size_t kFloatsOfFace = 20;
    block.resize(kFloatsOfHeader + kMostLights * kFloatsOfLight);
    for (const Face& face : m_faces) {
        const Camera& light = face.view.camera;
        const glm::dmat3 light_from_world = glm::transpose(light.world_from_view);
        const glm::dmat3 light_from_view = light_from_world * camera.world_from_view;
        const glm::dvec3 shift = light_from_world * (camera.position - light.position);
        for (int row = 0; row < 3; ++row) {
            const double sign = row == 2 ? -1.0 : 1.0; // a light looks along its -z
            push(block,
                 sign * glm::dvec3(light_from_view[0][row], light_from_view[1][row],
                                   light_from_view[2][row]),
                 sign * shift[row]);
        }
        const bool is_perspective = !face.view.is_orthographic();
        push(block,
             {is_perspective ? std::tan(0.5 * light.fov_y_radians) : face.view.half_extent_m,
              is_perspective ? 1.0 : 0.0, 0.0},
             0.0);
        push(block, {double(face.left), double(face.bottom), 0.0}, 0.0);
    }
    block.resize(kFloatsOfHeader + kMostLights * kFloatsOfLight + kMostFaces * kFloatsOfFace);
    return block;
}

void SceneLights::bind(const Camera& camera) {
    const std::vector<float> block = pack(camera);
    const auto bytes = std::as_bytes(std::span(block));
    if (!m_block) {
        m_block = gl::create_buffer(m_gl, bytes, GL_DYNAMIC_STORAGE_BIT);
    } else {
        m_gl.NamedBufferSubData(m_block.get(), 0, static_cast<GLsizeiptr>(bytes.size()),
                                bytes.data());
    }
    m_gl.BindBufferBase(GL_UNIFORM_BUFFER, kBlockBinding, m_block.get());
    m_gl.BindTextureUnit(kAtlasUnit, m_atlas.get());
}

} // namespace alcove
