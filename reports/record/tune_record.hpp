#pragma once
// What `alcove tune` leaves behind: every setting that was tried, what was chosen, and how that
// does where it was not fitted. The layout is documented in reports/README.md.
//
//   tune.json             everything; written whole or not at all, anew after each method
//   <label>/preset.toml   the calibration, which `run --method M@FILE` reads
//   tune.csv, tune.html   made from the record

#include "reports/record/record.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace alcove {

inline constexpr int kTuneSchemaVersion = 1;

/// One setting that was tried.
struct TuneEvaluationRecord {
    int attempt = 0;                 ///< 0, and 1 for the restart from another seed
    std::string phase;               ///< "grid" or "search"
    std::vector<std::string> values; ///< of the free parameters, in their order
    double cost = 0.0; ///< mean of the objective over the training frames, small is good
};

/// A free parameter. Values are texts as a calibration has them.
struct TuneParameterRecord {
    std::string name;
    std::string unit; ///< "r" for multiples of the target's radius
    std::string tuned;
    /// Cost over the least cost with this parameter alone moved by a tenth of its range.
    double lower_ratio = 1.0;
    double upper_ratio = 1.0;
};

inline constexpr std::string_view kTrainingSet = "training";

/// A metric before and after, over one set of frames.
struct TuneJudgementRecord {
    std::string set; ///< kTrainingSet, "held-out frames", "held-out scenes"
    std::string metric;
    bool is_objective = false; ///< else it was not tuned on
    int frames = 0;
    double before = 0.0; ///< mean over frames
    double after = 0.0;
    double change = 0.0; ///< mean over frames of after - before
    double lower = 0.0;  ///< 95 % interval of it over frames; equal to `change` under 5 frames
    double upper = 0.0;
};

struct TunedMethodRecord {
    std::string id; ///< safe as a folder name
    std::string label;
    std::string method;
    std::string preset;
    int evaluations = 0; ///< allowed to each attempt: in proportion to the free parameters
    std::vector<TuneParameterRecord> parameters;
    std::vector<TuneEvaluationRecord> history;
    std::vector<double> least_costs; ///< of the attempts
    bool is_converged = false;       ///< the attempts end within kTuneAgreement of each other
    std::vector<TuneJudgementRecord> judgements;
    std::string calibration; ///< path of preset.toml inside the folder
};

/// Relative.
inline constexpr double kTuneAgreement = 0.02;

struct TuneSceneRecord {
    std::string scene;
    std::string target;
    bool is_held_out = false;
    std::vector<int> training; ///< frames
    std::vector<int> held_out;
};

struct TuneRecord {
    int schema_version = kTuneSchemaVersion;
    std::string command_line;
    ContextRecord context;
    int width = 0;
    int height = 0;
    std::string objective;
    std::string judge;
    bool objective_lower_is_better = true;
    bool judge_lower_is_better = true;
    int evaluations_per_parameter = 0;
    std::uint64_t seed = 0;
    std::vector<TuneSceneRecord> scenes;
    std::vector<TunedMethodRecord> methods;
};

/// How much of the gain is lost where it was not fitted: (gain on training - gain here) / gain on
/// training of the same metric, with gain = |before - after| with the sign of an improvement. 0: it
/// carries over whole; 1: nothing is left; more: worse than before. Nothing for training itself,
/// and where training gained nothing.
[[nodiscard]] std::optional<double> find_generalisation_gap(const TunedMethodRecord& method,
                                                            const TuneJudgementRecord& judged);

/// Writes <folder>/tune.json atomically. Throws FailureError.
void write_tune(const std::filesystem::path& folder, const TuneRecord& record);
/// Reads it strictly. Throws InputError naming file and key.
[[nodiscard]] TuneRecord read_tune(const std::filesystem::path& folder);

} // namespace alcove
