#pragma once
// From an experiment to a plan: axes -> cells -> rounds. The record is the plan: what is run, and
// resumed, is read from it alone.

#include "harness/run/experiment.hpp"
#include "harness/run/units.hpp"
#include "reports/record/record.hpp"

namespace alcove {

/// Largest number of methods in a round, beside the anchor twice.
inline constexpr std::size_t kMethodsPerRound = 8;

struct MadePlan {
    PlanRecord record;
    std::vector<std::string> warnings;
};

/// Opens each scene once to learn its radius, size and walkthrough. A scene that cannot be opened
/// for want of a package is skipped with its reason. Throws InputError on unknown names and values
/// out of range, FailureError (exit 1) if no scene is left.
[[nodiscard]] MadePlan make_plan(const Experiment& experiment, const Units& units);

/// A method's cell under a target, without id. `scene_radius_m` is the scene's own AO radius: what
/// native settings are made for. Throws InputError.
[[nodiscard]] CellRecord make_cell_record(const MethodUnit& unit, const MethodSpec& spec,
                                          const Target& target, double scene_radius_m);

/// The cell with other values of some parameters, which the unit's table can read.
[[nodiscard]] CellRecord override_cell(const MethodUnit& unit, CellRecord cell,
                                       const std::vector<ParameterOverride>& overrides);

/// A cell's parameters, read back from the record.
[[nodiscard]] ResolvedParameters read_parameters(const MethodUnit& unit, const CellRecord& cell);

} // namespace alcove
