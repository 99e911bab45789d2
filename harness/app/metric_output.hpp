#pragma once
// What `metric` says: the JSON object, the table, the CSV of all pairs, and the maps.

#include "harness/app/image_pairs.hpp"
#include "harness/app/metric_means.hpp"
#include "reports/csv/csv_table.hpp"

#include <filesystem>

namespace alcove {

/// One object on standard output: means by their names, null where there is none (the reason goes
/// to standard error).
void print_means_json(const std::vector<MetricMean>& means);

/// Aligned columns: name, mean, unit; smallest, largest and n where there are several pairs.
/// Reasons of missing means go to standard error.
void print_means_table(const std::vector<MetricMean>& means);

/// Appends one line a metric: test, reference, metric, value, extras (name=value, apart by
/// spaces), counted_pixels, ignored_pixels (empty without a mask), note.
void append_pair_lines(CsvTable& table, const ImagePair& pair,
                       const std::vector<PairScore>& scores);

/// Writes each map as LABEL_METRIC.exr (as it is) and .png (magma, entry round(255 v), v clamped to
/// [0,1]) into a folder. Characters that do not belong in a file's name become `_`.
void write_maps(const std::filesystem::path& folder, const ImagePair& pair,
                const std::vector<PairScore>& scores);

} // namespace alcove
