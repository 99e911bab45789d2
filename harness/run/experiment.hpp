#pragma once
// What a run is asked for, before any scene is opened.

#include "core/base/image.hpp"
#include "core/base/parameters.hpp"
#include "core/base/target.hpp"
#include "core/frame/precision.hpp"
#include "core/gl/context.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace alcove {

/// Whose settings a cell has (DESIGN 3.8). common: the method maps the target to its own
/// parameters. calibrated: what `tune` fitted to the target. native: as the method comes, whatever
/// the target.
enum class SettingsKind { common, calibrated, native };
[[nodiscard]] std::string_view to_text(SettingsKind kind);
/// "common", "native": the kinds that every specification is run with; calibrated ones come from
/// files. Throws InputError with the nearest name, or where one is named twice or none.
[[nodiscard]] std::vector<SettingsKind> parse_settings(const std::vector<std::string>& texts);

/// "M[@PRESET][:key=value,...][#label]", where PRESET may be the path of a calibration
/// (calibration.hpp), which ends in .toml.
struct MethodSpec {
    std::string method;
    std::string preset = "default";
    std::vector<ParameterOverride> overrides{};
    std::string label{}; ///< the text after '#', else the specification itself
    SettingsKind settings = SettingsKind::common;
    /// Of a calibration: values may be expressions over `scene_radius`, the target's radius.
    std::vector<ParameterOverride> calibrated{};
};
/// Throws InputError naming `option` and the part that cannot be read. Names are checked when the
/// plan is made; calibrations are read by load_calibration.
[[nodiscard]] MethodSpec parse_method_spec(std::string_view text,
                                           std::string_view option = "--method");

/// "WxH", each 1 to 16384. Throws InputError.
[[nodiscard]] ImageSize parse_size(std::string_view text);

/// all: every pass of every method. automatic: only what the scene calls for (DESIGN 3.12).
enum class EffectsChoice { all, automatic };
[[nodiscard]] std::string_view to_text(EffectsChoice choice);
/// "all" or "auto". Throws InputError with the nearest name.
[[nodiscard]] EffectsChoice parse_effects_choice(std::string_view text);

/// Which frames of a walkthrough: the default segments, the quick ones, or ranges "A:B".
struct FrameChoice {
    enum class Kind { standard, quick, ranges };
    Kind kind = Kind::standard;
    std::vector<std::string> ranges; ///< each a segment; checked against the walkthrough
    /// Holds the pose of A before each [A,B) until histories have converged; ranges only.
    bool warm = false;
};

struct SceneChoice {
    std::string spec;                  ///< "NAME[:key=value,...]" or the path of a glTF file
    std::optional<FrameChoice> frames; ///< of its own; else the experiment's
};

/// A combination that an experiment leaves out, and why.
struct SkippedCombination {
    std::string label;
    std::string reason;
};

struct Experiment {
    std::string name = "default";
    std::string title;
    std::vector<SceneChoice> scenes; ///< empty: all reported scenes
    bool first_scene_only = false;   ///< only the first of them that can be opened
    std::vector<MethodSpec> methods;
    std::vector<SkippedCombination> skipped;
    /// Every method is run once with each; calibrated methods are calibrated alone.
    std::vector<SettingsKind> settings{SettingsKind::common};
    FrameChoice frames;
    // Axes that make rounds of their own: every combination is replayed.
    std::vector<ImageSize> sizes{{384, 288}};
    std::vector<std::string> targets{""}; ///< over the scene's default; empty: the default
    std::vector<Precision> precisions{Precision{}};
    EffectsChoice effects = EffectsChoice::all;
    int repeats = 6;
    /// Repeats go on until every cell's ratio to the anchor is known to this relative half-width.
    std::optional<double> until_width;
    std::optional<double> time_limit_s; ///< of a round's timing replays; only with until_width
    std::optional<int> most_repeats;    ///< only with until_width
    /// What errors are measured against; nothing: get_default_reference of each target.
    std::optional<MethodSpec> reference;
    int reference_rays_per_half = 32;
    std::vector<std::string> metrics; ///< parse_metric_spec; empty: list_default_metrics
    /// Image metrics also over parts of a frame (strata.hpp).
    bool measures_strata = false;
    /// Names of objects of every scene: image metrics also over the surface of each.
    std::vector<std::string> regions;
    /// Errors of single frames taken apart (DESIGN 3.7), and the best monotone curve of a method.
    bool explains_errors = false;
    bool counts_fetches = false; ///< of every pass, in a replay of its own
    std::uint64_t shuffle_seed = 1;
    double audit_share = 0.01;    ///< of what caches give, made anew and compared; 0 to 1
    std::uint64_t audit_seed = 1; ///< chooses which
    std::string command_line;     ///< for the record
};

/// What errors under a target are measured against where nothing is named: ray-traced visibility,
/// or path-traced radiance.
[[nodiscard]] MethodSpec get_default_reference(const Target& target);

/// 1 to this many timing replays.
inline constexpr int kMostRepeats = 10000;

/// Throws InputError, naming the `options` as they are written where they come from, unless widths
/// and limits are positive, there is a width if there is a limit, and the most repeats are enough
/// for a look at the intervals.
struct RepeatOptionNames {
    std::string until_width;
    std::string time_limit;
    std::string most_repeats;
};
void check_repeats(const Experiment& experiment, const RepeatOptionNames& options);

} // namespace alcove
