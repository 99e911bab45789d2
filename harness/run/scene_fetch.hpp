#pragma once
// Models that a user's machine can fetch, told as data in fetchable_scenes.json: from Debian
// packages and npm packages, into the cache, each with its licence. Nothing of them is shipped.

#include "scenes/common/licence.hpp"

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace alcove {

struct FetchableFile {
    std::string from; ///< path in the package, or in the archive inside it
    std::string as;   ///< name in the cache; the first one is what is opened
};

struct FetchableScene {
    std::string name;
    std::string title;
    std::string debian;         ///< package, or
    std::string npm;            ///< package@version
    std::string archive;        ///< a .tar.gz inside the package that holds the files; may be empty
    bool needs_blender = false; ///< files are .blend and are exported as .glb
    std::vector<FetchableFile> files;
    Licence licence;
};

[[nodiscard]] const std::vector<FetchableScene>& list_fetchable_scenes();
/// Throws InputError with the nearest name.
[[nodiscard]] const FetchableScene& find_fetchable_scene(std::string_view name);

/// Where a fetched scene is opened from, below the cache folder; it may not be there yet.
[[nodiscard]] std::filesystem::path get_fetched_file(const FetchableScene& scene);
[[nodiscard]] bool is_fetched(const FetchableScene& scene);

/// Fetches what is not there yet, a package once; `say` hears of each step. What is finished stays
/// when a later one fails or the program is killed. Throws InputError where ALCOVE_NO_INSTALL
/// forbids package managers or a program is missing, FailureError with the programs' last words if
/// one fails.
void fetch_scenes(std::span<const FetchableScene> scenes,
                  const std::function<void(const std::string&)>& say);

} // namespace alcove
