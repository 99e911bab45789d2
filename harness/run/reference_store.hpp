#pragma once
// Ray-traced references, cached on disk under the content of all that decides them: triangles,
// camera, size, target, rays and the tracer's own sources; never a commit or a file's time.

#include "core/frame/frame_view.hpp"
#include "methods/reference_ray_traced/ray_tracer.hpp"

#include <filesystem>
#include <string>

namespace alcove {

/// `$ALCOVE_CACHE`, else `~/.cache/alcove`, else a folder below the system's temporary one.
[[nodiscard]] std::filesystem::path get_cache_folder();

/// Largest size of the cache; above it the files used longest ago go.
inline constexpr std::uintmax_t kCacheLimitBytes = 8ull << 30;

class ReferenceStore {
  public:
    /// `tracer_hash` is the content hash of methods/reference_ray_traced.
    ReferenceStore(std::filesystem::path folder, std::string tracer_hash);

    /// From the cache, or traced and put there. A cached file that cannot be read is traced anew.
    /// `was_cached` says which.
    [[nodiscard]] ReferencePair get(const Scene& scene, const FrameView& view,
                                    const TraceSettings& settings, bool& was_cached);

    /// Removes the files used longest ago until the cache is within `limit`.
    void prune(std::uintmax_t limit = kCacheLimitBytes) const;

  private:
    [[nodiscard]] std::filesystem::path make_path(const Scene& scene, const FrameView& view,
                                                  const TraceSettings& settings);

    std::filesystem::path m_folder;
    std::string m_tracer_hash;
    RayTracer m_tracer;
    const Scene* m_hashed_scene = nullptr;
    std::string m_geometry_hash;
};

} // namespace alcove
