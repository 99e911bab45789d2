#include "scenes/common/licence.hpp"

#include "core/base/file.hpp"
#include "scenes/common/strict_json.hpp"

#include <nlohmann/json.hpp>

namespace alcove {

Licence parse_licence(const JsonPlace& place) {
    place.check_keys({"spdx", "attribution", "redistribute", "figures"});
    return {place.get("spdx").read_text(), place.get("attribution").read_text(),
            place.get("redistribute").read_truth(), place.get("figures").read_truth()};
}

Licence read_licence(const std::filesystem::path& file) {
    constexpr std::uintmax_t kLargest = 64 * 1024;
    const nlohmann::json json = parse_strict_json(read_file(file, kLargest), file.string());
    return parse_licence(JsonPlace(json, file.string()));
}

std::string write_licence(const Licence& licence) {
    const nlohmann::ordered_json json{{"spdx", licence.spdx},
                                      {"attribution", licence.attribution},
                                      {"redistribute", licence.redistribute},
                                      {"figures", licence.figures}};
    return json.dump(2) + "\n";
}

} // namespace alcove
