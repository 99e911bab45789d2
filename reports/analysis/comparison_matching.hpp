#pragma once
// Which cells of two runs are the same question.

#include "reports/analysis/comparison.hpp"

namespace alcove {

struct PlacedCell {
    const RoundRecord* round = nullptr;
    const CellRecord* cell = nullptr;
};

struct MatchedCells {
    std::vector<std::pair<PlacedCell, PlacedCell>> pairs; ///< BASE and NEW, in BASE's order
    std::vector<Unpaired> unpaired;
};

/// Finished rounds alone; unfinished ones are listed as unpaired. The runs must outlive the result.
[[nodiscard]] MatchedCells match_cells(const RunFolder& base, const RunFolder& next);

/// Parameters of two cells that differ.
[[nodiscard]] std::vector<ParameterChange> list_parameter_changes(const CellRecord& base,
                                                                  const CellRecord& next);

/// "0:16,40:56"
[[nodiscard]] std::string describe_segments(const RoundRecord& round);
/// Label and parameters: "reference_ray_traced samples=64".
[[nodiscard]] std::string describe_configuration(const CellRecord& cell);

/// "balls 320x180, walk, radius=0.5 m, ..."
[[nodiscard]] std::string describe_place(const RoundRecord& round);

} // namespace alcove
