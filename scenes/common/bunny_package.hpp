#pragma once
// Reader of the npm package `bunny`: a JavaScript file of two array literals. It is read, never
// executed.

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

namespace alcove {

struct BunnyData {
    std::vector<glm::dvec3> positions;               ///< in the package's units
    std::vector<std::array<std::uint32_t, 3>> cells; ///< counter-clockwise seen from outside
};

/// Reads `exports.positions = [[x,y,z],...]` and `exports.cells = [[a,b,c],...]`. `file` is what
/// errors call the text. Throws InputError if an array is missing or not JSON, a number is not
/// finite, or an index is out of range.
[[nodiscard]] BunnyData parse_bunny_package(std::string_view text, std::string_view file);

} // namespace alcove
