#include "tests/scenes/deforming_check.hpp"

#include <algorithm>
#include <array>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace alcove {

Mesh pose_mesh(const Scene& scene, std::size_t object, double time_s) {
    const Object& placed = scene.get_objects()[object];
    Mesh mesh = scene.get_meshes()[placed.mesh];
    if (placed.motion == ObjectMotion::deforming) {
        Deformation shape = scene.deform(object, time_s);
        mesh.positions = std::move(shape.positions);
        mesh.normals = std::move(shape.normals);
    }
    const glm::dmat4 place = scene.compute_pose(time_s).object_to_world[object];
    const glm::dmat3 turn = glm::transpose(glm::inverse(glm::dmat3(place)));
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        mesh.positions[i] = glm::vec3(place * glm::dvec4(glm::dvec3(mesh.positions[i]), 1.0));
        mesh.normals[i] = glm::vec3(glm::normalize(turn * glm::dvec3(mesh.normals[i])));
    }
    return mesh;
}

std::size_t count_inverted_corners(const Mesh& mesh) {
    std::size_t inverted = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const std::array<std::uint32_t, 3> t{mesh.indices[i], mesh.indices[i + 1],
                                             mesh.indices[i + 2]};
        const glm::dvec3 a(mesh.positions[t[0]]);
        const glm::dvec3 cross =
            glm::cross(glm::dvec3(mesh.positions[t[1]]) - a, glm::dvec3(mesh.positions[t[2]]) - a);
        if (glm::length(cross) < 2e-10) {
            continue;
        }
        for (const std::uint32_t corner : t) {
            inverted += glm::dot(cross, glm::dvec3(mesh.normals[corner])) < 0.0 ? 1u : 0u;
        }
    }
    return inverted;
}

std::vector<std::size_t> find_objects(const Scene& scene, std::string_view part) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < scene.get_objects().size(); ++i) {
        if (scene.get_objects()[i].name.find(part) != std::string::npos) {
            found.push_back(i);
        }
    }
    return found;
}

std::vector<Triangle> collect_posed_triangles(const Scene& scene, double time_s) {
    std::vector<Triangle> triangles;
    for (std::size_t object = 0; object < scene.get_objects().size(); ++object) {
        const Mesh mesh = pose_mesh(scene, object, time_s);
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            Triangle triangle{object, {}};
            for (std::size_t k = 0; k < 3; ++k) {
                triangle.corners[k] = glm::dvec3(mesh.positions[mesh.indices[i + k]]);
            }
            triangles.push_back(triangle);
        }
    }
    return triangles;
}

FootCheck check_feet(const Scene& scene, std::size_t left, std::size_t right, int first_frame,
                     int end_frame) {
    FootCheck check;
    const double step_s = scene.get_walkthrough().step_s;
    for (int frame = first_frame; frame < end_frame; ++frame) {
        double slide = 1e30;
        double standing = 0.0;
        for (const std::size_t foot : {left, right}) {
            const Mesh now = pose_mesh(scene, foot, frame * step_s);
            const Mesh next = pose_mesh(scene, foot, (frame + 1) * step_s);
            double moved = 0.0;
            double lowest = 1e30;
            for (std::size_t i = 0; i < now.positions.size(); ++i) {
                moved = std::max(
                    moved, static_cast<double>(glm::distance(now.positions[i], next.positions[i])));
                lowest = std::min(lowest, static_cast<double>(now.positions[i].y));
            }
            check.lowest_m = std::min(check.lowest_m, lowest);
            if (moved < slide) {
                slide = moved;
                standing = lowest;
            }
        }
        check.slide_m = std::max(check.slide_m, slide);
        check.highest_m = std::max(check.highest_m, standing);
    }
    return check;
}

double measure_camera_clearance(const Scene& scene, std::size_t stride) {
    const Walkthrough& walkthrough = scene.get_walkthrough();
    double clear = 1e30;
    for (std::size_t frame = 0; frame < walkthrough.cameras.size(); frame += stride) {
        const Clearance clearance = measure_clearance(
            collect_posed_triangles(scene, static_cast<double>(frame) * walkthrough.step_s),
            walkthrough.cameras[frame].position);
        if (clearance.inside) {
            return 0.0;
        }
        clear = std::min(clear, clearance.distance_m);
    }
    return clear;
}

} // namespace alcove
