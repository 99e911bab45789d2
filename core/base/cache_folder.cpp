#include "core/base/cache_folder.hpp"

#include <cstdlib>

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

} // namespace alcove
