#include "core/frame/posed_geometry.hpp"

namespace alcove {

PosedGeometry pose_geometry(const Scene& scene, double time_s) {
    PosedGeometry geometry;
    geometry.scene = &scene;
    geometry.time_s = time_s;
    geometry.is_static = scene.is_static();
    geometry.origin = scene.get_origin();
    const Pose pose = scene.compute_pose(time_s);
    const std::span<const Object> objects = scene.get_objects();
    ALCOVE_ASSERT(pose.object_to_world.size() == objects.size(), "one transform an object");
    for (std::size_t i = 0; i < objects.size(); ++i) {
        glm::dmat4 matrix = pose.object_to_world[i];
        matrix[3] -= glm::dvec4(geometry.origin, 0.0);
        PosedObject& posed = geometry.objects.emplace_back();
        posed.mesh = &scene.get_meshes()[objects[i].mesh];
        posed.motion = objects[i].motion;
        if (objects[i].motion == ObjectMotion::deforming) {
            posed.deformation = scene.deform(i, time_s);
        }
        posed.origin_from_object = glm::mat4(matrix);
        posed.instance_id = static_cast<std::uint32_t>(i + 1);
    }
    return geometry;
}

} // namespace alcove
