#include "scenes/common/gltf_texture.hpp"

#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "scenes/common/gltf_uri.hpp"
#include "scenes/common/gltf_view.hpp"
#include "scenes/common/texture_codec.hpp"

#include <span>
#include <utility>

#include <tiny_gltf.h>

namespace alcove {
namespace {

constexpr std::uintmax_t kLargestImageFile = std::uintmax_t{1} << 28;
constexpr std::size_t kMostTextureBytes = std::size_t{1} << 30;

} // namespace

std::optional<Texture> GltfTextures::read(int index) {
    const tinygltf::Image& image = m_document.model->images[static_cast<std::size_t>(index)];
    const std::string where = m_document.name("images", index);
    std::string beside; // the bytes of an image file
    std::span<const unsigned char> bytes(image.image);
    if (image.bufferView >= 0) {
        bytes = find_view(m_document, image.bufferView, where + ".bufferView");
    } else if (!image.uri.empty()) {
        const std::filesystem::path path =
            resolve_gltf_uri(m_document.path, decode_percent(image.uri), where + ".uri");
        try {
            beside = read_file(path, kLargestImageFile);
        } catch (const InputError& error) {
            m_warnings.insert(
                where + " is missing, surfaces keep their base colour factor: " + error.what());
            return std::nullopt;
        }
        bytes = {reinterpret_cast<const unsigned char*>(beside.data()), beside.size()};
    }
    Texture texture = decode_texture(bytes, where);
    texture.name = image.name.empty() ? "image" + std::to_string(index) : image.name;
    m_bytes += texture.rgb.size();
    if (m_bytes > kMostTextureBytes) {
        throw InputError(where, "the file's images are too large together", {},
                         "at most 1 GiB of pixels");
    }
    return texture;
}

std::optional<std::size_t> GltfTextures::find(int texture, const std::string& user) {
    const tinygltf::Model& model = *m_document.model;
    if (texture < 0 || static_cast<std::size_t>(texture) >= model.textures.size()) {
        throw InputError(user, "no such texture", std::to_string(texture),
                         "less than " + std::to_string(model.textures.size()));
    }
    const tinygltf::Texture& source = model.textures[static_cast<std::size_t>(texture)];
    const std::string where = m_document.name("textures", texture);
    if (source.source < 0) {
        m_warnings.insert(where + " has no PNG or JPEG image: surfaces keep their base colour");
        return std::nullopt;
    }
    if (static_cast<std::size_t>(source.source) >= model.images.size()) {
        throw InputError(where + ".source", "no such image", std::to_string(source.source),
                         "less than " + std::to_string(model.images.size()));
    }
    const auto known = m_known.find(source.source);
    if (known != m_known.end()) {
        return known->second;
    }
    std::optional<std::size_t> place;
    if (std::optional<Texture> read_texture = read(source.source)) {
        place = m_textures.size();
        m_textures.push_back(std::move(*read_texture));
    }
    m_known.emplace(source.source, place);
    return place;
}

} // namespace alcove
