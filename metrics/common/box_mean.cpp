#include "metrics/common/box_mean.hpp"

namespace alcove {

Image compute_box_means(const Image& image, int side, int before) {
    ALCOVE_ASSERT(image.channels() == 1, "one channel");
    const int width = image.width();
    const int height = image.height();
    Image means(image.size(), 1);
    std::vector<double> rows(static_cast<std::size_t>(width));
    for (int y = before; y + side - before <= height; ++y) {
        for (int x = 0; x < width; ++x) {
            double sum = 0.0;
            for (int k = 0; k < side; ++k) {
                sum += static_cast<double>(image.at(x, y - before + k));
            }
            rows[static_cast<std::size_t>(x)] = sum;
        }
        for (int x = before; x + side - before <= width; ++x) {
            double sum = 0.0;
            for (int k = 0; k < side; ++k) {
                sum += rows[static_cast<std::size_t>(x - before + k)];
            }
            means.at(x, y) = static_cast<float>(sum / static_cast<double>(side * side));
        }
    }
    return means;
}

Image subtract_images(const Image& a, const Image& b) {
    ALCOVE_ASSERT(a.size() == b.size() && a.channels() == b.channels(), "images of one shape");
    Image difference(a.size(), a.channels());
    for (std::size_t i = 0; i < difference.values().size(); ++i) {
        difference.values()[i] = a.values()[i] - b.values()[i];
    }
    return difference;
}

} // namespace alcove
