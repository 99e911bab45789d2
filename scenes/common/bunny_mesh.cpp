#include "scenes/common/bunny_mesh.hpp"

#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "scenes/common/bunny_package.hpp"
#include "scenes/common/mesh_builder.hpp"
#include "scenes/common/node_modules.hpp"

#include <cstdint>

#include <glm/common.hpp>

namespace alcove {
namespace {

/// The package's bunny is 9.65 units high.
constexpr double kMetresPerUnit = 0.1;

Mesh make_bunny(const BunnyData& data) {
    glm::dvec3 low = data.positions.front();
    glm::dvec3 high = low;
    for (const glm::dvec3& position : data.positions) {
        low = glm::min(low, position);
        high = glm::max(high, position);
    }
    const glm::dvec3 foot(0.5 * (low.x + high.x), low.y, 0.5 * (low.z + high.z));
    MeshBuilder builder;
    for (const glm::dvec3& position : data.positions) {
        builder.add_point((position - foot) * kMetresPerUnit);
    }
    for (const auto& [a, b, c] : data.cells) {
        builder.add_triangle(a, b, c);
    }
    return builder.finish("bunny", {0.62f, 0.55f, 0.48f}, 180.0);
}

} // namespace

std::optional<std::string> find_bunny_obstacle() {
    if (find_package_file("bunny", "index.js")) {
        return std::nullopt;
    }
    return "the npm package `bunny` is not in " + get_node_modules_folder().string() +
           "; run `npm ci` in the source tree, or set ALCOVE_NODE_MODULES to a node_modules "
           "folder that has it";
}

Mesh read_bunny(std::string_view where) {
    const auto path = find_package_file("bunny", "index.js");
    if (!path) {
        throw InputError(where, find_bunny_obstacle().value());
    }
    return make_bunny(
        parse_bunny_package(read_file(*path, std::uintmax_t{1} << 24), path->string()));
}

} // namespace alcove
