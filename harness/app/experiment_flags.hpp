#pragma once
// The flags that say what is replayed: an experiment's name or file, and what the command line puts
// in place of its keys. Shared by every verb that runs something.

#include "harness/run/experiment.hpp"
#include "harness/run/units.hpp"

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
} // namespace CLI

namespace alcove {

struct ExperimentFlags {
    std::string experiment; ///< name or path; empty: `fallback` of make_experiment
    bool quick = false;
    std::vector<std::string> scenes;
    std::vector<std::string> methods;
    std::vector<std::string> sweeps;
    std::vector<std::string> metrics;
    std::optional<std::string> size;
    std::optional<std::string> frames;
    std::optional<int> repeats;
    std::optional<double> until_width;
    std::optional<double> time_limit_s;
    std::optional<int> most_repeats;
    std::optional<std::string> target;
    std::optional<std::string> reference;
    bool warm = false;
    std::optional<std::string> precision;
    std::optional<std::string> effects;
    std::optional<std::string> settings;
    bool explain_errors = false;
    bool count_fetches = false;
    bool strata = false;
    std::optional<std::string> regions;
    std::optional<double> audit;

    /// The flags must outlive the parsing.
    void add_to(CLI::App& app);
};

/// The experiment with the flags over it: a list that is given replaces the file's. Throws
/// InputError.
[[nodiscard]] Experiment make_experiment(const ExperimentFlags& flags, const std::string& fallback,
                                         const std::string& command_line, const Units& units);

} // namespace alcove
