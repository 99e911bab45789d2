#pragma once
// The walkthroughs that scenes/CMakeLists.txt compiles into the binary. The definition is generated
// at build time.

#include "core/base/embedded_file.hpp"

namespace alcove {

[[nodiscard]] std::span<const EmbeddedFile> embedded_scene_files();

} // namespace alcove
