#include "core/frame/surroundings.hpp"

#include <glm/gtc/matrix_transform.hpp>

namespace alcove {
namespace {

/// write_texture takes row 0 for the last one of the texture; an octahedral map has it first.
Image turn_over(const Image& map) {
    Image turned(map.size(), 4, 1.0f);
    for (int y = 0; y < map.height(); ++y) {
        for (int x = 0; x < map.width(); ++x) {
            for (int channel = 0; channel < 3; ++channel) {
                turned.at(x, map.height() - 1 - y, channel) = map.at(x, y, channel);
            }
        }
    }
    return turned;
}

Image fill(const glm::vec3& value) {
    Image map({1, 1}, 4, 1.0f);
    for (int channel = 0; channel < 3; ++channel) {
        map.at(0, 0, channel) = value[channel];
    }
    return map;
}

gl::Texture upload(const gl::Functions& gl, const Image& map) {
    gl::Texture texture(gl, GL_RGBA32F, map.size());
    gl::write_texture(gl, texture, map);
    return texture;
}

} // namespace

void Surroundings::update(const Lights& lights) {
    m_turn_radians = lights.environment_turn_radians;
    if (lights.environment) {
        if (m_environment == lights.environment) {
            return;
        }
        m_environment = lights.environment;
        m_ambient.reset();
        m_radiance = upload(m_gl, turn_over(m_environment->radiance()));
        m_prefiltered = upload(m_gl, turn_over(m_environment->prefiltered()));
        m_gl.TextureParameteri(m_prefiltered.get(), GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        m_gl.TextureParameteri(m_prefiltered.get(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        return;
    }
    if (m_ambient != lights.ambient) {
        m_environment.reset();
        m_ambient = lights.ambient;
        m_radiance = upload(m_gl, fill(lights.ambient));
        m_prefiltered = upload(m_gl, fill(lights.ambient));
    }
}

SurroundingsView Surroundings::look_through(const Camera& camera) const {
    ALCOVE_ASSERT(static_cast<bool>(m_radiance), "light to look at");
    const glm::dmat3 map_from_world(
        glm::rotate(glm::dmat4(1.0), -m_turn_radians, glm::dvec3(0.0, 1.0, 0.0)));
    return {&m_radiance, &m_prefiltered, glm::mat3(map_from_world * camera.world_from_view)};
}

} // namespace alcove
