#include "core/contract/scene.hpp"

#include "core/base/error.hpp"
#include "core/base/hash.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

void check_mesh(const Mesh& mesh, std::string_view where) {
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
        const glm::vec3 p = mesh.positions[i];
        const bool finite = std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
        const float length = glm::length(mesh.normals[i]);
        if (!finite || !(std::abs(length - 1.0f) < 1e-3f)) {
            throw InputError(place, "position not finite or normal not of unit length at vertex " +
                                        std::to_string(i));
        }
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

SceneSize count_size(const Scene& scene) {
    SceneSize size;
    for (const Object& object : scene.get_objects()) {
        const Mesh& mesh = scene.get_meshes()[object.mesh];
        size.vertices += mesh.positions.size();
        size.triangles += mesh.indices.size() / 3;
    }
    return size;
}

std::string hash_geometry(const Scene& scene, double time_s) {
    Hasher hasher;
    for (const Mesh& mesh : scene.get_meshes()) {
        hasher.add(mesh.positions.size()).add(mesh.indices.size());
        hasher.add_bytes(std::as_bytes(std::span(mesh.positions)));
        hasher.add_bytes(std::as_bytes(std::span(mesh.normals)));
        hasher.add_bytes(std::as_bytes(std::span(mesh.indices)));
    }
    const glm::dvec3 origin = scene.get_origin();
    const Pose pose = scene.compute_pose(time_s);
    for (std::size_t i = 0; i < scene.get_objects().size(); ++i) {
        hasher.add(scene.get_objects()[i].mesh);
        glm::dmat4 matrix = pose.object_to_world[i];
        matrix[3] -= glm::dvec4(origin, 0.0);
        for (int column = 0; column < 4; ++column) {
            for (int row = 0; row < 4; ++row) {
                hasher.add(matrix[column][row]);
            }
        }
    }
    return hasher.finish_hex();
}

void check_scene(const Scene& scene, std::string_view where) {
    for (const Mesh& mesh : scene.get_meshes()) {
        check_mesh(mesh, where);
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
    check_tracks(scene, where);
    check_events(walkthrough, where);
    if (!(scene.get_ao_radius_m() > 0.0) || !std::isfinite(scene.get_ao_radius_m())) {
        throw InputError(where, "AO radius is not a positive number of metres");
    }
}

} // namespace alcove
