#include "harness/run/reference_store.hpp"

#include "core/base/error.hpp"
#include "core/base/hash.hpp"
#include "core/base/image_file.hpp"

#include <algorithm>
#include <cstdlib>
#include <system_error>
#include <vector>

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

} // namespace

fs::path get_cache_folder() {
    if (const char* folder = std::getenv("ALCOVE_CACHE"); folder != nullptr && *folder != '\0') {
        return folder;
    }
    if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0') {
        return fs::path(home) / ".cache" / "alcove";
    }
    return fs::temp_directory_path() / "alcove-cache";
}

ReferenceStore::ReferenceStore(fs::path folder, std::string tracer_hash)
    : m_folder(std::move(folder)), m_tracer_hash(std::move(tracer_hash)) {}

fs::path ReferenceStore::make_path(const Scene& scene, const FrameView& view,
                                   const TraceSettings& settings) {
    if (m_hashed_scene != &scene || !scene.is_static()) {
        m_geometry_hash = hash_geometry(scene, view.time_s);
        m_hashed_scene = &scene;
    }
    Hasher hasher;
    hasher.add(m_tracer_hash).add(m_geometry_hash).add(describe(settings.target));
    hasher.add(settings.rays_per_half).add(settings.seed).add(settings.terminator_safe);
    hasher.add(view.size.width).add(view.size.height);
    const glm::dvec3 position = view.camera.position - scene.get_origin();
    for (int i = 0; i < 3; ++i) {
        hasher.add(position[i]);
        for (int j = 0; j < 3; ++j) {
            hasher.add(view.camera.world_from_view[i][j]);
        }
    }
    hasher.add(view.camera.fov_y_radians).add(view.camera.near_m).add(view.camera.far_m);
    const std::string key = hasher.finish_hex();
    return m_folder / "references" / key.substr(0, 2) / (key + ".exr");
}

ReferencePair ReferenceStore::get(const Scene& scene, const FrameView& view,
                                  const TraceSettings& settings, bool& was_cached) {
    const fs::path path = make_path(scene, view, settings);
    was_cached = false;
    if (fs::is_regular_file(path)) {
        try {
            const ImageFile file = read_image_file(path);
            if (file.image.size() == view.size && file.image.channels() == 2) {
                was_cached = true;
                std::error_code ignored;
                fs::last_write_time(path, fs::file_time_type::clock::now(), ignored);
                return {take_channel(file.image, 0), take_channel(file.image, 1), 0};
            }
        } catch (const InputError&) {
            // A damaged file of the cache is no input of the user's: it is made anew below.
            was_cached = false;
        }
    }
    m_tracer.update(pose_geometry(scene, view.time_s));
    ReferencePair pair = m_tracer.trace(view.camera, view.size, settings);
    write_exr(path, join_channels(pair.a, pair.b), Domain::visibility);
    return pair;
}

void ReferenceStore::prune(std::uintmax_t limit) const {
    struct Entry {
        fs::path path;
        std::uintmax_t size;
        fs::file_time_type used;
    };
    std::vector<Entry> entries;
    std::uintmax_t total = 0;
    std::error_code error;
    for (const fs::directory_entry& file :
         fs::recursive_directory_iterator(m_folder / "references", error)) {
        if (file.is_regular_file(error)) {
            entries.push_back({file.path(), file.file_size(error), file.last_write_time(error)});
            total += entries.back().size;
        }
    }
    std::sort(entries.begin(), entries.end(),
              [](const Entry& a, const Entry& b) { return a.used < b.used; });
    for (const Entry& entry : entries) {
        if (total <= limit) {
            break;
        }
        if (fs::remove(entry.path, error)) {
            total -= entry.size;
        }
    }
}

} // namespace alcove
