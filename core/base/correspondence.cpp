#include "core/base/correspondence.hpp"

#include <algorithm>
#include <cmath>

namespace alcove {
namespace {

/// The four pixels around a position and their weights.
struct BilinearTaps {
    int x0;
    int x1;
    int y0;
    int y1;
    float fx;
    float fy;
};

BilinearTaps find_taps(float x, float y, ImageSize size) {
    const float left = std::clamp(x - 0.5f, 0.0f, static_cast<float>(size.width - 1));
    const float top = std::clamp(y - 0.5f, 0.0f, static_cast<float>(size.height - 1));
    const int x0 = static_cast<int>(left);
    const int y0 = static_cast<int>(top);
    return {x0,
            std::min(x0 + 1, size.width - 1),
            y0,
            std::min(y0 + 1, size.height - 1),
            left - static_cast<float>(x0),
            top - static_cast<float>(y0)};
}

/// The position of the pixel itself.
float get_centre(int x, int y, int channel) {
    return 0.5f + static_cast<float>(channel == 0 ? x : y);
}

/// `position` of a correspondence interpolated as a displacement, so that clamping at the border
/// does not bend it.
float sample_displacement(const Image& position, const BilinearTaps& taps, int channel) {
    const auto at = [&](int x, int y) {
        return position.at(x, y, channel) - get_centre(x, y, channel);
    };
    const float upper = at(taps.x0, taps.y0) * (1.0f - taps.fx) + at(taps.x1, taps.y0) * taps.fx;
    const float lower = at(taps.x0, taps.y1) * (1.0f - taps.fx) + at(taps.x1, taps.y1) * taps.fx;
    return upper * (1.0f - taps.fy) + lower * taps.fy;
}

} // namespace

Correspondence make_identity_correspondence(ImageSize size) {
    Correspondence identity{Image(size, 2), Image(size, 1, 1.0f), Image(size, 1)};
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            identity.position.at(x, y, 0) = get_centre(x, y, 0);
            identity.position.at(x, y, 1) = get_centre(x, y, 1);
        }
    }
    return identity;
}

void warp_row(const Image& earlier, const Correspondence& correspondence, int y,
              std::span<float> out) {
    const ImageSize size = earlier.size();
    const auto width = static_cast<std::size_t>(size.width);
    const auto channels = static_cast<std::size_t>(earlier.channels());
    ALCOVE_ASSERT(size == correspondence.valid.size() && out.size() == width * channels,
                  "images and a row of one size");
    const auto row = static_cast<std::size_t>(y) * width;
    const float* valid = correspondence.valid.values().data() + row;
    const float* position = correspondence.position.values().data() + 2 * row;
    const auto find_pixel = [&](int x, int line) {
        return earlier.values().data() +
               (static_cast<std::size_t>(line) * width + static_cast<std::size_t>(x)) * channels;
    };
    for (std::size_t x = 0; x < width; ++x) {
        float* pixel = out.data() + x * channels;
        if (valid[x] == 0.0f) {
            std::fill_n(pixel, channels, 0.0f);
            continue;
        }
        const BilinearTaps taps = find_taps(position[2 * x], position[2 * x + 1], size);
        const float* upper_left = find_pixel(taps.x0, taps.y0);
        const float* upper_right = find_pixel(taps.x1, taps.y0);
        const float* lower_left = find_pixel(taps.x0, taps.y1);
        const float* lower_right = find_pixel(taps.x1, taps.y1);
        for (std::size_t c = 0; c < channels; ++c) {
            const float upper = upper_left[c] * (1.0f - taps.fx) + upper_right[c] * taps.fx;
            const float lower = lower_left[c] * (1.0f - taps.fx) + lower_right[c] * taps.fx;
            pixel[c] = upper * (1.0f - taps.fy) + lower * taps.fy;
        }
    }
}

Image warp_image(const Image& earlier, const Correspondence& correspondence) {
    Image warped(earlier.size(), earlier.channels());
    const std::size_t stride =
        static_cast<std::size_t>(warped.width()) * static_cast<std::size_t>(warped.channels());
    for (int y = 0; y < warped.height(); ++y) {
        warp_row(earlier, correspondence, y,
                 warped.values().subspan(static_cast<std::size_t>(y) * stride, stride));
    }
    return warped;
}

Correspondence compose_correspondences(const Correspondence& now_to_middle,
                                       const Correspondence& middle_to_earlier) {
    const ImageSize size = now_to_middle.valid.size();
    ALCOVE_ASSERT(size == middle_to_earlier.valid.size(), "images of one size");
    Correspondence composed{Image(size, 2), Image(size, 1), now_to_middle.appeared};
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            if (now_to_middle.appeared.at(x, y) != 0.0f) {
                continue;
            }
            const float middle_x = now_to_middle.position.at(x, y, 0);
            const float middle_y = now_to_middle.position.at(x, y, 1);
            const int nearest_x =
                std::clamp(static_cast<int>(std::floor(middle_x)), 0, size.width - 1);
            const int nearest_y =
                std::clamp(static_cast<int>(std::floor(middle_y)), 0, size.height - 1);
            composed.appeared.at(x, y) = middle_to_earlier.appeared.at(nearest_x, nearest_y);
            composed.valid.at(x, y) =
                now_to_middle.valid.at(x, y) * middle_to_earlier.valid.at(nearest_x, nearest_y);
            if (composed.appeared.at(x, y) != 0.0f) {
                continue;
            }
            const BilinearTaps taps = find_taps(middle_x, middle_y, size);
            composed.position.at(x, y, 0) =
                middle_x + sample_displacement(middle_to_earlier.position, taps, 0);
            composed.position.at(x, y, 1) =
                middle_y + sample_displacement(middle_to_earlier.position, taps, 1);
        }
    }
    return composed;
}

} // namespace alcove
