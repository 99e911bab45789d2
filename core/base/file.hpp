#pragma once
// Files that survive a kill: whole or not there. And bounded reading of what comes from outside.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace alcove {

/// Writes `bytes` under a temporary name in the same folder, syncs, renames: a reader sees the old
/// file or the new one. Creates the parent folder. Throws FailureError naming the path and the
/// system's reason (full disk, no permission, a parent that is a regular file).
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

/// Renames a finished folder into place and syncs its parent. Throws FailureError.
void publish_folder(const std::filesystem::path& temporary,
                    const std::filesystem::path& final_path);

/// Creates a folder and its parents and proves that it can be written to. Throws InputError (exit
/// 2) if not.
void create_output_folder(const std::filesystem::path& path);

/// Reads a whole file. Throws InputError if it is missing, not a regular file or larger than
/// `limit` bytes.
[[nodiscard]] std::string read_file(const std::filesystem::path& path,
                                    std::uintmax_t limit = 1ull << 30);

/// Joins a path that a file from outside names (a glTF URI, an image of a report) to the folder of
/// that file. Throws InputError if it is absolute, has a scheme, or leaves the folder, also by way
/// of symbolic links.
[[nodiscard]] std::filesystem::path resolve_inside(const std::filesystem::path& folder,
                                                   std::string_view relative);

} // namespace alcove
