#include "metrics/common/test_images.hpp"

#include <algorithm>
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

} // namespace alcove
