#pragma once
// What of a glTF file is JSON, before any parser sees it.

#include <string>
#include <string_view>

namespace alcove {

/// True for the binary container (GLB).
[[nodiscard]] bool is_glb(std::string_view bytes);

/// The JSON of a .gltf or .glb. Throws InputError unless a container's header and chunks fit the
/// file, and on more than 256 levels of nesting: neither our parser nor tinygltf's may be driven
/// into deep recursion.
[[nodiscard]] std::string_view find_gltf_json(std::string_view bytes, const std::string& file);

} // namespace alcove
