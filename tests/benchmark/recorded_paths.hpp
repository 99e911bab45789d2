#pragma once
// The rays that the path tracer casts, made beforehand, and nothing but Embree's queries over them:
// the nearest hit for bundles that start at one point, occlusion for those that start wherever the
// first ones hit.

#include "core/base/camera.hpp"
#include "core/frame/posed_geometry.hpp"

#include <cstdint>
#include <limits>
#include <memory>

namespace alcove {

struct PathRecording {
    float reach_m = std::numeric_limits<float>::infinity();
    int rays_per_half = 32;               ///< a multiple of 16
    glm::vec3 to_light{0.0f, 1.0f, 0.0f}; ///< unit; every surface that faces it casts a shadow ray
};

class RecordedPaths {
  public:
    RecordedPaths(const PosedGeometry& geometry, const Camera& camera, ImageSize size,
                  const PathRecording& recording);
    ~RecordedPaths();
    RecordedPaths(const RecordedPaths&) = delete;
    RecordedPaths& operator=(const RecordedPaths&) = delete;

    /// Of one run; camera rays are not among them.
    [[nodiscard]] std::uint64_t ray_count() const;
    [[nodiscard]] std::uint64_t scattered_count() const;
    /// Casts all of them on all cores; each bundle is copied first, because a query changes it.
    void run() const;

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace alcove
