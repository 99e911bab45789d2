#include "scenes/common/gltf_lights.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"

#include <algorithm>
#include <cmath>
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

DirectionalLight read_light(const tinygltf::Light& source, const glm::dmat4& world,
                            const std::string& where) {
    glm::dvec3 color(1.0);
    if (!source.color.empty()) {
        if (source.color.size() != 3) {
            throw InputError(where + ".color", "wrong number of elements",
                             std::to_string(source.color.size()), "3");
        }
        color = {source.color[0], source.color[1], source.color[2]};
    }
    const glm::dvec3 irradiance = color * source.intensity;
    for (int i = 0; i < 3; ++i) {
        if (!(irradiance[i] >= 0.0 && irradiance[i] <= 1e12)) {
            throw InputError(where, "colour or intensity out of range",
                             format_number(irradiance[i]), "0 to 1e12");
        }
    }
    const glm::dvec3 backward(world[2]); // a light shines along -z
    if (!(glm::length(backward) > 0.0)) {
        throw InputError(where, "its node has no direction");
    }
    return {glm::normalize(backward), glm::vec3(irradiance)};
}

void expose(std::vector<DirectionalLight>& lights, GltfWarnings& warnings) {
    float brightest = 0.0f;
    for (const DirectionalLight& light : lights) {
        brightest =
            std::max({brightest, light.irradiance.x, light.irradiance.y, light.irradiance.z});
    }
    if (brightest > kBrightest) {
        for (DirectionalLight& light : lights) {
            light.irradiance /= brightest;
        }
        warnings.insert("directional lights are scaled by 1/" + format_rounded(brightest) +
                        ": the brightest has an irradiance of 1");
    }
}

} // namespace

std::vector<DirectionalLight> read_lights(const GltfDocument& document, const GltfTree& tree,
                                          const std::vector<glm::dmat4>& world,
                                          GltfWarnings& warnings) {
    std::vector<DirectionalLight> lights;
    const std::vector<bool> moving = find_moving(tree.nodes);
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const auto& node = document.model->nodes[static_cast<std::size_t>(tree.indices[i])];
        const auto index = find_light(document, node, tree.name(document, i));
        if (!index) {
            continue;
        }
        const std::string where = document.name("lights", *index);
        const auto& source = document.model->lights[static_cast<std::size_t>(*index)];
        if (source.type != "directional") {
            warnings.insert("point and spot lights are not lit yet: " + where);
        } else if (lights.size() == kMostLights) {
            warnings.insert("more than 4 directional lights, ignored: " + where);
        } else {
            lights.push_back(read_light(source, world[i], where));
            if (moving[i]) {
                warnings.insert("a moving light stays where it is at time 0: " + where);
            }
        }
    }
    expose(lights, warnings);
    return lights;
}

} // namespace alcove
