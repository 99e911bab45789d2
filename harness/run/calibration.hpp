#pragma once
// Calibrations: what `tune` fitted to a target, as a TOML file that a method specification may name
// in place of a preset ("tssao@tuned/preset.toml").
//
//   method = "tssao"
//   preset = "default"              # what the rest comes from
//   [parameters]
//   radius = "0.93 * scene_radius"  # numbers, or expressions over the target's radius
//   strength = 1.12
//   [origin]                        # how it was found: for people, not read back
//   ...

#include "harness/run/experiment.hpp"
#include "harness/run/units.hpp"

#include <filesystem>
#include <functional>

namespace alcove {

/// Reads the calibration that the specification names in place of a preset into `calibrated`, and
/// does nothing to one that names none. `resolve` turns the name into a path that may be read.
/// Throws InputError on another method, unknown keys, parameters or values.
void load_calibration(MethodSpec& spec, const Registry<MethodUnit>& methods,
                      const std::function<std::filesystem::path(const std::string&)>& resolve);

/// A calibrated value as the table reads it: expressions of numbers become numbers, rounded for
/// integers. Throws InputError on what is no expression or out of range.
[[nodiscard]] ParameterOverride evaluate_calibrated(const ParameterTable& table,
                                                    const ParameterOverride& value,
                                                    const ExpressionVariables& variables);

/// What load_calibration reads: the keys up to [origin], which the caller may append.
[[nodiscard]] std::string make_calibration_text(const std::string& method,
                                                const std::string& preset,
                                                const std::vector<ParameterOverride>& parameters);

} // namespace alcove
