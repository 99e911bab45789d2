#pragma once
// Temporal profile: one row of pixels of every frame of a film, stacked from top to bottom. What
// stands still is a vertical line, what flickers a dotted one, what trails a slanted one that lags.

#include "core/base/image.hpp"

namespace alcove {

class ProfileStrip {
  public:
    /// Pixels that each frame is high, so that a short film can be seen.
    static constexpr int kFrameHeight = 4;

    /// Takes the middle row (height / 2) of an image. Asserts one width and number of channels from
    /// clear to clear.
    void add(const Image& image);
    void clear() { m_rows.clear(); }
    [[nodiscard]] bool is_empty() const { return m_rows.empty(); }
    /// Values as they were given; the first frame on top. Asserts that there is a frame.
    [[nodiscard]] Image make_image() const;

  private:
    std::vector<Image> m_rows; ///< one pixel high
};

} // namespace alcove
