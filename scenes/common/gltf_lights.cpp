#include "scenes/common/gltf_lights.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include <glm/geometric.hpp>
#include <tiny_gltf.h>

namespace alcove {
namespace {

constexpr const char* kExtension = "KHR_lights_punctual";
constexpr std::size_t kMostLights = 4;
constexpr float kBrightest = 4.0f;

std::optional<int> find_light(const GltfDocument& document, const tinygltf::Node& node,
                              const std::string& where) {
    const auto extension = node.extensions.find(kExtension);
    if (extension == node.extensions.end()) {
        return std::nullopt;
    }
    const bool has_light = extension->second.IsObject() && extension->second.Has("light") &&
                           extension->second.Get("light").IsInt();
    const int index = has_light ? extension->second.Get("light").GetNumberAsInt() : -1;
    if (index < 0 || static_cast<std::size_t>(index) >= document.model->lights.size()) {
        throw InputError(where + "." + kExtension, "no such light", std::to_string(index),
                         "less than " + std::to_string(document.model->lights.size()));
    }
    return index;
}

/// Colour times intensity.
glm::vec3 read_strength(const tinygltf::Light& source, const std::string& where) {
    glm::dvec3 color(1.0);
    if (!source.color.empty()) {
        if (source.color.size() != 3) {
            throw InputError(where + ".color", "wrong number of elements",
                             std::to_string(source.color.size()), "3");
        }
        color = {source.color[0], source.color[1], source.color[2]};
    }
    const glm::dvec3 strength = color * source.intensity;
    for (int i = 0; i < 3; ++i) {
        if (!(strength[i] >= 0.0 && strength[i] <= 1e12)) {
            throw InputError(where, "colour or intensity out of range", format_number(strength[i]),
                             "0 to 1e12");
        }
    }
    return glm::vec3(strength);
}

/// A light shines along -z of its node.
glm::dvec3 read_backward(const glm::dmat4& world, const std::string& where) {
    const glm::dvec3 backward(world[2]);
    if (!(glm::length(backward) > 0.0)) {
        throw InputError(where, "its node has no direction");
    }
    return glm::normalize(backward);
}

SpotCone read_cone(const tinygltf::SpotLight& source, const glm::dmat4& world,
                   const std::string& where) {
    const bool is_cone = source.innerConeAngle >= 0.0 &&
                         source.innerConeAngle < source.outerConeAngle &&
                         source.outerConeAngle <= 0.5 * std::numbers::pi;
    if (!is_cone) {
        throw InputError(where + ".spot", "is no cone",
                         format_number(source.innerConeAngle) + " to " +
                             format_number(source.outerConeAngle),
                         "0 <= inner < outer <= pi / 2");
    }
    return {-read_backward(world, where), source.innerConeAngle, source.outerConeAngle};
}

float find_brightest(const glm::vec3& strength) {
    return std::max({strength.x, strength.y, strength.z});
}

/// What all lights of a kind are divided by.
float choose_exposure(float brightest, const char* kind, GltfWarnings& warnings) {
    if (brightest <= kBrightest) {
        return 1.0f;
    }
    warnings.insert(std::string(kind) + " lights are scaled by 1/" + format_rounded(brightest) +
                    ": the brightest has an irradiance of 1");
    return brightest;
}

void expose(Lights& lights, double diagonal_m, GltfWarnings& warnings) {
    float brightest = 0.0f;
    for (const DirectionalLight& light : lights.directional) {
        brightest = std::max(brightest, find_brightest(light.irradiance));
    }
    const float directional = choose_exposure(brightest, "directional", warnings);
    for (DirectionalLight& light : lights.directional) {
        light.irradiance /= directional;
    }
    const auto squared = static_cast<float>(0.25 * diagonal_m * diagonal_m);
    brightest = 0.0f;
    for (const PointLight& light : lights.points) {
        brightest = std::max(brightest, find_brightest(light.intensity) / squared);
    }
    const float points = choose_exposure(brightest, "point and spot", warnings);
    for (PointLight& light : lights.points) {
        light.intensity /= points;
    }
}

} // namespace

GltfLights read_lights(const GltfDocument& document, const GltfTree& tree,
                       const std::vector<glm::dmat4>& world, double diagonal_m,
                       GltfWarnings& warnings) {
    GltfLights result;
    Lights& lights = result.lights;
    const std::vector<bool> moving = find_moving(tree.nodes);
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const auto& node = document.model->nodes[static_cast<std::size_t>(tree.indices[i])];
        const auto index = find_light(document, node, tree.name(document, i));
        if (!index) {
            continue;
        }
        const std::string where = document.name("lights", *index);
        const auto& source = document.model->lights[static_cast<std::size_t>(*index)];
        const bool is_directional = source.type == "directional";
        if (!is_directional && source.type != "point" && source.type != "spot") {
            throw InputError(where, "unknown type of light", source.type,
                             "directional, point or spot");
        }
        const std::size_t count = is_directional ? lights.directional.size() : lights.points.size();
        if (count == kMostLights) {
            warnings.insert(std::string("more than 4 lights of a kind, ignored: ") + where);
            continue;
        }
        const glm::vec3 strength = read_strength(source, where);
        (is_directional ? result.directional_nodes : result.point_nodes)
            .push_back(moving[i] ? std::optional(i) : std::nullopt);
        if (is_directional) {
            lights.directional.push_back({read_backward(world[i], where), strength});
        } else {
            PointLight light{glm::dvec3(world[i][3]), strength, std::nullopt};
            if (source.type == "spot") {
                light.cone = read_cone(source.spot, world[i], where);
            }
            lights.points.push_back(light);
        }
    }
    expose(lights, diagonal_m, warnings);
    return result;
}

} // namespace alcove
