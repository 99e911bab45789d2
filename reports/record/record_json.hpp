#pragma once
// The run folder's JSON files as text and back. Keys are the record structs' member names.

#include "reports/record/record.hpp"
#include "reports/record/stability_record.hpp"
#include "reports/record/tune_record.hpp"

#include <string>
#include <string_view>

namespace alcove {

[[nodiscard]] std::string make_json(const ContextRecord& record);
[[nodiscard]] std::string make_json(const PlanRecord& record);
[[nodiscard]] std::string make_json(const RoundDone& record);
[[nodiscard]] std::string make_json(const StabilityRecord& record);
[[nodiscard]] std::string make_json(const TuneRecord& record);

/// Read strictly: a missing or unknown key, a wrong type, a number out of range, an id that is no
/// safe folder name or stands twice, a film or event out of bounds, an unknown kind of metric, or
/// another schema version is an InputError naming `file` and the key ("rounds[0].cells[2].id").
[[nodiscard]] ContextRecord parse_context_json(std::string_view text, std::string_view file);
[[nodiscard]] PlanRecord parse_plan_json(std::string_view text, std::string_view file);
[[nodiscard]] RoundDone parse_done_json(std::string_view text, std::string_view file);
/// What lies across keys is checked by read_stability.
[[nodiscard]] StabilityRecord parse_stability_json(std::string_view text, std::string_view file);

/// What lies across keys is checked by read_tune.
[[nodiscard]] TuneRecord parse_tune_json(std::string_view text, std::string_view file);

/// True for a name of [a-z0-9_.-] that is neither empty, "." nor "..", nor longer than 200, nor has
/// ".tmp" in it.
[[nodiscard]] bool is_safe_id(std::string_view id);

} // namespace alcove
