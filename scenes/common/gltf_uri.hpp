#pragma once
// Names of files that a glTF file refers to.

#include <filesystem>
#include <string>
#include <string_view>

namespace alcove {

/// The text with %XX in place of what they stand for.
[[nodiscard]] std::string decode_percent(std::string_view uri);

/// The file a (decoded) relative URI names beside the document. Throws InputError naming `where`
/// if it is absolute, has a scheme or leaves the folder, also by way of symbolic links.
[[nodiscard]] std::filesystem::path resolve_gltf_uri(const std::filesystem::path& document,
                                                     const std::string& decoded,
                                                     const std::string& where);

} // namespace alcove
