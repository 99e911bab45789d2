#include "harness/run/view_hash.hpp"

namespace alcove {

void add_view(Hasher& hasher, const Scene& scene, const FrameView& view) {
    hasher.add(view.size.width).add(view.size.height);
    const glm::dvec3 position = view.camera.position - scene.get_origin();
    for (int i = 0; i < 3; ++i) {
        hasher.add(position[i]);
        for (int j = 0; j < 3; ++j) {
            hasher.add(view.camera.world_from_view[i][j]);
        }
    }
    hasher.add(view.camera.fov_y_radians).add(view.camera.near_m).add(view.camera.far_m);
}

const std::string& GeometryHash::get(const Scene& scene, double time_s) {
    const bool is_known =
        m_scene == &scene && (scene.is_static() || m_time_s == time_s) && !m_hash.empty();
    if (!is_known) {
        if (m_scene != &scene || m_surfaces.empty()) {
            m_surfaces = hash_surfaces(scene);
        }
        m_hash = hash_geometry(scene, time_s, m_surfaces);
        m_scene = &scene;
        m_time_s = time_s;
    }
    return m_hash;
}

} // namespace alcove
