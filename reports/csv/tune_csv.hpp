#pragma once
// tune.csv: one line a setting that was tried; judgements.csv: one line a method, set of frames and
// metric. Columns: reports/README.md.

#include "reports/record/tune_record.hpp"

#include <string>

namespace alcove {

[[nodiscard]] std::string make_tune_csv(const TuneRecord& record);
[[nodiscard]] std::string make_judgements_csv(const TuneRecord& record);

} // namespace alcove
