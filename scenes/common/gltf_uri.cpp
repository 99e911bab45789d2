#include "scenes/common/gltf_uri.hpp"

#include "core/base/error.hpp"
#include "core/base/file.hpp"

namespace alcove {

std::string decode_percent(std::string_view uri) {
    const auto digit = [](char c) {
        const std::string_view digits = "0123456789abcdef";
        const char lower = c >= 'A' && c <= 'F' ? static_cast<char>(c - 'A' + 'a') : c;
        return digits.find(lower);
    };
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] == '%' && i + 2 < uri.size() && digit(uri[i + 1]) < 16 &&
            digit(uri[i + 2]) < 16) {
            text += static_cast<char>(digit(uri[i + 1]) * 16 + digit(uri[i + 2]));
            i += 2;
        } else {
            text += uri[i];
        }
    }
    return text;
}

std::filesystem::path resolve_gltf_uri(const std::filesystem::path& document,
                                       const std::string& decoded, const std::string& where) {
    try {
        return resolve_inside(document.parent_path(), decoded);
    } catch (const Error& error) {
        throw InputError(where, error.what());
    }
}

} // namespace alcove
