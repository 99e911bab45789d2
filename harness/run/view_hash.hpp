#pragma once
// What of a frame decides an image: the camera, relative to the scene's origin, and the size.

#include "core/base/hash.hpp"
#include "core/frame/frame_view.hpp"

namespace alcove {

void add_view(Hasher& hasher, const Scene& scene, const FrameView& view);

/// hash_geometry, remembered while the scene does not change.
class GeometryHash {
  public:
    [[nodiscard]] const std::string& get(const Scene& scene, double time_s);

  private:
    const Scene* m_scene = nullptr;
    double m_time_s = 0.0;
    std::string m_surfaces; ///< hash_surfaces of m_scene
    std::string m_hash;
};

} // namespace alcove
