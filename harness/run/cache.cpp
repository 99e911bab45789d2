#include "harness/run/cache.hpp"

#include "core/base/assert.hpp"
#include "core/base/error.hpp"
#include "core/base/hash.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <system_error>

namespace alcove {
namespace {

namespace fs = std::filesystem;

std::uintmax_t measure(const fs::path& path) {
    std::error_code error;
    if (!fs::is_directory(path, error)) {
        const std::uintmax_t bytes = fs::file_size(path, error);
        return error ? 0 : bytes;
    }
    std::uintmax_t bytes = 0;
    for (const fs::directory_entry& file : fs::recursive_directory_iterator(path, error)) {
        if (file.is_regular_file(error)) {
            bytes += file.file_size(error);
        }
    }
    return bytes;
}

void add_entries(const std::string& kind, const fs::path& folder,
                 std::vector<CacheEntry>& entries) {
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
        entries.push_back(
            {kind, entry.path(), measure(entry.path()), entry.last_write_time(error)});
    }
}

} // namespace

const std::vector<std::string>& list_cache_kinds() {
    static const std::vector<std::string> kKinds{"references", "gbuffers", "captures", "spheres",
                                                 "builds"};
    return kKinds;
}

std::vector<CacheEntry> list_cache(const fs::path& folder) {
    std::vector<CacheEntry> entries;
    for (const std::string& kind : list_cache_kinds()) {
        if (kind == "builds") {
            add_entries(kind, folder / kind, entries);
            continue;
        }
        std::error_code error;
        for (const fs::directory_entry& bucket : fs::directory_iterator(folder / kind, error)) {
            if (bucket.is_directory(error)) {
                add_entries(kind, bucket.path(), entries);
            }
        }
    }
    std::sort(entries.begin(), entries.end(),
              [](const CacheEntry& a, const CacheEntry& b) { return a.used < b.used; });
    return entries;
}

std::uintmax_t prune_cache(const fs::path& folder, std::uintmax_t limit) {
    const std::vector<CacheEntry> entries = list_cache(folder);
    std::uintmax_t total = 0;
    for (const CacheEntry& entry : entries) {
        total += entry.bytes;
    }
    std::uintmax_t gone = 0;
    for (const CacheEntry& entry : entries) {
        if (total - gone <= limit) {
            break;
        }
        std::error_code error;
        if (fs::remove_all(entry.path, error) != static_cast<std::uintmax_t>(-1) && !error) {
            gone += entry.bytes;
        }
    }
    return gone;
}

bool Audit::draws(const std::string& key) const {
    Hasher hasher;
    hasher.add(seed).add(key);
    return std::ldexp(static_cast<double>(hasher.finish64()), -64) < share;
}

} // namespace alcove
