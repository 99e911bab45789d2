#pragma once
// A file of the tree that was compiled into the binary (cmake/embed_files.cmake), so that it runs
// from anywhere.

#include <span>
#include <string_view>

namespace alcove {

struct EmbeddedFile {
    std::string_view name; ///< path in the tree, e.g. "methods/anchor/anchor.frag.glsl"
    std::string_view text;
};

} // namespace alcove
