#pragma once
// Path-traced pictures, cached on disk under the content of all that decides them: triangles,
// materials, lights, camera, size, settings, rays and the tracer's own sources.

#include "harness/run/pair_cache.hpp"
#include "harness/run/view_hash.hpp"
#include "methods/common/path_tracer.hpp"

namespace alcove {

class RadianceStore {
  public:
    /// `folder` is the cache; `tracer_hash` the content hash of methods/reference_path_traced.
    RadianceStore(std::filesystem::path folder, std::string tracer_hash, Audit audit = {});

    /// Radiance towards the eye, linear Rec. 709, three channels: direct light and each half of the
    /// indirect light. As PairCache::get gives it, from the cache or traced.
    [[nodiscard]] ReferencePair get(const Scene& scene, const FrameView& view,
                                    const PathSettings& settings, bool& was_cached);

    [[nodiscard]] std::size_t audited() const noexcept { return m_pairs.audited(); }

  private:
    [[nodiscard]] std::string make_key(const Scene& scene, const FrameView& view,
                                       const PathSettings& settings);

    std::string m_tracer_hash;
    PairCache m_pairs;
    PathTracer m_tracer;
    GeometryHash m_geometry;
};

} // namespace alcove
