#pragma once
// Experiments as TOML files. Keys and their meaning: harness/run/experiments/README.md. Strict: an
// unknown key, a wrong type or a value out of range is an error that names the file, the line and
// the nearest name.

#include "harness/run/experiment.hpp"
#include "harness/run/units.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace alcove {

/// Reads an experiment. `file` is what errors call it; paths of scenes that it names are relative
/// to `folder` and may not leave it. Methods, presets, parameters and metrics are checked here;
/// scenes and frames when the plan is made. Throws InputError.
[[nodiscard]] Experiment parse_experiment(std::string_view text, const std::string& file,
                                          const std::filesystem::path& folder, const Units& units);

/// The experiments that are part of the program, by name.
[[nodiscard]] std::vector<std::string> list_experiments();

/// An experiment by the name of a shipped one ("quick") or by path ("mine.toml"). Throws InputError
/// with the nearest name.
[[nodiscard]] Experiment load_experiment(const std::string& name_or_path, const Units& units);

} // namespace alcove
