#pragma once
// The bundles that the reference tracer casts, made beforehand, and nothing but rtcOccluded16 over
// them.

#include "core/base/camera.hpp"
#include "core/frame/posed_geometry.hpp"

#include <cstdint>
#include <memory>

namespace alcove {

class RecordedBundles {
  public:
    /// Receivers where the rays through pixel centres hit, cosine directions of shading normals,
    /// two halves.
    RecordedBundles(const PosedGeometry& geometry, const Camera& camera, ImageSize size,
                    double radius_m, int rays_per_half);
    ~RecordedBundles();
    RecordedBundles(const RecordedBundles&) = delete;
    RecordedBundles& operator=(const RecordedBundles&) = delete;

    [[nodiscard]] std::size_t receiver_count() const;
    [[nodiscard]] std::uint64_t ray_count() const;
    /// Casts all of them on all cores; each bundle is copied first, because a query changes it.
    void run() const;

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace alcove
