#include "core/frame/precision.hpp"

#include "core/base/error.hpp"
#include "core/base/nearest_name.hpp"
#include "core/base/text.hpp"

#include <algorithm>
#include <vector>

namespace alcove {
namespace {

const std::vector<std::string>& get_raster_names() {
    static const std::vector<std::string> kNames{"32F", "24", "16"};
    return kNames;
}

const std::vector<std::string>& get_eye_names() {
    static const std::vector<std::string> kNames{"32F", "16F", "raster"};
    return kNames;
}

const std::vector<std::string>& get_motion_names() {
    static const std::vector<std::string> kNames{"16F", "32F"};
    return kNames;
}

std::size_t find_choice(std::string_view key, std::string_view value,
                        const std::vector<std::string>& names) {
    const auto found = std::find(names.begin(), names.end(), value);
    if (found == names.end()) {
        throw InputError("--precision " + std::string(key), "unknown choice", value,
                         describe_choices(value, names));
    }
    return static_cast<std::size_t>(found - names.begin());
}

} // namespace

std::string describe(const Precision& precision) {
    return "raster_depth=" +
           get_raster_names().at(static_cast<std::size_t>(precision.raster_depth)) +
           (precision.reversed ? ",reversed" : "") +
           ",eye_depth=" + get_eye_names().at(static_cast<std::size_t>(precision.eye_depth)) +
           (precision.motion == MotionPrecision::float32 ? ",motion=32F" : "");
}

Precision parse_precision(std::string_view text) {
    Precision precision;
    for (const std::string& part : split(text, ',')) {
        if (part == "reversed") {
            precision.reversed = true;
            continue;
        }
        const KeyValue entry = parse_key_values(part, "--precision").front();
        if (entry.key == "raster_depth") {
            precision.raster_depth =
                static_cast<RasterDepth>(find_choice(entry.key, entry.value, get_raster_names()));
        } else if (entry.key == "eye_depth") {
            precision.eye_depth =
                static_cast<EyeDepth>(find_choice(entry.key, entry.value, get_eye_names()));
        } else if (entry.key == "motion") {
            precision.motion = static_cast<MotionPrecision>(
                find_choice(entry.key, entry.value, get_motion_names()));
        } else {
            const std::vector<std::string> keys{"raster_depth", "reversed", "eye_depth", "motion"};
            throw InputError("--precision", "unknown key", entry.key,
                             describe_choices(entry.key, keys));
        }
    }
    return precision;
}

} // namespace alcove
