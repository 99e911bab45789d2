#include "core/base/image_file.hpp"

#include "core/base/error.hpp"
#include "core/base/file.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

namespace alcove {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kLargestImage = 1ull << 28; // values: 1 GiB of floats

/// What OpenImageIO says may have several lines; an error is one message.
std::string join_lines(std::string text) {
    while (text.ends_with('\n')) {
        text.pop_back();
    }
    for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at)) {
        text.replace(at, 1, "; ");
    }
    return text;
}

void write_image(const fs::path& path, const Image& image, OIIO::ImageSpec spec, Domain domain) {
    spec.attribute("alcove:domain", std::string(to_text(domain)));
    // Encoded in memory: the PNG writer does not notice a disk that is full.
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = OIIO::ImageOutput::create(path.string(), &memory);
    if (!output) {
        throw FailureError(path.string(),
                           "no writer for this kind of image: " + join_lines(OIIO::geterror()));
    }
    const bool encoded = output->open(path.string(), spec) &&
                         output->write_image(OIIO::TypeDesc::FLOAT, image.values().data()) &&
                         output->close();
    if (!encoded) {
        throw FailureError(path.string(),
                           "cannot encode the image: " + join_lines(output->geterror()));
    }
    write_file_atomically(path, std::string(bytes.begin(), bytes.end()));
}

} // namespace

ImageFile read_image_file(const fs::path& path, std::optional<Domain> domain) {
    if (!fs::is_regular_file(path)) {
        throw InputError(path.string(), fs::exists(path) ? "not a regular file" : "no such file");
    }
    const auto input = OIIO::ImageInput::open(path.string());
    if (!input) {
        throw InputError(path.string(), "not a readable image: " + join_lines(OIIO::geterror()));
    }
    const OIIO::ImageSpec& spec = input->spec();
    if (spec.width <= 0 || spec.height <= 0 || spec.nchannels <= 0 || spec.depth > 1 ||
        spec.image_bytes() == 0 ||
        static_cast<std::uint64_t>(spec.image_pixels()) *
                static_cast<std::uint64_t>(spec.nchannels) >
            kLargestImage) {
        throw InputError(path.string(), "image too large or empty",
                         std::to_string(spec.width) + "x" + std::to_string(spec.height) + "x" +
                             std::to_string(spec.nchannels),
                         "at most 2^28 values");
    }
    ImageFile file;
    file.image = Image({spec.width, spec.height}, spec.nchannels);
    const bool is_float = spec.format.is_floating_point();
    const std::string stored = spec.get_string_attribute("alcove:domain");
    if (domain) {
        file.domain = *domain;
    } else if (!stored.empty()) {
        file.domain = parse_domain(stored);
    } else {
        file.domain = is_float ? Domain::linear : Domain::srgb;
    }
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT,
                           file.image.values().data())) {
        throw InputError(path.string(),
                         "image data cannot be read: " + join_lines(input->geterror()));
    }
    return file;
}

void write_exr(const fs::path& path, const Image& image, Domain domain, ExrType type) {
    OIIO::ImageSpec spec(image.width(), image.height(), image.channels(),
                         type == ExrType::half_float ? OIIO::TypeDesc::HALF
                                                     : OIIO::TypeDesc::FLOAT);
    spec.attribute("compression", "zip");
    write_image(path, image, spec, domain);
}

void write_png(const fs::path& path, const Image& codes, Domain domain) {
    OIIO::ImageSpec spec(codes.width(), codes.height(), codes.channels(), OIIO::TypeDesc::UINT8);
    // The fastest level that still filters: half the time of the default for a tenth more bytes.
    spec.attribute("png:compressionLevel", 3);
    write_image(path, codes, spec, domain);
}

} // namespace alcove
