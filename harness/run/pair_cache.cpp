#include "harness/run/pair_cache.hpp"

#include "core/base/error.hpp"
#include "core/base/image_file.hpp"

#include <algorithm>
#include <optional>

namespace alcove {
namespace {

namespace fs = std::filesystem;

/// `a` above `b`.
Image stack(const Image& a, const Image& b) {
    Image stacked({a.width(), 2 * a.height()}, a.channels());
    const auto middle = std::copy(a.values().begin(), a.values().end(), stacked.values().begin());
    std::copy(b.values().begin(), b.values().end(), middle);
    return stacked;
}

ReferencePair unstack(const Image& stacked) {
    const ImageSize size{stacked.width(), stacked.height() / 2};
    ReferencePair pair{Image(size, stacked.channels()), Image(size, stacked.channels()), 0};
    const std::span<const float> values = stacked.values();
    const std::size_t count = pair.a.values().size();
    std::copy_n(values.begin(), count, pair.a.values().begin());
    std::copy_n(values.subspan(count).begin(), count, pair.b.values().begin());
    return pair;
}

bool is_equal(const Image& a, const Image& b) {
    return a.size() == b.size() && a.channels() == b.channels() &&
           std::equal(a.values().begin(), a.values().end(), b.values().begin());
}

} // namespace

ReferencePair PairCache::get(const std::string& key, const Shape& shape,
                             const std::function<ReferencePair()>& trace, bool& was_cached) {
    const fs::path path = make_cache_path(m_folder, "references", key, ".exr");
    was_cached = false;
    std::optional<ReferencePair> cached;
    if (fs::is_regular_file(path)) {
        try {
            const ImageFile file = read_image_file(path);
            const ImageSize stacked{shape.size.width, 2 * shape.size.height};
            if (file.image.size() == stacked && file.image.channels() == shape.channels) {
                cached = unstack(file.image);
                mark_used(path);
            }
        } catch (const InputError&) {
            // A damaged file of the cache is no input of the user's: it is made anew below.
            cached.reset();
        }
    }
    if (cached && !m_audit.draws(key)) {
        was_cached = true;
        return std::move(*cached);
    }
    ReferencePair pair = trace();
    ALCOVE_ASSERT(pair.a.size() == shape.size && pair.a.channels() == shape.channels,
                  "halves as they were announced");
    if (!cached) {
        write_exr(path, stack(pair.a, pair.b), shape.domain);
        return pair;
    }
    if (!is_equal(cached->a, pair.a) || !is_equal(cached->b, pair.b)) {
        throw FailureError("audit", "a cached reference is not what is traced now", path.string(),
                           "the same bits; `alcove cache prune --limit 0` empties the cache");
    }
    ++m_audited;
    was_cached = true;
    return pair;
}

bool PairCache::is_intact(const fs::path& file) {
    return read_image_file(file).image.height() % 2 == 0;
}

} // namespace alcove
