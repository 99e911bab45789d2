#pragma once
// The claims of the paper by subject; for ssdo.cpp alone.

#include "reports/papers/estimates.hpp"
#include "reports/papers/evidence.hpp"
#include "reports/papers/findings.hpp"
#include "reports/papers/judge.hpp"

#include <span>

namespace alcove {

/// Table 1 and what the text says of times.
void judge_ssdo_times(const Evidence& evidence, Judge& judge);
/// Figures 2, 3 and 4; constant, turning and detailed surroundings.
void judge_ssdo_light(const Evidence& evidence, Judge& judge);
/// Figures 5, 7 and 14; layers, cameras, samples, the border's fade, edges.
void judge_ssdo_samples(const Evidence& evidence, Judge& judge);
/// Figure 13, flicker, and "never worse".
void judge_ssdo_truth(const Evidence& evidence, Judge& judge);
/// Figures 6 and 8 to 12: shadows that correct shadow maps, and instant radiosity.
void judge_ssdo_shadows(const Evidence& evidence, Judge& judge);
/// What nothing here can decide, and why.
void list_ssdo_untestable(Judge& judge);

[[nodiscard]] std::vector<PaperTable> make_ssdo_tables(const Evidence& evidence);
[[nodiscard]] std::vector<PaperFigure> make_ssdo_figures(const Evidence& evidence);

/// A published cell pair of table 1: frames a second, and the printed overheads in percent, which
/// are losses of frames a second against ambient occlusion.
struct SsdoRow {
    const char* size;
    std::size_t round; ///< of part `table1`
    int samples;
    double ssao_fps;
    double ssdo_fps;
    double ssdo_loss;
    double bounce_fps;
    double bounce_loss;
    const char* misprint; ///< "" where the cells agree with each other
    int first_claim;      ///< number of the claim of ssao_fps; the others follow in this order
};
[[nodiscard]] std::span<const SsdoRow> list_ssdo_rows();
/// "1200x960 as printed" and its neighbours, by the rounds of part `table1`.
[[nodiscard]] std::span<const char* const> list_ssdo_sizes();

/// Labels of table 1's cells: "SSAO 8", "SSDO 8", "bounce 8".
[[nodiscard]] CellAddress find_table1_cell(std::size_t round, const char* what, int samples);
/// Percent of ambient occlusion's frames a second (or of those that its passes alone would reach)
/// that `what` loses.
[[nodiscard]] Estimate estimate_frame_loss(const Evidence& evidence, std::size_t round,
                                           const char* what, int samples);
[[nodiscard]] Estimate estimate_pass_loss(const Evidence& evidence, std::size_t round,
                                          const char* what, int samples);

/// a's metric - b's, frame by frame; cells of one round.
[[nodiscard]] Estimate compare_values(const Evidence& evidence, const std::string& part,
                                      std::size_t round, const std::string& a, const std::string& b,
                                      const std::string& metric);
/// A round's scene without its options: how it is lit is said by the part.
[[nodiscard]] std::string name_scene(const Evidence& evidence, const std::string& part,
                                     std::size_t round);
/// Mean of a metric over a cell's frames.
[[nodiscard]] Estimate estimate_value(const Evidence& evidence, const std::string& part,
                                      std::size_t round, const std::string& label,
                                      const std::string& metric);

/// Rounds of part `fig13`: two of each scene, near and full.
inline constexpr std::size_t kFig13Scenes = 20;
enum class Reach : std::size_t { near = 0, full = 1 };
[[nodiscard]] std::size_t find_fig13_round(std::size_t scene, Reach reach);

/// Frames of part `fig4` until which the panel's yellow side is in view.
inline constexpr std::size_t kFig4Seen = 18;

} // namespace alcove
