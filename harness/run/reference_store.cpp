#include "harness/run/reference_store.hpp"

#include "core/base/error.hpp"
#include "core/base/hash.hpp"
#include "core/base/image_file.hpp"

#include <algorithm>
#include <optional>

namespace alcove {
namespace {

namespace fs = std::filesystem;

Image join_channels(const Image& a, const Image& b) {
    Image joined(a.size(), 2);
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            joined.at(x, y, 0) = a.at(x, y);
            joined.at(x, y, 1) = b.at(x, y);
        }
    }
    return joined;
}

bool is_equal(const Image& a, const Image& b) {
    return a.size() == b.size() && a.channels() == b.channels() &&
           std::equal(a.values().begin(), a.values().end(), b.values().begin());
}

} // namespace

ReferenceStore::ReferenceStore(fs::path folder, std::string tracer_hash, Audit audit)
    : m_folder(std::move(folder)), m_tracer_hash(std::move(tracer_hash)), m_audit(audit) {}

std::string ReferenceStore::make_key(const Scene& scene, const FrameView& view,
                                     const TraceSettings& settings) {
    Hasher hasher;
    hasher.add(m_tracer_hash).add(m_geometry.get(scene, view.time_s));
    hasher.add(describe(settings.target));
    hasher.add(settings.rays_per_half).add(settings.seed).add(settings.terminator_safe);
    add_view(hasher, scene, view);
    return hasher.finish_hex();
}

ReferencePair ReferenceStore::trace(const Scene& scene, const FrameView& view,
                                    const TraceSettings& settings) {
    m_tracer.update(pose_geometry(scene, view.time_s));
    return m_tracer.trace(view.camera, view.size, settings);
}

ReferencePair ReferenceStore::get(const Scene& scene, const FrameView& view,
                                  const TraceSettings& settings, bool& was_cached) {
    const std::string key = make_key(scene, view, settings);
    const fs::path path = make_cache_path(m_folder, "references", key, ".exr");
    was_cached = false;
    std::optional<ReferencePair> cached;
    if (fs::is_regular_file(path)) {
        try {
            const ImageFile file = read_image_file(path);
            if (file.image.size() == view.size && file.image.channels() == 2) {
                cached = {take_channel(file.image, 0), take_channel(file.image, 1), 0};
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
    ReferencePair pair = trace(scene, view, settings);
    if (!cached) {
        write_exr(path, join_channels(pair.a, pair.b), Domain::visibility);
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

bool ReferenceStore::is_intact(const fs::path& file) {
    return read_image_file(file).image.channels() == 2;
}

} // namespace alcove
