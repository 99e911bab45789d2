#include "metrics/common/test_images.hpp"

#include "core/base/domain.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace alcove {
namespace {

std::uint32_t hash_index(std::uint32_t x) {
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    return x ^ (x >> 16);
}

} // namespace

Image make_changed_ramp(const std::function<int(int, int, int)>& change) {
    Image image({256, 256}, 1);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const int code = std::clamp(change((x + y) / 2, x, y), 0, 255);
            image.at(x, y) = static_cast<float>(code) / 255.0f;
        }
    }
    return image;
}

Image make_ramp() {
    return make_changed_ramp([](int code, int, int) { return code; });
}

Image make_noisy_ramp() {
    return make_changed_ramp([](int code, int x, int y) {
        const auto index = static_cast<std::uint32_t>((y * 256 + x) * 3);
        return code + static_cast<int>(hash_index(index) % 17u) - 8;
    });
}

Image make_constant(int code) {
    return Image({64, 64}, 1, static_cast<float>(code) / 255.0f);
}

Image make_colour(int r, int g, int b) {
    Image image({64, 64}, 3);
    for (std::size_t i = 0; i < image.values().size(); ++i) {
        image.values()[i] = static_cast<float>(i % 3 == 0 ? r : i % 3 == 1 ? g : b) / 255.0f;
    }
    return image;
}

Image make_encoded(float linear) {
    return Image({64, 64}, 1, encode_srgb(linear));
}

Image make_firefly() {
    Image image({64, 64}, 1);
    image.at(32, 32) = 1.0f;
    return image;
}

Image make_step(int edge) {
    Image image({64, 64}, 1);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < edge; ++x) {
            image.at(x, y) = 1.0f;
        }
    }
    return image;
}

Image make_checkerboard() {
    Image image({64, 64}, 1);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            image.at(x, y) = static_cast<float>((x + y) % 2);
        }
    }
    return image;
}

Image make_colour_ramp() {
    return make_noisy_colour_ramp(0);
}

Image make_noisy_colour_ramp(int amplitude) {
    Image image({256, 256}, 3);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const std::array<int, 3> codes{x, y, (x + y) / 2};
            for (int c = 0; c < 3; ++c) {
                const auto index = static_cast<std::uint32_t>((y * 256 + x) * 3 + c);
                const auto range = static_cast<std::uint32_t>(2 * amplitude + 1);
                const int noise = static_cast<int>(hash_index(index) % range) - amplitude;
                image.at(x, y, c) = static_cast<float>(std::clamp(
                                        codes.at(static_cast<std::size_t>(c)) + noise, 0, 255)) /
                                    255.0f;
            }
        }
    }
    return image;
}

} // namespace alcove
