#pragma once
// The claims of the paper by subject; for statvo.cpp alone.

#include "reports/papers/estimates.hpp"
#include "reports/papers/evidence.hpp"
#include "reports/papers/judge.hpp"

namespace alcove {

/// Table 1 and section 7: what passes take by the size and number of tables.
void judge_statvo_times(const Evidence& evidence, Judge& judge);
/// Figures 11 to 15, radius and resolution: times beside other methods.
void judge_statvo_rivals(const Evidence& evidence, Judge& judge);
/// Figures 6, 8, 9 and 13, flicker and pillars: layers and errors.
void judge_statvo_quality(const Evidence& evidence, Judge& judge);
/// What nothing here can decide, and why.
void list_statvo_untestable(Judge& judge);

[[nodiscard]] std::vector<PaperTable> make_statvo_tables(const Evidence& evidence);
[[nodiscard]] std::vector<PaperFigure> make_statvo_figures(const Evidence& evidence);

/// "8 views of cathedral at 320x180, ...": on what a round's numbers were found, and what its size
/// does to them where it is smaller than published.
[[nodiscard]] std::string describe_views(const Evidence& evidence, const std::string& part,
                                         std::size_t round = 0);

/// A row of Table 1: one pass, its milliseconds as published and the claims that print them.
struct StatvoRow {
    const char* title;
    std::vector<std::string> passes;
    double full_ms;
    double half_ms;
    const char* claims[3]; ///< full, half, speed-up
};
[[nodiscard]] const std::vector<StatvoRow>& list_statvo_rows();
/// Those that build tables.
[[nodiscard]] const std::vector<std::string>& list_statvo_table_passes();

/// Rounds of `rivals`: 1280x720 and 1024x768, smaller by the scale.
inline constexpr std::size_t kWide = 0;
inline constexpr std::size_t kNarrow = 1;

} // namespace alcove
