#include "methods/common/surface_albedo.hpp"

#include "core/base/domain.hpp"

#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/vec2.hpp>

namespace alcove {
namespace {

Image decode(const Texture& texture) {
    Image linear(texture.size, 3);
    for (std::size_t i = 0; i < texture.rgb.size(); ++i) {
        linear.values()[i] = decode_srgb(static_cast<float>(texture.rgb[i]) / 255.0f);
    }
    return linear;
}

/// Of a repeated row of `count` texels.
int wrap(int index, int count) {
    const int rest = index % count;
    return rest < 0 ? rest + count : rest;
}

glm::vec3 filter(const Image& texture, const glm::vec2& coordinates) {
    // The whole part goes first: it says nothing, and leaves few bits to the rest.
    const glm::vec2 place =
        glm::fract(coordinates) * glm::vec2(texture.width(), texture.height()) - 0.5f;
    const glm::vec2 low = glm::floor(place);
    const glm::vec2 share = place - low;
    glm::vec3 sum(0.0f);
    for (int i = 0; i < 4; ++i) {
        const int dx = i % 2;
        const int dy = i / 2;
        const int x = wrap(static_cast<int>(low.x) + dx, texture.width());
        const int y = wrap(static_cast<int>(low.y) + dy, texture.height());
        const float weight =
            (dx == 1 ? share.x : 1.0f - share.x) * (dy == 1 ? share.y : 1.0f - share.y);
        sum += weight * glm::vec3(texture.at(x, y, 0), texture.at(x, y, 1), texture.at(x, y, 2));
    }
    return sum;
}

/// Between the three vertices of the surface's triangle.
template <class Value>
Value interpolate(const std::vector<Value>& values, const TracedSurface& surface) {
    Value sum(0.0f);
    for (std::size_t i = 0; i < 3; ++i) {
        sum += surface.barycentric[i] * values[surface.triangle.vertices[i]];
    }
    return sum;
}

} // namespace

void SurfaceAlbedo::update(const Scene* scene) {
    if (m_scene == scene) {
        return;
    }
    m_scene = scene;
    m_textures.clear();
    if (scene != nullptr) {
        for (const Texture& texture : scene->get_textures()) {
            m_textures.push_back(decode(texture));
        }
    }
}

glm::vec3 SurfaceAlbedo::look_up(const TracedSurface& surface) const {
    const Mesh& mesh = *surface.triangle.mesh;
    glm::vec3 albedo = mesh.albedo;
    if (!mesh.colors.empty()) {
        albedo *= interpolate(mesh.colors, surface);
    }
    if (mesh.texture) {
        albedo *= filter(m_textures[*mesh.texture], interpolate(mesh.texture_coordinates, surface));
    }
    return albedo;
}

} // namespace alcove
