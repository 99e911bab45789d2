#pragma once
// The cache on disk: what can be made again, kept under the content of all that decides it. One
// folder a kind; entries are files or folders that appear by a rename and are never changed.
//
//   references/ab/<key>.exr   ray-traced halves          gbuffers/ab/<key>.texels, .times
//   captures/ab/<key>/        images and metrics of a cell, with their ingredients
//   spheres/ab/<key>.clusters what shanmugam_arikan has found for a geometry
//   builds/<commit>/          programs that `ab` has built

#include "core/base/cache_folder.hpp"
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace alcove {

/// Largest size of the cache; above it the entries used longest ago go.
inline constexpr std::uintmax_t kCacheLimitBytes = 8ull << 30;

/// The kinds of entries, by the names of their folders.
[[nodiscard]] const std::vector<std::string>& list_cache_kinds();

struct CacheEntry {
    std::string kind;
    std::filesystem::path path; ///< a file, or a folder that counts as one
    std::uintmax_t bytes = 0;
    std::filesystem::file_time_type used;
};
/// Everything in the cache, the entry used longest ago first. A folder that is not there is empty.
[[nodiscard]] std::vector<CacheEntry> list_cache(const std::filesystem::path& folder);

/// Removes the entries used longest ago until the cache is within `limit`; returns the bytes that
/// went.
std::uintmax_t prune_cache(const std::filesystem::path& folder,
                           std::uintmax_t limit = kCacheLimitBytes);

/// A random share of what the cache gives is made anew and compared (DESIGN 3.11; `--audit`). Which
/// entries is a function of the seed and their keys.
struct Audit {
    double share = 0.0; ///< 0 to 1
    std::uint64_t seed = 0;
    [[nodiscard]] bool draws(const std::string& key) const;
};

} // namespace alcove
