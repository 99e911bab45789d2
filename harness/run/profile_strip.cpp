#include "harness/run/profile_strip.hpp"

#include <algorithm>

namespace alcove {

void ProfileStrip::add(const Image& image) {
    ALCOVE_ASSERT(m_rows.empty() || (m_rows.front().width() == image.width() &&
                                     m_rows.front().channels() == image.channels()),
                  "frames of one shape");
    Image row({image.width(), 1}, image.channels());
    const std::size_t count = row.values().size();
    const auto middle =
        image.values().subspan(static_cast<std::size_t>(image.height() / 2) * count, count);
    std::copy(middle.begin(), middle.end(), row.values().begin());
    m_rows.push_back(std::move(row));
}

Image ProfileStrip::make_image() const {
    ALCOVE_ASSERT(!m_rows.empty(), "a frame to show");
    Image image({m_rows.front().width(), kFrameHeight * static_cast<int>(m_rows.size())},
                m_rows.front().channels());
    auto out = image.values().begin();
    for (const Image& row : m_rows) {
        for (int i = 0; i < kFrameHeight; ++i) {
            out = std::copy(row.values().begin(), row.values().end(), out);
        }
    }
    return image;
}

} // namespace alcove
