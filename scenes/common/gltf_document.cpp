#include "scenes/common/gltf_document.hpp"

#include "core/base/error.hpp"
#include "core/base/file.hpp"

#include <map>
#include <string_view>

#include <nlohmann/json.hpp>
#include <tiny_gltf.h>

namespace alcove {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestFile = std::uintmax_t{1} << 30;
constexpr int kDeepestJson = 256; ///< the parser recurses into `extras`

std::uint32_t read_u32(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
    }
    return value;
}

bool is_binary(std::string_view bytes) {
    return bytes.substr(0, 4) == "glTF";
}

/// The JSON text of a binary container. Throws unless header and chunks fit the file.
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

/// Before any parser runs: neither ours nor tinygltf's may be driven into deep recursion.
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

using FileMap = std::map<std::string, fs::path, std::less<>>;

/// The buffers' files by their decoded URI; every other name does not exist for the parser.
FileMap resolve_buffers(const nlohmann::json& json, const fs::path& path) {
    FileMap files;
    const auto buffers = json.find("buffers");
    if (buffers == json.end() || !buffers->is_array()) {
        return files;
    }
    for (std::size_t i = 0; i < buffers->size(); ++i) {
        const std::string where = path.string() + ": buffers[" + std::to_string(i) + "]";
        const nlohmann::json& buffer = (*buffers)[i];
        const bool has_length = buffer.is_object() && buffer.contains("byteLength") &&
                                buffer["byteLength"].is_number_unsigned();
        if (!has_length || buffer["byteLength"].get<std::uint64_t>() == 0 ||
            buffer["byteLength"].get<std::uint64_t>() > kLargestFile) {
            throw InputError(where, "byteLength is missing or out of range", {},
                             "1 to " + std::to_string(kLargestFile));
        }
        if (!buffer.contains("uri")) {
            continue;
        }
        if (!buffer["uri"].is_string()) {
            throw InputError(where + ".uri", "wrong type", {}, "a string");
        }
        const std::string uri = buffer["uri"].get<std::string>();
        if (uri.starts_with("data:")) {
            continue;
        }
        const std::string decoded = decode_percent(uri);
        try {
            files[decoded] = resolve_inside(path.parent_path(), decoded);
        } catch (const Error& error) {
            throw InputError(where + ".uri", error.what());
        }
        std::error_code error;
        const std::uintmax_t size = fs::file_size(files[decoded], error);
        if (error || size > kLargestFile || size < buffer["byteLength"].get<std::uint64_t>()) {
            throw InputError(where + ".uri", "missing, or not of the size told",
                             error ? uri + ": " + error.message() : std::to_string(size) + " bytes",
                             std::to_string(buffer["byteLength"].get<std::uint64_t>()) + " bytes");
        }
    }
    return files;
}

void check_json(const nlohmann::json& json, const std::string& file) {
    if (!json.is_object()) {
        throw InputError(file, "is not a glTF object");
    }
    const auto version = json.find("asset") != json.end() && json["asset"].is_object()
                             ? json["asset"].value("version", nlohmann::json())
                             : nlohmann::json();
    if (!version.is_string() || !version.get<std::string>().starts_with("2.")) {
        throw InputError(file + ": asset.version", "unsupported",
                         version.is_string() ? version.get<std::string>() : "none", "2.x");
    }
    if (const auto required = json.find("extensionsRequired"); required != json.end()) {
        for (const nlohmann::json& name : *required) {
            throw InputError(file + ": extensionsRequired", "not supported",
                             name.is_string() ? name.get<std::string>() : name.dump(), "none");
        }
    }
    // The parser takes the address of an image's first byte before it asks the loader.
    if (const auto images = json.find("images"); images != json.end() && images->is_array()) {
        for (std::size_t i = 0; i < images->size(); ++i) {
            const nlohmann::json& image = (*images)[i];
            const std::string where = file + ": images[" + std::to_string(i) + "].bufferView";
            if (!image.is_object() || !image.contains("bufferView")) {
                continue;
            }
            const nlohmann::json& view = image["bufferView"];
            const bool known = view.is_number_unsigned() && json.contains("bufferViews") &&
                               json["bufferViews"].is_array() &&
                               view.get<std::uint64_t>() < json["bufferViews"].size();
            if (!known) {
                throw InputError(where, "out of range");
            }
            const nlohmann::json& target = json["bufferViews"][view.get<std::size_t>()];
            const auto number = [&](const char* key) -> std::uint64_t {
                if (!target.is_object() || !target.contains(key)) {
                    return 0;
                }
                if (!target[key].is_number_unsigned()) {
                    throw InputError(where, "names a view that is malformed");
                }
                return target[key].get<std::uint64_t>();
            };
            const std::uint64_t buffer = number("buffer");
            const bool in_buffer = json.contains("buffers") && json["buffers"].is_array() &&
                                   buffer < json["buffers"].size() &&
                                   number("byteOffset") < json["buffers"][buffer].value(
                                                              "byteLength", std::uint64_t{0});
            if (!in_buffer) {
                throw InputError(where, "names a view outside its buffer");
            }
        }
    }
}

