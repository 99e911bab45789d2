#pragma once
// The room's data, embedded at build time: claims, errata, experiments.

#include "core/base/embedded_file.hpp"

#include <span>

namespace alcove {

[[nodiscard]] std::span<const EmbeddedFile> embedded_papers();

/// Asserts that there is such a file, named by its path in the tree.
[[nodiscard]] std::string_view find_paper_file(std::string_view name);

} // namespace alcove
