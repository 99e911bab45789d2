#pragma once
// The claims of the paper by subject; for tssao.cpp alone.

#include "reports/papers/estimates.hpp"
#include "reports/papers/evidence.hpp"
#include "reports/papers/judge.hpp"

namespace alcove {

/// Table 2, figures 1, 11 and 13: times.
void judge_tssao_times(const Evidence& evidence, Judge& judge);
/// Table 1, figure 4 and the state machine: numbers that the histories report of themselves.
void judge_tssao_states(const Evidence& evidence, Judge& judge);
/// Figures 1, 6, 8, 9, 10, 12 and the text: errors, flicker, trails.
void judge_tssao_quality(const Evidence& evidence, Judge& judge);
/// What nothing here can decide, and why.
void list_tssao_untestable(Judge& judge);

[[nodiscard]] std::vector<PaperTable> make_tssao_tables(const Evidence& evidence);
[[nodiscard]] std::vector<PaperFigure> make_tssao_figures(const Evidence& evidence);

// Labels of the experiments beside this file.
inline constexpr const char* kDeferred = "none";
inline constexpr const char* kSsao = "SSAO";
inline constexpr const char* kTssao = "TSSAO";
inline constexpr const char* kTssao16 = "TSSAO k2=16";
inline constexpr const char* kTssao8 = "TSSAO k2=8";

/// Rounds of `table2`: the paper's 1600x1200, 1024x768 and 800x600, smaller by the scale.
inline constexpr std::size_t kLargest = 0;
inline constexpr std::size_t kMiddle = 1;
inline constexpr std::size_t kSmallest = 2;

} // namespace alcove
