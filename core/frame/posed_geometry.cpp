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
        geometry.objects.push_back({&scene.get_meshes()[objects[i].mesh], glm::mat4(matrix),
                                    static_cast<std::uint32_t>(i + 1)});
    }
    return geometry;
}

} // namespace alcove
