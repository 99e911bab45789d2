#include "scenes/common/gltf_document.hpp"

#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "scenes/common/gltf_container.hpp"
#include "scenes/common/gltf_uri.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <string_view>

#include <nlohmann/json.hpp>
#include <tiny_gltf.h>

namespace alcove {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestFile = std::uintmax_t{1} << 30;
/// What a small file may make us read, and a large one a byte: views may be shared by accessors.
constexpr std::size_t kSmallFileBytes = std::size_t{1} << 30;
constexpr std::size_t kBytesPerByte = 16;
constexpr std::array<std::string_view, 3> kExtensions{
    "KHR_mesh_quantization", "KHR_texture_transform", "KHR_lights_punctual"};

std::string join(std::span<const std::string_view> names) {
    std::string text;
    for (const std::string_view name : names) {
        text += (text.empty() ? "" : ", ") + std::string(name);
    }
    return text;
}

/// A buffer may use the beginning of a file.
struct BufferFile {
    fs::path path;
    std::uintmax_t bytes = 0;
};
using FileMap = std::map<std::string, BufferFile, std::less<>>;

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
        BufferFile& file = files[decoded];
        file = {resolve_gltf_uri(path, decoded, where + ".uri"),
                buffer["byteLength"].get<std::uint64_t>()};
        std::error_code error;
        const std::uintmax_t size = fs::file_size(file.path, error);
        if (error || size > kLargestFile || size < file.bytes) {
            throw InputError(where + ".uri", "missing, or not of the size told",
                             error ? uri + ": " + error.message() : std::to_string(size) + " bytes",
                             std::to_string(file.bytes) + " bytes");
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
            if (!name.is_string() || !is_known_gltf_extension(name.get<std::string>())) {
                throw InputError(file + ": extensionsRequired", "not supported",
                                 name.is_string() ? name.get<std::string>() : name.dump(),
                                 "only " + join(kExtensions));
            }
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
            const std::string bytes = read_file(found->second.path, kLargestFile);
            const auto used = std::min<std::uintmax_t>(bytes.size(), found->second.bytes);
            out->assign(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(used));
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

/// Keeps what a data URI encodes; decoding is gltf_texture's. Of a buffer view, the parser has not
/// checked the length.
bool keep_image(tinygltf::Image* image, const int, std::string*, std::string*, int, int,
                const unsigned char* bytes, int size, void*) {
    if (image->bufferView < 0) {
        image->image.assign(bytes, bytes + size);
    }
    return true;
}

} // namespace

std::string GltfDocument::name(const char* list, std::int64_t index) const {
    return file + ": " + list + "[" + std::to_string(index) + "]";
}

void GltfDocument::charge(std::size_t bytes, const std::string& where) const {
    if (bytes > *allowance) {
        throw InputError(where, "the file unfolds into far more data than it holds", {},
                         "at most 1 GiB and 16 times its size");
    }
    *allowance -= bytes;
}

bool is_known_gltf_extension(std::string_view name) {
    return std::find(kExtensions.begin(), kExtensions.end(), name) != kExtensions.end();
}

GltfDocument load_gltf(const fs::path& path) {
    GltfDocument document;
    document.file = path.string();
    const std::string bytes = read_file(path, kLargestFile);
    const std::string_view text = find_gltf_json(bytes, document.file);
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
        loader.SetImageLoader(keep_image, nullptr);
        const auto size = static_cast<unsigned int>(bytes.size());
        // Without a base folder the callbacks get the URIs as they stand.
        loaded =
            is_glb(bytes)
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
        std::replace(error.begin(), error.end(), '\n', ' ');
        throw InputError(document.file, "is not valid glTF: " + error);
    }
    std::size_t byte_count = bytes.size();
    for (const tinygltf::Buffer& buffer : model->buffers) {
        byte_count += buffer.data.size();
    }
    document.allowance =
        std::make_shared<std::size_t>(kSmallFileBytes + kBytesPerByte * byte_count);
    const auto uses = [&model](const std::vector<std::string>& names) {
        return std::find(names.begin(), names.end(), "KHR_mesh_quantization") != names.end();
    };
    document.is_quantised = uses(model->extensionsUsed) || uses(model->extensionsRequired);
    document.path = path;
    document.model = model;
    return document;
}

} // namespace alcove
