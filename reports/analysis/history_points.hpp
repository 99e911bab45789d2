#pragma once
// What a night leaves in the store: the points of a run folder.

#include "reports/record/record.hpp"
#include "reports/record/store.hpp"

#include <vector>

namespace alcove {

/// What draws, without versions: "software: llvmpipe, <processor>, 2 threads".
[[nodiscard]] std::string name_device(const ContextRecord& context);

/// The run as the store keeps it, but for commit and folder.
[[nodiscard]] StoredRun describe_night(const RunFolder& run);

/// Of every method of every finished round: envelope, passes and input costs over the anchor's
/// (input costs not where they are cached), absolute time, every metric (bursts cold, singles
/// converged, over time), and the hash of all its images. Throws InputError as RunFolder's readers
/// do.
[[nodiscard]] std::vector<NightPoint> collect_points(const RunFolder& run);

} // namespace alcove
