#include "scenes/common/gltf_container.hpp"

#include "core/base/error.hpp"

#include <cstddef>
#include <cstdint>

namespace alcove {
namespace {

constexpr int kDeepestJson = 256; ///< the parser recurses into `extras`

std::uint32_t read_u32(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
    }
    return value;
}

std::string_view find_json_chunk(std::string_view bytes, const std::string& file) {
    constexpr std::size_t kHeader = 20;
    if (bytes.size() < kHeader) {
        throw InputError(file, "truncated header", std::to_string(bytes.size()) + " bytes",
                         "at least 20");
    }
    if (read_u32(bytes, 4) != 2) {
        throw InputError(file, "unsupported GLB version", std::to_string(read_u32(bytes, 4)), "2");
    }
    const std::size_t length = read_u32(bytes, 8);
    const std::size_t json_length = read_u32(bytes, 12);
    if (length != bytes.size()) {
        throw InputError(file, "truncated or padded: its header tells another length",
                         std::to_string(bytes.size()) + " bytes", std::to_string(length));
    }
    if (read_u32(bytes, 16) != 0x4E4F534Au || json_length == 0 || json_length % 4 != 0 ||
        json_length > length - kHeader) {
        throw InputError(file, "first chunk is not JSON within the file",
                         std::to_string(json_length) + " bytes",
                         "at most " + std::to_string(length - kHeader) + ", a multiple of 4");
    }
    const std::size_t rest = length - kHeader - json_length;
    if (rest != 0 && (rest < 8 || read_u32(bytes, kHeader + json_length) > rest - 8)) {
        throw InputError(file, "second chunk is truncated", std::to_string(rest) + " bytes");
    }
    return bytes.substr(kHeader, json_length);
}

void check_depth(std::string_view text, const std::string& file) {
    int depth = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (in_string) {
            i += c == '\\' ? 1 : 0;
            in_string = c != '"';
        } else if (c == '"') {
            in_string = true;
        } else if (c == '[' || c == '{') {
            if (++depth > kDeepestJson) {
                throw InputError(file, "JSON nested too deeply",
                                 "more than " + std::to_string(kDeepestJson) + " levels");
            }
        } else if (c == ']' || c == '}') {
            --depth;
        }
    }
}

} // namespace

bool is_glb(std::string_view bytes) {
    return bytes.substr(0, 4) == "glTF";
}

std::string_view find_gltf_json(std::string_view bytes, const std::string& file) {
    const std::string_view text = is_glb(bytes) ? find_json_chunk(bytes, file) : bytes;
    check_depth(text, file);
    return text;
}

} // namespace alcove
