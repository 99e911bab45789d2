#pragma once
// Ray-traced references, cached on disk under the content of all that decides them: triangles,
// camera, size, target, rays and the tracer's own sources; never a commit or a file's time.

#include "harness/run/pair_cache.hpp"
#include "harness/run/view_hash.hpp"
#include "methods/common/ray_tracer.hpp"

namespace alcove {

class ReferenceStore {
  public:
    /// `folder` is the cache; `tracer_hash` the content hash of methods/reference_ray_traced.
    ReferenceStore(std::filesystem::path folder, std::string tracer_hash, Audit audit = {});

    /// Visibility as PairCache::get gives it, from the cache or traced.
    [[nodiscard]] ReferencePair get(const Scene& scene, const FrameView& view,
                                    const TraceSettings& settings, bool& was_cached);

    [[nodiscard]] std::size_t audited() const noexcept { return m_pairs.audited(); }

  private:
    [[nodiscard]] std::string make_key(const Scene& scene, const FrameView& view,
                                       const TraceSettings& settings);

    std::string m_tracer_hash;
    PairCache m_pairs;
    RayTracer m_tracer;
    GeometryHash m_geometry;
};

} // namespace alcove
