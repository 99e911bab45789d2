#pragma once
// Metrics and images of one cell in two runs.

#include "reports/analysis/comparison.hpp"

namespace alcove {

/// A cell with its rows of metrics.csv.
struct MeasuredCell {
    const RunFolder& run;
    const RoundRecord& round;
    const CellRecord& cell;
    const std::vector<MetricRow>& rows;
};

/// Hashes of all images, and pictures of those that differ. Throws InputError on a picture that
/// cannot be read.
[[nodiscard]] ImageComparison compare_images(const MeasuredCell& base, const MeasuredCell& next);

/// Every metric and history number that both runs have. Identical images are the same, whatever
/// the numbers say.
[[nodiscard]] std::vector<QualityComparison>
compare_quality(const MeasuredCell& base, const MeasuredCell& next, const ImageComparison& images);

} // namespace alcove
