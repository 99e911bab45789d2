#pragma once
// Ray-traced visibility: truth for a target, in world space, over the same posed triangles that are
// rasterised, with two independent randomisations that tell its own noise. No OpenGL.

#include "core/base/camera.hpp"
#include "core/base/target.hpp"
#include "core/frame/posed_geometry.hpp"
#include "methods/common/reference_pair.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace alcove {

struct TraceSettings {
    Target target;
    int rays_per_half = 64; ///< a pixel and half, >= 1; multiples of 16 fill the bundles
    std::uint32_t seed = 0;
    /// Start rays of shading normals where no neighbouring facet cuts them off.
    bool terminator_safe = true;
    int threads = 0; ///< 0: all cores. The image does not depend on it
};

/// A place on a surface, relative to the geometry's origin.
struct SurfacePoint {
    glm::vec3 position;
    glm::vec3 normal; ///< unit, to the side that is asked about
};

class RayTracer {
  public:
    RayTracer();
    ~RayTracer();
    RayTracer(const RayTracer&) = delete;
    RayTracer& operator=(const RayTracer&) = delete;

    /// Builds the tree, unless it is already that of this static scene. The scene must outlive its
    /// use. Throws FailureError if Embree fails.
    void update(const PosedGeometry& geometry);

    /// Evaluated where the ray through the pixel centre hits; rays are blocked by either side of a
    /// surface; normals are turned to the viewer; near and far clip camera rays only. One channel,
    /// background 1; counts occlusion rays. Asserts that update was called.
    [[nodiscard]] ReferencePair trace(const Camera& camera, ImageSize size,
                                      const TraceSettings& settings) const;

    /// Mean visibility of each point over both halves' rays; positions are used as they are, lifted
    /// by 32 units in the last place of the largest coordinate. Asserts that update was called.
    [[nodiscard]] std::vector<float> trace_points(std::span<const SurfacePoint> points,
                                                  const TraceSettings& settings) const;

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace alcove
