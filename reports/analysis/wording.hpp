#pragma once
// How results are put for people, the same in the terminal and on the page.

#include "reports/analysis/analysis.hpp"

#include <string>

namespace alcove {

/// "2.500 [2.487, 2.513] (n=6)"; under 5 repeats "2.50 2.46..2.53 (n=3)". Digits follow the
/// interval's width.
[[nodiscard]] std::string describe_estimate(const Estimate& estimate);
/// Its parts: "2.500" and "[2.487, 2.513] (n=6)".
struct EstimateText {
    std::string value;
    std::string spread;
};
[[nodiscard]] EstimateText format_estimate(const Estimate& estimate);

/// "0.0452", or "< 0.0040" for a value under its floor ("> " where higher is better).
[[nodiscard]] std::string format_error(const MetricAnalysis& error);

/// The same in codes of an 8-bit image (times 255), as temporal flicker is read: "5.10".
[[nodiscard]] std::string format_codes(const MetricAnalysis& error);
/// The metric over time that is also put in codes.
inline constexpr std::string_view kFlickerMetric = "temporal_flicker";

/// "1 round", "2 rounds".
[[nodiscard]] std::string count_rounds(std::size_t rounds);

/// "3.1 %"
[[nodiscard]] std::string format_percent(double fraction);

/// Device class, renderer and threads: "software: llvmpipe (LLVM 15.0.6, 256 bits), 8 threads,
/// osmesa".
[[nodiscard]] std::string describe_device(const ContextRecord& context);
/// "timestamp_finish (validated in this context), tick 100 ns".
[[nodiscard]] std::string describe_timer(const RunAnalysis& analysis);
/// "A/A 1.000 [0.999, 1.001] (n=6): effects under 0.2 % cannot be told from noise".
[[nodiscard]] std::string describe_noise(const RoundAnalysis& round);
/// "24 repeats: the widest interval is +- 0.8 % (tssao), asked for +- 1 %"; empty where their
/// number was planned.
[[nodiscard]] std::string describe_repeats(const RunAnalysis& analysis, const RoundAnalysis& round);
/// "outlying repeats, kept: tssao 1 mild of 6"; empty where there is none.
[[nodiscard]] std::string describe_outliers(const RoundAnalysis& round);
/// "reference floor 0.0040 rmse, 9 % of the smallest error".
[[nodiscard]] std::string describe_floor(const RoundAnalysis& round);

/// What the round leaves out and why, and what that saved; empty where every effect was asked for.
[[nodiscard]] std::string describe_effects(const RoundAnalysis& round);

/// What the round decides, in a sentence: the methods on the front from cheap to accurate.
[[nodiscard]] std::string describe_verdict(const RoundAnalysis& round);

} // namespace alcove
