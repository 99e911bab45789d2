#pragma once
// What a method's history state says over a sequence: ages, shares of pixels, sums.

#include "core/base/correspondence.hpp"
#include "core/base/history_state.hpp"

#include <string>
#include <vector>

namespace alcove {

/// A share or a mean over the surface pixels of one frame.
struct HistoryNumber {
    std::string name;
    double value = 0.0;
};

/// Name, unit and definition of each number that HistoryRecord gives, for the plan.
struct HistoryNumberInfo {
    std::string name;
    std::string title;
    std::string unit;
    std::string definition;
};
[[nodiscard]] const std::vector<HistoryNumberInfo>& list_history_numbers();

/// A state image without its border at the image's size: cropped from the middle after each texel
/// has been repeated where the method works at half resolution.
[[nodiscard]] Image fit_history_state(const Image& state, ImageSize size);

/// Convergence, samples and causes of one frame; nothing if there is no surface. `age` may be null.
[[nodiscard]] std::vector<HistoryNumber> count_history(const Image& state, const Image* age);

/// Follows one cell through one sequence.
class HistoryRecord {
  public:
    void reset();
    /// `state`: four channels as HistoryChannel says; `to_previous`: nothing on the first frame.
    void add(const Image& state, const Correspondence* to_previous);

    /// Frames since the surface point under each pixel lost history; 0 = in this frame. A point
    /// that the method kept although it was not visible before counts from then.
    [[nodiscard]] const Image& age() const { return m_age; }
    /// Share of the sequence's frames, without its first one, in which each pixel lost history.
    [[nodiscard]] Image compute_invalidated_share() const;
    /// Samples taken for each pixel in all frames.
    [[nodiscard]] const Image& samples() const { return m_samples; }

  private:
    Image m_age;
    Image m_invalidations;
    Image m_samples;
    int m_frames = 0; ///< that could have invalidated
};

} // namespace alcove
