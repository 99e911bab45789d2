#pragma once
// A scene's licence as data: licence.json of its folder.

#include <filesystem>
#include <string>
#include <string_view>

namespace alcove {

inline constexpr std::string_view kLicenceFile = "licence.json";

struct Licence {
    std::string spdx;          ///< SPDX identifier, or "unstated"
    std::string attribution;   ///< whom to credit
    bool redistribute = false; ///< may its data be shipped
    bool figures = false;      ///< may images of it be published
};

class JsonPlace;

/// {"spdx": "...", "attribution": "...", "redistribute": true|false, "figures": true|false}. Throws
/// InputError naming file and key on anything else.
[[nodiscard]] Licence parse_licence(const JsonPlace& place);
/// The same of a file.
[[nodiscard]] Licence read_licence(const std::filesystem::path& file);
[[nodiscard]] std::string write_licence(const Licence& licence);

} // namespace alcove
