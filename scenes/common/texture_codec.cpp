#include "scenes/common/texture_codec.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

namespace alcove {
namespace {

constexpr int kLargestSide = 8192;

/// Throws unless the chunks fit the file and the last is IEND: where a PNG ends too early, the
/// library jumps out of its reader and leaks.
void check_png(std::span<const unsigned char> bytes, const std::string& where) {
    constexpr std::size_t kSignature = 8;
    constexpr std::size_t kFrame = 12; // length, name and checksum of a chunk
    std::size_t at = kSignature;
    while (at <= bytes.size() && bytes.size() - at >= kFrame) {
        std::size_t length = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            length = length << 8u | bytes[at + i];
        }
        if (length > bytes.size() - at - kFrame) {
            break;
        }
        if (std::equal(bytes.begin() + static_cast<std::ptrdiff_t>(at) + 4,
                       bytes.begin() + static_cast<std::ptrdiff_t>(at) + 8, "IEND")) {
            return;
        }
        at += kFrame + length;
    }
    throw InputError(where, "image is truncated", std::to_string(bytes.size()) + " bytes");
}

/// A name by which the library knows the format; nothing for formats that glTF does not have.
const char* name_format(std::span<const unsigned char> bytes, const std::string& where) {
    constexpr std::array<unsigned char, 4> kPng{0x89, 'P', 'N', 'G'};
    constexpr std::array<unsigned char, 3> kJpeg{0xFF, 0xD8, 0xFF};
    const auto starts_with = [bytes](std::span<const unsigned char> magic) {
        return bytes.size() > magic.size() && std::equal(magic.begin(), magic.end(), bytes.begin());
    };
    if (starts_with(kPng)) {
        check_png(bytes, where);
        return "texture.png";
    }
    if (starts_with(kJpeg)) {
        return "texture.jpg";
    }
    throw InputError(where, "is neither a PNG nor a JPEG image");
}

} // namespace

Texture decode_texture(std::span<const unsigned char> bytes, const std::string& where) {
    const char* name = name_format(bytes, where);
    OIIO::Filesystem::IOMemReader memory(bytes.data(), bytes.size());
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    // As a pointer in the configuration: with both, open() looks for a file of that name.
    void* proxy = &memory;
    config.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
    const auto input = OIIO::ImageInput::open(name, &config);
    if (!input) {
        throw InputError(where, "image cannot be read: " + OIIO::geterror());
    }
    const OIIO::ImageSpec spec = input->spec();
    if (spec.width < 1 || spec.height < 1 || spec.width > kLargestSide ||
        spec.height > kLargestSide || spec.nchannels < 1 || spec.nchannels > 4) {
        throw InputError(where, "image is too large or empty",
                         std::to_string(spec.width) + "x" + std::to_string(spec.height) + "x" +
                             std::to_string(spec.nchannels),
                         "at most 8192x8192x4");
    }
    const auto channels = static_cast<std::size_t>(spec.nchannels);
    Texture texture;
    texture.size = {spec.width, spec.height};
    std::vector<std::uint8_t> pixels(texture.size.pixel_count() * channels);
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, pixels.data())) {
        throw InputError(where, "image cannot be read: " + input->geterror());
    }
    texture.rgb.resize(texture.size.pixel_count() * 3);
    for (std::size_t i = 0; i < texture.size.pixel_count(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            texture.rgb[3 * i + k] = pixels[i * channels + (channels < 3 ? 0 : k)];
        }
    }
    return texture;
}

std::string encode_texture(const Texture& texture) {
    const OIIO::ImageSpec spec(texture.size.width, texture.size.height, 3, OIIO::TypeDesc::UINT8);
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = OIIO::ImageOutput::create("texture.png", &memory);
    if (!output || !output->open("texture.png", spec) ||
        !output->write_image(OIIO::TypeDesc::UINT8, texture.rgb.data()) || !output->close()) {
        throw FailureError("texture " + texture.name, "cannot be encoded as PNG");
    }
    return {bytes.begin(), bytes.end()};
}

} // namespace alcove
