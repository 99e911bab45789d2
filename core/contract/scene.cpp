#include "core/contract/scene.hpp"

#include "core/base/error.hpp"
#include "core/base/hash.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtx/rotate_vector.hpp>

namespace alcove {
namespace {

bool is_finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void check_clusters(const Mesh& mesh, const std::string& place) {
    std::size_t next = 0;
    for (const Cluster& cluster : mesh.clusters) {
        if (cluster.first_index != next || cluster.index_count == 0 ||
            cluster.index_count % 3 != 0 || cluster.index_count > mesh.indices.size() - next) {
            throw InputError(place, "clusters do not follow each other",
                             "cluster at index " + std::to_string(cluster.first_index));
        }
        next += cluster.index_count;
    }
    if (!mesh.clusters.empty() && next != mesh.indices.size()) {
        throw InputError(place, "clusters leave triangles out", std::to_string(next) + " indices",
                         std::to_string(mesh.indices.size()));
    }
}

/// Values a vertex that a mesh may have: none or as many as positions.
void check_count(std::size_t count, const Mesh& mesh, const std::string& place, const char* what) {
    if (count != 0 && count != mesh.positions.size()) {
        throw InputError(place, std::string("needs one ") + what + " a position or none",
                         std::to_string(count), std::to_string(mesh.positions.size()));
    }
}

void check_mesh(const Mesh& mesh, std::size_t texture_count, std::string_view where) {
    const std::string place = std::string(where) + ", mesh " + mesh.name;
    if (mesh.positions.empty() || mesh.indices.empty() || mesh.indices.size() % 3 != 0) {
        throw InputError(place, "needs positions and whole triangles",
                         std::to_string(mesh.positions.size()) + " positions, " +
                             std::to_string(mesh.indices.size()) + " indices");
    }
    if (mesh.normals.size() != mesh.positions.size()) {
        throw InputError(place, "needs one normal a position", std::to_string(mesh.normals.size()),
                         std::to_string(mesh.positions.size()));
    }
    for (const std::uint32_t index : mesh.indices) {
        if (index >= mesh.positions.size()) {
            throw InputError(place, "index out of range", std::to_string(index),
                             "less than " + std::to_string(mesh.positions.size()));
        }
    }
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const float length = glm::length(mesh.normals[i]);
        if (!is_finite(mesh.positions[i]) || !(std::abs(length - 1.0f) < 1e-3f)) {
            throw InputError(place, "position not finite or normal not of unit length at vertex " +
                                        std::to_string(i));
        }
    }
    check_count(mesh.colors.size(), mesh, place, "color");
    check_count(mesh.texture_coordinates.size(), mesh, place, "texture coordinate");
    if (mesh.texture && (*mesh.texture >= texture_count || mesh.texture_coordinates.empty())) {
        throw InputError(place, "names a texture out of range or lacks texture coordinates");
    }
    check_clusters(mesh, place);
}

void check_textures(const Scene& scene, std::string_view where) {
    for (const Texture& texture : scene.get_textures()) {
        if (texture.size.width < 1 || texture.size.height < 1 ||
            texture.rgb.size() != 3 * texture.size.pixel_count()) {
            throw InputError(where, "texture " + texture.name + " has the wrong number of pixels");
        }
    }
}

template <class Vector>
void add(Hasher& hasher, const Vector& vector) {
    for (int i = 0; i < 3; ++i) {
        hasher.add(vector[i]);
    }
}

void check_tracks(const Scene& scene, std::string_view where) {
    std::vector<std::string_view> moved;
    for (const ObjectTrack& track : scene.get_walkthrough().tracks) {
        const std::string place = std::string(where) + ", track of " + track.object;
        const auto objects = scene.get_objects();
        const auto matches =
            std::count_if(objects.begin(), objects.end(),
                          [&](const Object& object) { return object.name == track.object; });
        if (matches != 1) {
            throw InputError(place, "names no single object", std::to_string(matches) + " objects",
                             "one object of that name");
        }
        if (std::find(moved.begin(), moved.end(), track.object) != moved.end()) {
            throw InputError(place, "the object has two tracks");
        }
        moved.emplace_back(track.object);
        const bool ascending = std::adjacent_find(track.keys.begin(), track.keys.end(),
                                                  [](const TrackKey& a, const TrackKey& b) {
                                                      return a.frame >= b.frame;
                                                  }) == track.keys.end();
        if (track.keys.empty() || !ascending || !(std::abs(glm::length(track.axis) - 1.0) < 1e-6)) {
            throw InputError(place, "needs keys that ascend and an axis of unit length");
        }
    }
}

bool is_light(const glm::vec3& value) {
    return is_finite(value) && value.x >= 0.0f && value.y >= 0.0f && value.z >= 0.0f;
}

bool is_unit(const glm::dvec3& direction) {
    return std::abs(glm::length(direction) - 1.0) < 1e-6;
}

void check_lights(const Lights& lights, std::string_view where) {
    const std::string kNoLight = "has a light that is not finite or negative";
    for (const DirectionalLight& light : lights.directional) {
        if (!is_light(light.irradiance) || !is_unit(light.to_light)) {
            throw InputError(where, kNoLight + ", or without direction");
        }
    }
    for (const PointLight& light : lights.points) {
        const bool has_place = std::isfinite(glm::length(light.position));
        const bool has_cone =
            !light.cone || (is_unit(light.cone->direction) && light.cone->inner_radians >= 0.0 &&
                            light.cone->inner_radians < light.cone->outer_radians &&
                            light.cone->outer_radians < 1.5708);
        if (!is_light(light.intensity) || !has_place || !has_cone) {
            throw InputError(where, kNoLight + ", or without place or cone");
        }
    }
    if (!is_light(lights.ambient)) {
        throw InputError(where, kNoLight);
    }
}

void check_events(const Walkthrough& walkthrough, std::string_view where) {
    int last = 0;
    for (const WalkthroughEvent& event : walkthrough.events) {
        if (event.frame < last ||
            static_cast<std::size_t>(event.frame) >= walkthrough.cameras.size()) {
            throw InputError(where, "event " + event.label + " does not ascend or lies outside");
        }
        last = event.frame;
    }
}

} // namespace

