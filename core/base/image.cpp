#include "core/base/image.hpp"

#include "core/base/hash.hpp"

#include <cmath>

namespace alcove {

Image::Image(ImageSize size, int channels, float fill)
    : m_size(size), m_channels(channels),
      m_values(size.pixel_count() * static_cast<std::size_t>(channels), fill) {
    ALCOVE_ASSERT(size.width > 0 && size.height > 0 && channels > 0, "image sizes are positive");
}

Image take_channel(const Image& image, int channel) {
    Image single(image.size(), 1);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            single.at(x, y) = image.at(x, y, channel);
        }
    }
    return single;
}

bool find_non_finite(const Image& image, PixelPosition& position) {
    const std::span<const float> values = image.values();
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!std::isfinite(values[i])) {
            const auto channels = static_cast<std::size_t>(image.channels());
            const auto width = static_cast<std::size_t>(image.width());
            position.channel = static_cast<int>(i % channels);
            position.x = static_cast<int>(i / channels % width);
            position.y = static_cast<int>(i / channels / width);
            return true;
        }
    }
    return false;
}

std::uint64_t hash_image(const Image& image) {
    Hasher hasher;
    hasher.add(image.width()).add(image.height()).add(image.channels());
    hasher.add_bytes(std::as_bytes(image.values()));
    return hasher.finish64();
}

} // namespace alcove