tinygltf::FsCallbacks make_callbacks(FileMap& files) {
    tinygltf::FsCallbacks callbacks{};
    callbacks.user_data = &files;
    callbacks.FileExists = [](const std::string& name, void* data) {
        return static_cast<const FileMap*>(data)->contains(name);
    };
    callbacks.ExpandFilePath = [](const std::string& name, void*) { return name; };
    callbacks.ReadWholeFile = [](std::vector<unsigned char>* out, std::string* error,
                                 const std::string& name, void* data) {
        const FileMap& known = *static_cast<const FileMap*>(data);
        const auto found = known.find(name);
        if (found == known.end()) {
            return false;
        }
        try {
            const std::string bytes = read_file(found->second, kLargestFile);
            out->assign(bytes.begin(), bytes.end());
            return true;
        } catch (const Error& failure) { // must not pass through the parser
            *error += failure.what();
            return false;
        }
    };
    callbacks.WriteWholeFile = [](std::string*, const std::string&,
                                  const std::vector<unsigned char>&, void*) { return false; };
    return callbacks;
}

bool ignore_image(tinygltf::Image*, const int, std::string*, std::string*, int, int,
                  const unsigned char*, int, void*) {
    return true;
}

} // namespace

std::string GltfDocument::name(const char* list, std::int64_t index) const {
    return file + ": " + list + "[" + std::to_string(index) + "]";
}

GltfDocument load_gltf(const fs::path& path) {
    GltfDocument document;
    document.file = path.string();
    const std::string bytes = read_file(path, kLargestFile);
    const std::string_view text =
        is_binary(bytes) ? find_json_chunk(bytes, document.file) : std::string_view(bytes);
    check_depth(text, document.file);
    FileMap files;
    std::string error;
    std::string warning;
    bool loaded = false;
    const auto model = std::make_shared<tinygltf::Model>();
    try {
        const nlohmann::json json = nlohmann::json::parse(text.begin(), text.end());
        check_json(json, document.file);
        files = resolve_buffers(json, path);
        tinygltf::TinyGLTF loader;
        loader.SetFsCallbacks(make_callbacks(files));
        loader.SetImageLoader(ignore_image, nullptr);
        const auto size = static_cast<unsigned int>(bytes.size());
        // Without a base folder the callbacks get the URIs as they stand.
        loaded =
            is_binary(bytes)
                ? loader.LoadBinaryFromMemory(model.get(), &error, &warning,
                                              reinterpret_cast<const unsigned char*>(bytes.data()),
                                              size, "")
                : loader.LoadASCIIFromString(model.get(), &error, &warning, bytes.data(), size, "");
    } catch (const Error&) {
        throw;
    } catch (const std::exception& failure) { // the parsers' own, on malformed input
        throw InputError(document.file, "is not valid glTF: " + std::string(failure.what()));
    }
    if (!loaded || !error.empty()) {
        throw InputError(document.file, "is not valid glTF: " + error);
    }
    document.model = model;
    return document;
}

} // namespace alcove