Deformation Scene::deform(std::size_t /*object*/, double /*time_s*/) const {
    ALCOVE_ASSERT(false, "an object that deforms");
    return {};
}

glm::vec3 compute_surrounding_radiance(const Lights& lights, const glm::dvec3& direction) {
    if (!lights.environment) {
        return lights.ambient;
    }
    return lights.environment->look_up(glm::rotateY(direction, -lights.environment_turn_radians));
}

glm::vec3 compute_background_radiance(const Lights& lights, const glm::dvec3& direction) {
    if (!lights.environment) {
        return lights.ambient;
    }
    return lights.environment->interpolate(
        glm::rotateY(direction, -lights.environment_turn_radians));
}

glm::vec3 compute_irradiance(const DirectionalLight& light, const glm::dvec3& normal) {
    return light.irradiance * static_cast<float>(std::max(glm::dot(normal, light.to_light), 0.0));
}

glm::vec3 compute_irradiance(const PointLight& light, const glm::dvec3& position,
                             const glm::dvec3& normal) {
    const glm::dvec3 to_light = light.position - position;
    const double squared = glm::dot(to_light, to_light);
    if (!(squared > 0.0)) {
        return glm::vec3(0.0f);
    }
    const glm::dvec3 direction = to_light / std::sqrt(squared);
    double factor = std::max(glm::dot(normal, direction), 0.0) / squared;
    if (light.cone) {
        const double outer = std::cos(light.cone->outer_radians);
        const double inner = std::cos(light.cone->inner_radians);
        const double along = -glm::dot(direction, light.cone->direction);
        const double inside = std::clamp((along - outer) / (inner - outer), 0.0, 1.0);
        factor *= inside * inside;
    }
    return light.intensity * static_cast<float>(factor);
}

SceneSize count_size(const Scene& scene) {
    SceneSize size;
    for (const Object& object : scene.get_objects()) {
        const Mesh& mesh = scene.get_meshes()[object.mesh];
        size.vertices += mesh.positions.size();
        size.triangles += mesh.indices.size() / 3;
    }
    return size;
}

