#include "harness/run/profile_strip.hpp"

namespace alcove {

void ProfileStrip::add(const Image& visibility) {
    ALCOVE_ASSERT(visibility.channels() == 1, "visibility");
    const auto width = static_cast<std::size_t>(visibility.width());
    ALCOVE_ASSERT(m_rows.empty() || m_rows.front().size() == width, "frames of one size");
    const auto row = visibility.values().subspan(
        static_cast<std::size_t>(visibility.height() / 2) * width, width);
    m_rows.emplace_back(row.begin(), row.end());
}

Image ProfileStrip::make_image() const {
    ALCOVE_ASSERT(!m_rows.empty(), "a frame to show");
    const ImageSize size{static_cast<int>(m_rows.front().size()),
                         kFrameHeight * static_cast<int>(m_rows.size())};
    Image image(size, 1);
    for (int y = 0; y < size.height; ++y) {
        const std::vector<float>& row = m_rows[static_cast<std::size_t>(y / kFrameHeight)];
        for (int x = 0; x < size.width; ++x) {
            image.at(x, y) = row[static_cast<std::size_t>(x)];
        }
    }
    return image;
}

} // namespace alcove
