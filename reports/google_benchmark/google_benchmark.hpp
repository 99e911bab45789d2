#pragma once
// A run's times in the JSON format of Google Benchmark, for tools that read that: compare.py,
// services that keep benchmarks.

#include "reports/record/record.hpp"

#include <string>

namespace alcove {

/// Of every method: envelope and passes, cold, one entry a repeat (the median over its frames, in
/// milliseconds) and, from two repeats, mean, median and standard deviation. The label of every
/// entry is the device class. `x_anchor` is the same frames' time over the anchor's. Throws
/// InputError as RunFolder's readers do.
[[nodiscard]] std::string make_google_benchmark_json(const RunFolder& run);

} // namespace alcove
