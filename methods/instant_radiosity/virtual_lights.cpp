#include "methods/instant_radiosity/virtual_lights.hpp"

#include "methods/common/energy_runs.hpp"
#include "methods/common/sobol.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace alcove {
namespace {

const glm::dvec3 kLuminance(0.2126, 0.7152, 0.0722);

double compute_cone_factor(const ShadowLight& light, const glm::dvec3& from_light) {
    if (!light.cone) {
        return 1.0;
    }
    const double outer = std::cos(light.cone->outer_radians);
    const double inner = std::cos(light.cone->inner_radians);
    const double cosine = glm::dot(from_light, light.cone->direction);
    const double inside = std::clamp((cosine - outer) / (inner - outer), 0.0, 1.0);
    return inside * inside;
}

} // namespace

ReflectiveShadowMaps::ReflectiveShadowMaps(const gl::Functions& gl, int side)
    : m_gl(gl), m_gbuffer(gl, {side, side}, {Channel::eye_depth, Channel::normal, Channel::albedo},
                          Precision{}),
      m_order(order_along_curve(side)) {}

void ReflectiveShadowMaps::add(Raster& raster, const ShadowLight& light) {
    for (const LightView& view : light.views) {
        raster.draw(m_gbuffer, view);
        read(view, light);
    }
}

void ReflectiveShadowMaps::read(const LightView& view, const ShadowLight& light) {
    const Image depth = gl::read_texture(m_gl, m_gbuffer.texture(Channel::eye_depth), 1);
    const Image normal = gl::read_texture(m_gl, m_gbuffer.texture(Channel::normal), 3);
    const Image albedo = gl::read_texture(m_gl, m_gbuffer.texture(Channel::albedo), 3);
    const int side = depth.width();
    const bool is_orthographic = view.is_orthographic();
    const double extent =
        is_orthographic ? view.half_extent_m : std::tan(0.5 * view.camera.fov_y_radians);
    const double texel = 2.0 * extent / side;
    const glm::dmat3& world_from_light = view.camera.world_from_view;
    for (const std::size_t index : m_order) {
        const int x = static_cast<int>(index) % side;
        const int y = static_cast<int>(index) / side;
        const double z = depth.at(x, y);
        if (!std::isfinite(z)) {
            continue;
        }
        // Row 0 is on top.
        const glm::dvec2 place =
            extent * glm::dvec2((2.0 * x + 1.0) / side - 1.0, 1.0 - (2.0 * y + 1.0) / side);
        const double spread = is_orthographic ? 1.0 : z;
        const glm::dvec3 p(spread * place.x, spread * place.y, -z);
        const glm::dvec3 n(normal.at(x, y, 0), normal.at(x, y, 1), normal.at(x, y, 2));
        // A texel's share of the flux: of a plane across the light, or of the sphere around it,
        // whichever way the surface in it leans.
        double share = texel * texel;
        if (!is_orthographic) {
            const double length = std::sqrt(1.0 + glm::dot(place, place));
            share *= compute_cone_factor(light, glm::normalize(world_from_light * p)) /
                     (length * length * length);
        }
        const glm::vec3 reflectance(albedo.at(x, y, 0), albedo.at(x, y, 1), albedo.at(x, y, 2));
        Texel entry;
        entry.light.position = view.camera.position + world_from_light * p;
        entry.light.normal = world_from_light * glm::normalize(n);
        entry.light.intensity =
            light.color * reflectance * static_cast<float>(share * std::numbers::inv_pi);
        entry.luminance = glm::dot(kLuminance, glm::dvec3(entry.light.intensity));
        if (entry.luminance > 0.0) {
            m_texels.push_back(entry);
        }
    }
}

std::vector<VirtualLight> ReflectiveShadowMaps::choose(int count, std::uint32_t seed) {
    double total = 0.0;
    for (const Texel& texel : m_texels) {
        total += texel.luminance;
    }
    const double step = total / count;
    double next = (hash_words(seed, 0) + 0.5) / 4294967296.0 * step;
    double sum = 0.0;
    std::vector<VirtualLight> chosen;
    for (const Texel& texel : m_texels) {
        sum += texel.luminance;
        int times = 0;
        while (next < sum) {
            ++times;
            next += step;
        }
        if (times > 0) {
            // Chosen as often as its luminance says: an equal share each time, in its colour.
            VirtualLight light = texel.light;
            light.intensity *= static_cast<float>(times * step / texel.luminance);
            chosen.push_back(light);
        }
    }
    m_texels.clear();
    return chosen;
}

} // namespace alcove
