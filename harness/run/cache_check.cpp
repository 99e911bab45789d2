#include "harness/run/cache_check.hpp"

#include "core/base/error.hpp"
#include "harness/run/capture_store.hpp"
#include "harness/run/gbuffer_store.hpp"
#include "harness/run/pair_cache.hpp"

namespace alcove {
namespace {

bool is_intact(const CacheEntry& entry) {
    try {
        if (entry.kind == "references") {
            return PairCache::is_intact(entry.path);
        }
        if (entry.kind == "gbuffers") {
            return GBufferStore::is_intact(entry.path);
        }
        return entry.kind != "captures" || CaptureStore::is_intact(entry.path);
    } catch (const InputError&) {
        return false; // unreadable is damaged
    }
}

} // namespace

CacheCheck check_cache(const std::filesystem::path& folder) {
    CacheCheck check;
    for (const CacheEntry& entry : list_cache(folder)) {
        if (is_intact(entry)) {
            ++check.intact;
            continue;
        }
        std::error_code ignored;
        std::filesystem::remove_all(entry.path, ignored);
        check.damaged.push_back(entry.path);
    }
    return check;
}

} // namespace alcove
