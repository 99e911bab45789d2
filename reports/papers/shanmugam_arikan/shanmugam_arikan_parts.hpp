#pragma once
// The claims of the paper by subject; for shanmugam_arikan.cpp alone.

#include "reports/papers/estimates.hpp"
#include "reports/papers/evidence.hpp"
#include "reports/papers/findings.hpp"
#include "reports/papers/judge.hpp"

#include <span>

namespace alcove {

/// Figure 5 and molecules: both parts against long rays, and over-occlusion.
void judge_shanmugam_arikan_figure5(const Evidence& evidence, Judge& judge);
/// Layers, planes, reach, closed room, deforming figures and limits.
void judge_shanmugam_arikan_quality(const Evidence& evidence, Judge& judge);
/// Neighbours, billboards, shares of a frame, polygons.
void judge_shanmugam_arikan_times(const Evidence& evidence, Judge& judge);
/// What nothing here can decide, and why.
void list_shanmugam_arikan_untestable(Judge& judge);

[[nodiscard]] std::vector<PaperTable> make_shanmugam_arikan_tables(const Evidence& evidence);
[[nodiscard]] std::vector<PaperFigure> make_shanmugam_arikan_figures(const Evidence& evidence);

/// The address of a cell that ran as its method comes, not mapped to the target: all of ours.
[[nodiscard]] CellAddress find_native(const std::string& part, const std::string& label,
                                      std::size_t round = 0);
/// Mean of a metric over a cell's frames.
[[nodiscard]] Estimate estimate_native(const Evidence& evidence, const std::string& part,
                                       const std::string& label, const std::string& metric,
                                       std::size_t round = 0);
/// Metric of a - of b, frame by frame; labels of one part.
[[nodiscard]] Estimate compare_native(const Evidence& evidence, const std::string& part,
                                      const std::string& a, const std::string& b,
                                      const std::string& metric, std::size_t round = 0);

/// A cut-off of part `fill` and its label. A billboard's area goes with the square of the cut-off's
/// distance, 1 / (x (2 - x)) in squares of the sphere's radius with x = epsilon / (2 pi): equation
/// (5).
struct FillStep {
    const char* label;
    double epsilon;
    [[nodiscard]] double get_area() const;
};
[[nodiscard]] std::span<const FillStep> list_fill_steps();

/// Neighbours of part `neighbours`; the label is the number.
[[nodiscard]] const std::vector<double>& list_neighbour_counts();

inline constexpr const char* kNearPass = "shanmugam_arikan/near";
inline constexpr const char* kSpheresPass = "shanmugam_arikan/spheres";
inline constexpr const char* kFarPass = "shanmugam_arikan/far";

/// Rounds of part `figure5`, of part `layers` and of part `fill`.
inline constexpr std::size_t kStatue = 0;
inline constexpr std::size_t kMolecule = 1;
inline constexpr std::size_t kFoliage = 1;
inline constexpr std::size_t kUncut = 0;
inline constexpr std::size_t kCut = 1;

} // namespace alcove