std::string hash_surfaces(const Scene& scene) {
    Hasher hasher;
    for (const Mesh& mesh : scene.get_meshes()) {
        hasher.add(mesh.positions.size()).add(mesh.indices.size());
        hasher.add(mesh.colors.size()).add(mesh.texture_coordinates.size());
        hasher.add_bytes(std::as_bytes(std::span(mesh.positions)));
        hasher.add_bytes(std::as_bytes(std::span(mesh.normals)));
        hasher.add_bytes(std::as_bytes(std::span(mesh.indices)));
        hasher.add_bytes(std::as_bytes(std::span(mesh.colors)));
        hasher.add_bytes(std::as_bytes(std::span(mesh.texture_coordinates)));
        hasher.add(mesh.texture ? *mesh.texture + 1 : 0);
        add(hasher, mesh.albedo);
    }
    for (const Texture& texture : scene.get_textures()) {
        hasher.add(texture.size.width).add(texture.size.height);
        hasher.add_bytes(std::as_bytes(std::span(texture.rgb)));
    }
    for (const Object& object : scene.get_objects()) {
        hasher.add(object.mesh);
    }
    return hasher.finish_hex();
}

std::string hash_lights(const Scene& scene, double time_s) {
    Hasher hasher;
    const Lights lights = scene.compute_lights(time_s);
    for (const DirectionalLight& light : lights.directional) {
        add(hasher, light.to_light);
        add(hasher, light.irradiance);
        hasher.add(light.casts_shadow);
    }
    for (const PointLight& light : lights.points) {
        add(hasher, light.position - scene.get_origin());
        add(hasher, light.intensity);
        hasher.add(light.casts_shadow).add(light.cone.has_value());
        if (light.cone) {
            add(hasher, light.cone->direction);
            hasher.add(light.cone->inner_radians).add(light.cone->outer_radians);
        }
    }
    add(hasher, lights.ambient);
    if (lights.environment) {
        hasher.add(lights.environment->content_hash()).add(lights.environment_turn_radians);
    }
    return hasher.finish_hex();
}

std::string hash_geometry(const Scene& scene, double time_s, std::string_view surfaces) {
    Hasher hasher;
    hasher.add(surfaces);
    const glm::dvec3 origin = scene.get_origin();
    const Pose pose = scene.compute_pose(time_s);
    for (std::size_t i = 0; i < scene.get_objects().size(); ++i) {
        glm::dmat4 matrix = pose.object_to_world[i];
        matrix[3] -= glm::dvec4(origin, 0.0);
        for (int column = 0; column < 4; ++column) {
            for (int row = 0; row < 4; ++row) {
                hasher.add(matrix[column][row]);
            }
        }
        if (scene.get_objects()[i].motion == ObjectMotion::deforming) {
            const Deformation deformation = scene.deform(i, time_s);
            hasher.add_bytes(std::as_bytes(std::span(deformation.positions)));
            hasher.add_bytes(std::as_bytes(std::span(deformation.normals)));
        }
    }
    return hasher.finish_hex();
}

std::string hash_geometry(const Scene& scene, double time_s) {
    return hash_geometry(scene, time_s, hash_surfaces(scene));
}

void check_scene(const Scene& scene, std::string_view where) {
    check_textures(scene, where);
    for (const Mesh& mesh : scene.get_meshes()) {
        check_mesh(mesh, scene.get_textures().size(), where);
    }
    if (scene.get_objects().empty()) {
        throw InputError(where, "has no objects");
    }
    for (const Object& object : scene.get_objects()) {
        if (object.mesh >= scene.get_meshes().size()) {
            throw InputError(where, "object " + object.name + " names a mesh out of range");
        }
    }
    const Walkthrough& walkthrough = scene.get_walkthrough();
    if (walkthrough.cameras.empty() || !(walkthrough.step_s > 0.0)) {
        throw InputError(where, "walkthrough needs a frame and a positive time step");
    }
    for (const Camera& camera : walkthrough.cameras) {
        check_camera(camera, where);
    }
    const std::vector<int>& cuts = walkthrough.cuts;
    const bool ascending =
        std::adjacent_find(cuts.begin(), cuts.end(), std::greater_equal<>{}) == cuts.end();
    if (!ascending ||
        (!cuts.empty() && (cuts.front() < 0 ||
                           static_cast<std::size_t>(cuts.back()) >= walkthrough.cameras.size()))) {
        throw InputError(where, "cuts of the walkthrough are not ascending frames of it");
    }
    check_lights(scene.get_lights(), where);
    check_tracks(scene, where);
    check_events(walkthrough, where);
    if (!(scene.get_ao_radius_m() > 0.0) || !std::isfinite(scene.get_ao_radius_m())) {
        throw InputError(where, "AO radius is not a positive number of metres");
    }
}

} // namespace alcove
