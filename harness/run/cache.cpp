#include "harness/run/cache.hpp"

#include "core/base/assert.hpp"
#include "core/base/error.hpp"
#include "core/base/hash.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <random>
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
    static const std::vector<std::string> kKinds{"references", "gbuffers", "captures", "builds"};
    return kKinds;
}

fs::path make_cache_path(const fs::path& folder, const std::string& kind, const std::string& key,
                         const std::string& suffix) {
    ALCOVE_ASSERT(key.size() > 2, "a key");
    return folder / kind / key.substr(0, 2) / (key + suffix);
}

void write_cache_file(const fs::path& path, std::string_view bytes) {
    std::random_device random; // two programs may write the same entry
    const fs::path temporary = path.string() + ".tmp" + std::to_string(random());
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    {
        std::ofstream stream(temporary, std::ios::binary);
        stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        stream.flush();
        if (!stream) {
            fs::remove(temporary, error);
            throw FailureError(path.string(), "cannot write");
        }
    }
    fs::rename(temporary, path, error);
    if (error) {
        throw FailureError(path.string(), "cannot rename into place: " + error.message());
    }
}

void mark_used(const fs::path& entry) {
    std::error_code ignored;
    fs::last_write_time(entry, fs::file_time_type::clock::now(), ignored);
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
