#pragma once
// Which images are held against each other: two files, the frames of two folders, or a list.

#include <filesystem>
#include <string>
#include <vector>

namespace alcove {

struct ImagePair {
    std::filesystem::path test;
    std::filesystem::path reference;
    std::string label; ///< unique among the pairs, safe in a file's name
};

/// Two files, or two folders whose PNG, EXR and HDR files are paired by name. Throws InputError if
/// only one is a folder, if a name stands in one folder only, and if there is none.
[[nodiscard]] std::vector<ImagePair> pair_images(const std::filesystem::path& test,
                                                 const std::filesystem::path& reference);

/// The pairs of a CSV with the header `test,reference`: paths relative to the list's folder, below
/// it. Throws InputError naming file and line of what is malformed, missing or leads elsewhere, and
/// of more than 100,000 pairs.
[[nodiscard]] std::vector<ImagePair> read_pair_list(const std::filesystem::path& list);

} // namespace alcove
