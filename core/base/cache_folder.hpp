#pragma once
// Where things are kept between runs.

#include <filesystem>
#include <string>
#include <string_view>

namespace alcove {

/// $ALCOVE_CACHE, else $HOME/.cache/alcove, else a folder among the system's temporary ones. It may
/// not be there yet.
[[nodiscard]] std::filesystem::path get_cache_folder();

/// The folder of models that `alcove scene fetch` has brought, one folder each, by their names.
[[nodiscard]] std::filesystem::path get_fetched_scenes_folder();

/// kind/ab/<key><suffix> below `folder`; `key` starts with "ab".
[[nodiscard]] std::filesystem::path make_cache_path(const std::filesystem::path& folder,
                                                    const std::string& kind, const std::string& key,
                                                    const std::string& suffix);

/// Writes a file whole or not at all as far as a kill goes; without waiting for the disk, since a
/// checksum tells what a power cut has left. Creates its folder. Throws FailureError.
void write_cache_file(const std::filesystem::path& path, std::string_view bytes);

/// Notes that an entry was used now. Failures (a read-only cache) are no error.
void mark_used(const std::filesystem::path& entry);

} // namespace alcove
