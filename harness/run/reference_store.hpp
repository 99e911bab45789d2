#pragma once
// Ray-traced references, cached on disk under the content of all that decides them: triangles,
// camera, size, target, rays and the tracer's own sources; never a commit or a file's time.

#include "harness/run/cache.hpp"
#include "harness/run/view_hash.hpp"
#include "methods/common/ray_tracer.hpp"

#include <filesystem>
#include <string>

namespace alcove {

class ReferenceStore {
  public:
    /// `folder` is the cache; `tracer_hash` the content hash of methods/reference_ray_traced.
    ReferenceStore(std::filesystem::path folder, std::string tracer_hash, Audit audit = {});

    /// From the cache, or traced and put there. A cached file that cannot be read is traced anew.
    /// `was_cached` says which. What the audit draws is traced as well; throws FailureError naming
    /// the file if a bit differs.
    [[nodiscard]] ReferencePair get(const Scene& scene, const FrameView& view,
                                    const TraceSettings& settings, bool& was_cached);

    /// Can the file be read as a reference? For `cache verify`.
    [[nodiscard]] static bool is_intact(const std::filesystem::path& file);

    /// References that the audit has traced and found equal.
    [[nodiscard]] std::size_t audited() const noexcept { return m_audited; }

  private:
    [[nodiscard]] std::string make_key(const Scene& scene, const FrameView& view,
                                       const TraceSettings& settings);
    [[nodiscard]] ReferencePair trace(const Scene& scene, const FrameView& view,
                                      const TraceSettings& settings);

    std::filesystem::path m_folder;
    std::string m_tracer_hash;
    Audit m_audit;
    RayTracer m_tracer;
    GeometryHash m_geometry;
    std::size_t m_audited = 0;
};

} // namespace alcove
