#include "scenes/common/camera_file.hpp"

#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "scenes/common/strict_json.hpp"

#include <numbers>
#include <string>

#include <nlohmann/json.hpp>

namespace alcove {

Camera parse_camera(std::string_view text, std::string_view file) {
    const nlohmann::json json = parse_strict_json(text, file);
    const JsonPlace root(json, std::string(file));
    root.check_keys({"position", "target", "up", "fov_y_degrees", "near", "far"});
    const glm::dvec3 position = root.get("position").read_vector();
    const glm::dvec3 target = root.get("target").read_vector();
    const glm::dvec3 up = root.get("up").read_vector();
    const double fov_y_degrees = root.get("fov_y_degrees").read_number();
    const double near_m = root.get("near").read_number();
    const double far_m = root.get("far").read_number();
    if (!(fov_y_degrees > 0.0 && fov_y_degrees < 180.0)) {
        root.get("fov_y_degrees").fail("out of range", "more than 0 and less than 180 degrees");
    }
    if (!(near_m > 0.0)) {
        root.get("near").fail("out of range", "more than 0");
    }
    if (!(far_m > near_m)) {
        root.get("far").fail("out of range", "more than near");
    }
    try {
        return make_look_at_camera(position, target, up, fov_y_degrees * std::numbers::pi / 180.0,
                                   near_m, far_m);
    } catch (const InputError& error) {
        throw InputError(file, error.what());
    }
}

Camera read_camera_file(const std::filesystem::path& path) {
    return parse_camera(read_file(path, std::uintmax_t{1} << 20), path.string());
}

} // namespace alcove
