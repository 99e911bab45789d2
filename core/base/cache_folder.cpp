#include "core/base/cache_folder.hpp"

#include "core/base/assert.hpp"
#include "core/base/error.hpp"

#include <cstdlib>
#include <fstream>
#include <random>
#include <system_error>

namespace alcove {

namespace fs = std::filesystem;

fs::path get_cache_folder() {
    if (const char* folder = std::getenv("ALCOVE_CACHE"); folder != nullptr && *folder != '\0') {
        return folder;
    }
    if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0') {
        return fs::path(home) / ".cache" / "alcove";
    }
    return fs::temp_directory_path() / "alcove-cache";
}

fs::path get_fetched_scenes_folder() {
    return get_cache_folder() / "scenes";
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

} // namespace alcove
