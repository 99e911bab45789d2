#include "scenes/common/bunny_package.hpp"

#include "core/base/error.hpp"
#include "scenes/common/strict_json.hpp"

#include <string>

#include <nlohmann/json.hpp>

namespace alcove {
namespace {

/// The array literal that is assigned to `exports.<name>`. Its elements are numbers and arrays, so
/// brackets count.
std::string_view find_array(std::string_view text, const std::string& name, std::string_view file) {
    const std::string marker = "exports." + name;
    const std::size_t found = text.find(marker);
    if (found == std::string_view::npos) {
        throw InputError(file, "does not assign the array", {}, marker);
    }
    const std::string_view rest = text.substr(found + marker.size());
    const std::size_t equals = rest.find_first_not_of(" \t\r\n");
    if (equals == std::string_view::npos || rest[equals] != '=') {
        throw InputError(file, "no `=` after", marker);
    }
    const std::size_t start = rest.find_first_not_of(" \t\r\n", equals + 1);
    if (start == std::string_view::npos || rest[start] != '[') {
        throw InputError(file, "no array after", marker);
    }
    int depth = 0;
    for (std::size_t i = start; i < rest.size(); ++i) {
        if (rest[i] == '[') {
            ++depth;
        } else if (rest[i] == ']' && --depth == 0) {
            return rest.substr(start, i - start + 1);
        }
    }
    throw InputError(file, "the array does not end", marker);
}

} // namespace

BunnyData parse_bunny_package(std::string_view text, std::string_view file) {
    BunnyData data;
    const std::string positions_name = std::string(file) + ", exports.positions";
    const nlohmann::json positions =
        parse_strict_json(find_array(text, "positions", file), positions_name);
    const JsonPlace positions_place(positions, positions_name);
    for (std::size_t i = 0; i < positions_place.count(); ++i) {
        data.positions.push_back(positions_place.at(i).read_vector());
    }
    const std::string cells_name = std::string(file) + ", exports.cells";
    const nlohmann::json cells = parse_strict_json(find_array(text, "cells", file), cells_name);
    const JsonPlace cells_place(cells, cells_name);
    const auto last = static_cast<std::int64_t>(data.positions.size()) - 1;
    for (std::size_t i = 0; i < cells_place.count(); ++i) {
        const JsonPlace cell = cells_place.at(i);
        if (cell.count() != 3) {
            cell.fail("wrong number of corners", "three indices");
        }
        std::array<std::uint32_t, 3> corners{};
        for (std::size_t corner = 0; corner < 3; ++corner) {
            corners[corner] = static_cast<std::uint32_t>(cell.at(corner).read_integer(0, last));
        }
        data.cells.push_back(corners);
    }
    if (data.cells.empty()) {
        cells_place.fail("holds no triangles", "at least one");
    }
    return data;
}

} // namespace alcove
