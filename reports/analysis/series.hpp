#pragma once
// Times by frame and repeat, summed where a frame has several rows (a pass that runs twice).

#include "core/base/statistics.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace alcove {

/// Segment and frame: a frame that stands in a burst and as a single is two.
using FrameKey = std::pair<int, int>;

class Series {
  public:
    void add(FrameKey frame, int repeat, std::int64_t time_ns);

    [[nodiscard]] bool empty() const noexcept { return m_times_ns.empty(); }
    [[nodiscard]] const std::map<FrameKey, std::map<int, double>>& times_ns() const noexcept {
        return m_times_ns;
    }
    [[nodiscard]] std::vector<double> get_repeats_ns(FrameKey frame) const;

    /// In each repeat the median over frames, in milliseconds.
    [[nodiscard]] std::map<int, double> compute_repeat_medians_ms() const;

  private:
    std::map<FrameKey, std::map<int, double>> m_times_ns;
};

/// Combines two series repeat by repeat, where both have the repeat.
template <class Combine>
std::map<int, double> combine_repeats(const std::map<int, double>& a,
                                      const std::map<int, double>& b, const Combine& combine) {
    std::map<int, double> result;
    for (const auto& [repeat, value] : a) {
        if (const auto found = b.find(repeat); found != b.end()) {
            result[repeat] = combine(value, found->second);
        }
    }
    return result;
}

/// Mean across repeats of the median over frames, in milliseconds; nothing for an empty series.
[[nodiscard]] std::optional<Estimate> estimate_time_ms(const Series& series);

/// The values of the repeats, without their numbers.
[[nodiscard]] std::vector<double> get_values(const std::map<int, double>& per_repeat);

/// Ratio a/b paired frame by frame (estimate_paired_ratio).
[[nodiscard]] std::optional<Estimate> estimate_ratio(const Series& a, const Series& b);
/// What that is made of: by repeat, the median over frames of log(a/b).
[[nodiscard]] std::map<int, double> compute_log_ratios(const Series& a, const Series& b);

} // namespace alcove
