#pragma once
// Float images in memory. Files are image_file.hpp's, colour spaces domain.hpp's.

#include "core/base/assert.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace alcove {

/// Width and height in pixels.
struct ImageSize {
    int width = 0;
    int height = 0;
    [[nodiscard]] std::size_t pixel_count() const noexcept {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }
    friend bool operator==(const ImageSize&, const ImageSize&) = default;
};

/// Interleaved 32-bit float channels; row 0 is the top row. What the values mean (linear radiance,
/// visibility, sRGB codes) is said where an image is made, see Domain.
class Image {
  public:
    Image() = default;
    /// All values `fill`. Asserts positive sizes.
    Image(ImageSize size, int channels, float fill = 0.0f);

    [[nodiscard]] ImageSize size() const noexcept { return m_size; }
    [[nodiscard]] int width() const noexcept { return m_size.width; }
    [[nodiscard]] int height() const noexcept { return m_size.height; }
    [[nodiscard]] int channels() const noexcept { return m_channels; }
    [[nodiscard]] bool empty() const noexcept { return m_values.empty(); }

    [[nodiscard]] float& at(int x, int y, int channel = 0) {
        return m_values[index(x, y, channel)];
    }
    [[nodiscard]] float at(int x, int y, int channel = 0) const {
        return m_values[index(x, y, channel)];
    }
    [[nodiscard]] std::span<float> values() noexcept { return m_values; }
    [[nodiscard]] std::span<const float> values() const noexcept { return m_values; }

  private:
    [[nodiscard]] std::size_t index(int x, int y, int channel) const {
        ALCOVE_ASSERT_TIMED(x >= 0 && x < m_size.width && y >= 0 && y < m_size.height &&
                                channel >= 0 && channel < m_channels,
                            "pixel outside the image");
        return (static_cast<std::size_t>(y) * static_cast<std::size_t>(m_size.width) +
                static_cast<std::size_t>(x)) *
                   static_cast<std::size_t>(m_channels) +
               static_cast<std::size_t>(channel);
    }

    ImageSize m_size;
    int m_channels = 0;
    std::vector<float> m_values;
};

/// One channel of an image with several.
[[nodiscard]] Image take_channel(const Image& image, int channel);

/// Where the first NaN or infinite value stands.
struct PixelPosition {
    int x = 0;
    int y = 0;
    int channel = 0;
};

/// Finds the first value (row by row) that is NaN or infinite. Returns false if there is none.
[[nodiscard]] bool find_non_finite(const Image& image, PixelPosition& position);

/// 64-bit content hash of size, channels and the bits of every value.
[[nodiscard]] std::uint64_t hash_image(const Image& image);

} // namespace alcove
