#pragma once
// The run folder: what a run leaves behind, written so that a kill at any moment loses at most the
// round in flight, and read back without the program that made it. The layout and every column are
// documented in reports/README.md.
//
//   context.json                      build, device, timers: made once
//   plan.json                         what is to be run, with the description of every unit: made
//   once rounds/<id>/{samples.csv,metrics.csv,done.json}   a finished round; the folder appears by
//   one rename samples.csv, metrics.csv          all finished rounds, rebuilt after each
//   images/<round>/<cell>/...         pictures of the chosen frames
//   report/index.html                 the page

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace alcove {

/// Raised whenever a file's layout or a column's meaning changes; older and newer folders are
/// refused by name.
inline constexpr int kRunSchemaVersion = 6;

/// divided: one row a pass, timed pass by pass. envelope: one row a frame, timed as one piece.
/// Intervals and gates use the envelope.
enum class SampleKind { divided, envelope };
/// cold: as replayed, history reset at the segment's start. converged: time and camera held for
/// warm_frames() first.
enum class SampleState { cold, converged };

[[nodiscard]] std::string_view to_text(SampleKind kind);
[[nodiscard]] std::string_view to_text(SampleState state);

/// One time: one pass (or envelope) of one frame in one repeat.
struct SampleRow {
    std::string round;
    std::string
        cell; ///< a cell's id; "harness" for rows charged to nobody (base G-buffer, compose)
    int segment = 0;
    int frame = 0;
    int repeat = 0; ///< from 0
    SampleKind kind = SampleKind::divided;
    SampleState state = SampleState::cold;
    /// "hemisphere_ssao/occlusion"; "envelope" for kind envelope; "input/base", "input/motion",
    /// "harness/compose"
    std::string pass;
    std::int64_t time_ns = 0;
    bool cached = false; ///< input cost stored with a reused G-buffer; gates ignore it
};

/// One number of one metric for one frame's image.
struct MetricRow {
    std::string round;
    std::string cell;
    int segment = 0;
    int frame = 0;
    SampleState state = SampleState::cold;
    std::string metric;
    std::optional<double> value; ///< empty where infinite or undefined; `note` says why
    std::optional<double> debiased;
    std::optional<double> floor; ///< what the reference's own noise would give
    std::string note;
    std::string image_hash; ///< of the image that is measured, 16 hexadecimal digits
};

struct SegmentRecord {
    int begin = 0;
    int end = 0; ///< exclusive
    [[nodiscard]] bool is_single() const { return end - begin == 1; }
};

struct ParameterRecord {
    std::string name;
    std::string value;
    std::string unit;
    std::string symbol;
    std::string provenance;
};

/// What a cell is in its round. The two anchors are the A/A pair.
enum class CellRole { method, anchor, anchor_repeat };

/// CellRecord::settings of cells that are never compared with other rows.
inline constexpr std::string_view kNativeSettings = "native";

struct CellRecord {
    std::string id;    ///< unique in the run, safe as a folder name: [a-z0-9_.-]
    std::string label; ///< what people read: "hemisphere_ssao@strong_blur:samples=32"
    std::string method;
    std::string preset; ///< "default" if none
    /// "common": mapped to the target; "calibrated": fitted to it (`tune`); "native": as the method
    /// comes, whatever the target, and never compared with other rows (DESIGN 3.8).
    std::string settings = "common";
    CellRole role = CellRole::method;
    bool has_passes = true; ///< false for `none`: its time is 0 by definition and has no ratio row
    std::vector<ParameterRecord> parameters;
    std::string target;      ///< describe(Target) as asked for
    std::string target_note; ///< what the method cannot map, in words; empty if it maps all of it
    int warm_frames = 0;     ///< 0: one value stands in both the cold and the converged column
    std::string effects = "all"; ///< or "without object_motion,..."
    std::string sampling_pass;   ///< the one that takes samples; empty: their number is not known
    double samples_per_pixel = 0.0; ///< of the full-resolution image
};

/// Something that happens in a walkthrough: "cut", "box lifts".
struct EventRecord {
    int frame = 0;
    std::string label;
};

/// Whether a round calls for an effect, decided before it is measured.
struct EffectRecord {
    std::string effect;
    bool is_needed = true;
    std::string evidence; ///< for people
};

/// What leaving effects out has saved a cell.
struct SavingRecord {
    std::string cell;
    double ratio = 1.0; ///< time of G-buffer and passes, as planned over with all effects
    double lower = 1.0; ///< 95 % interval
    double upper = 1.0;
    int n = 0;                       ///< repeats
    double largest_difference = 0.0; ///< of what is measured, over all pixels and frames
};

struct RoundRecord {
    std::string id; ///< safe as a folder name
    std::string scene;
    std::string walkthrough;
    std::string target;
    int width = 0;
    int height = 0;
    std::string precision; ///< "raster_depth=32F,eye_depth=32F"
    std::vector<SegmentRecord> segments;
    /// Histories are converged on each segment's first pose before it is replayed.
    bool warm = false;
    std::vector<int> image_frames; ///< frames whose pictures are kept
    /// Frames of one burst whose pictures are all kept, to be played as a film; empty: begin = end.
    SegmentRecord film;
    std::vector<EventRecord> events;   ///< ascending in frame
    std::vector<EffectRecord> effects; ///< empty: all effects, without a decision
    CellRecord reference;              ///< what errors are measured against
    std::vector<CellRecord> cells;     ///< the anchor twice and up to 8 methods
    std::size_t scene_vertices = 0;
    std::size_t scene_triangles = 0;
    double ao_radius_m = 0.0;
};

/// Does its target, as describe(Target) writes it, ask for radiance? Then tone-mapped pictures are
/// measured and kept, not visibility.
[[nodiscard]] bool measures_pictures(const RoundRecord& round);

/// MetricDescription::kind of an image metric's value over part of a frame, and of the count of its
/// pixels: "METRIC[STRATUM]", "pixels[STRATUM]".
inline constexpr std::string_view kStratumKind = "stratum";

struct MetricDescription {
    std::string name;
    std::string title;
    std::string unit;
    std::string definition;
    std::string blind_to;
    std::string domain; ///< "values", "view", "linear" or "codes"
    /// "image": of one frame; "temporal": of a sequence; "history": what a method says of its own
    /// history, neither good nor bad. kStratumKind.
    std::string kind = "image";
    bool lower_is_better = true;
};

struct MethodDescription {
    std::string name;
    std::string title;
    std::string citation;
    std::string content_hash;
};

struct SceneDescription {
    std::string name;
    std::string title;
    std::string stresses;
    std::string license;
    std::string content_hash;
};

/// A scene that cannot be opened here, or a combination that the experiment leaves out.
struct SkippedRecord {
    std::string what;
    std::string reason; ///< with the command that mends it, if there is one
};

struct PlanRecord {
    int schema_version = kRunSchemaVersion;
    std::string experiment; ///< "default", "quick", "command-line"
    std::string title;      ///< for people; may be empty
    std::string command_line;
    int repeats = 0; ///< timing replays of a round; the fewest, if until_width is given
    /// Repeats go on until every interval is this narrow (relative half-width); 0: they do not.
    double until_width = 0.0;
    double time_limit_s = 0.0; ///< of a round's timing replays; 0: none
    int most_repeats = 0;      ///< where until_width is given
    std::uint64_t shuffle_seed = 0;
    int reference_rays_per_half = 0;
    bool explains_errors = false; ///< RoundDone::steps and curves are measured
    bool counts_fetches = false;  ///< RoundDone::fetches are counted
    double audit_share = 0.0;     ///< of what caches give, made anew and compared
    std::uint64_t audit_seed = 0;
    std::vector<RoundRecord> rounds;
    std::vector<SkippedRecord> skipped;
    std::vector<MethodDescription> methods;
    std::vector<MetricDescription> metrics;
    std::vector<SceneDescription> scenes;

    /// No round has more repeats.
    [[nodiscard]] int limit_repeats() const;
};

/// One line of `alcove doctor`'s timer table.
struct TimerTrialRecord {
    std::string mode;     ///< "timestamp_finish"
    std::string sequence; ///< "D", "C", "DD", "DC", "CD", "DCD"
    int pass = 0;         ///< index in the sequence
    int attempt = 0;      ///< from 0
    double ratio = 0.0;   ///< median of 9: pass in the sequence / that pass alone under wall clock
    bool accepted = false;
};

struct ContextRecord {
    int schema_version = kRunSchemaVersion;
    std::string started_utc; ///< ISO 8601
    std::string build_id;    ///< hash of sources, compiler and flags
    std::string build_type;
    std::string compiler;
    std::string device_class; ///< "software", "integrated", "discrete", "datacentre", "translated"
    std::string gl_vendor;
    std::string gl_renderer;
    std::string gl_version;
    std::string context_kind; ///< "osmesa"
    std::string cpu;
    std::string cpu_features; ///< those a driver's code generator looks at
    int cpu_threads = 0;
    int driver_threads = 0;
    std::string timer_mode; ///< accepted mode, or "fenced_wall"
    double timer_tick_ns = 0.0;
    std::vector<TimerTrialRecord> timer_trials;
    std::string anchor_version;
};

/// One of the things that decide a captured image or number.
struct IngredientRecord {
    std::string name; ///< "scene", "method's sources"
    std::string value;
};

/// The ingredient that says what a walkthrough shows: a hash of geometry and cameras.
inline constexpr std::string_view kShownIngredient = "geometry and camera";

/// Why a cell was captured, or was not.
struct ReuseRecord {
    std::string what;    ///< a cell's id, or "reference" for its pictures
    std::string outcome; ///< "reused", "made" or "audited": made, and equal to what was there
    std::string reason;  ///< for people
    std::vector<IngredientRecord> names;    ///< which cell it is
    std::vector<IngredientRecord> contents; ///< in which state
};

/// The error of one cell on one single frame, taken apart (DESIGN 3.7): with d1 = method - its
/// converged form, d2 = converged form - march, d3 = march - truth, total = d1 + d2 + d3 in every
/// pixel. Means over all pixels, in squared visibility. A method without a converged form has no
/// d1: d2 begins at the method's image.
struct StepRecord {
    std::string cell;
    int segment = 0;
    int frame = 0;
    double thickness = 0.0;          ///< of the march, in radii; may be infinite
    bool has_converged_form = false; ///< else d1 is 0
    double total = 0.0;              ///< mean (d1 + d2 + d3)^2
    double d1 = 0.0;                 ///< mean d1^2
    double d2 = 0.0;
    double d3 = 0.0;
    double d1_d2 = 0.0; ///< mean d1 d2; it enters the total twice
    double d1_d3 = 0.0;
    double d2_d3 = 0.0;
    double truth_noise = 0.0; ///< squared standard error of truth, part of total and of d3
    double march_noise = 0.0; ///< so for the march, part of d2 and of d3
};

/// The march of one thickness against truth: how the best constant thickness was chosen.
struct ThicknessRecord {
    double thickness = 0.0; ///< radii; may be infinite
    double mse = 0.0;       ///< against truth, mean over the round's single frames
    bool is_best = false;   ///< of the finite ones
};

/// What the best monotone curve of a cell's visibility mends: a slider's share of its error. Fitted
/// on every second single frame and judged on the others, both ways.
struct CurveRecord {
    std::string cell;
    int frames = 0;
    double mse = 0.0;               ///< of the image as it is
    double mse_fitted = 0.0;        ///< behind the curve, on the frames it was fitted on
    double mse_held_out = 0.0;      ///< ... on the frames that it was not
    std::vector<double> visibility; ///< ascending: the curve over all frames
    std::vector<double> curved;     ///< what it makes of them
};

/// What one pass of a cell fetches from textures and images.
struct FetchRecord {
    std::string cell;
    std::string pass; ///< "ssdo/direct"
    /// Over the pixels of the round's image, also where the pass covers fewer; mean over `frames`.
    double fetches_per_pixel = 0.0;
    int frames = 0;
};

/// What else the machine did during one timing replay. Empty where the system does not say.
struct MachineRecord {
    double wall_s = 0.0;
    std::optional<double> load;           ///< runnable threads, 1-minute average, ours included
    std::optional<double> others_share;   ///< of all processors' time, taken by other processes
    std::optional<double> steal_share;    ///< of all processors' time, taken by other guests
    std::optional<double> switches_per_s; ///< involuntary context switches of our threads
    std::optional<double> clock_mhz;      ///< mean over processors, at the replay's end
};

/// Why a round's timing replays ended.
enum class StopReason { planned, width, time, most };
[[nodiscard]] std::string_view to_text(StopReason reason);

/// How a round came by its number of repeats.
struct RepeatsRecord {
    int taken = 0;
    StopReason reason = StopReason::planned;
    /// Largest relative half-width of a ratio's 95 % interval when it ended, and whose; empty under
    /// 5 repeats.
    std::optional<double> widest;
    std::string widest_cell; ///< a cell's id
};

/// A round's closing note, beside its two CSVs.
struct RoundDone {
    double wall_s = 0.0;
    double gbuffer_s = 0.0; ///< parts of the wall time
    double passes_s = 0.0;
    double metrics_s = 0.0;   ///< of single images
    double temporal_s = 0.0;  ///< metrics over time with the geometry they need, history heatmaps
    double reference_s = 0.0; ///< tracing or reading the reference
    double images_s = 0.0;    ///< writing pictures
    bool reference_cached = false;
    int gbuffers_drawn = 0;
    int gbuffers_loaded = 0;
    int references_made = 0;
    int references_reused = 0;
    int audited = 0; ///< cached images, G-buffers and captures that were made again, and agreed
    std::vector<ReuseRecord> reuse;
    std::vector<SavingRecord> savings; ///< of cells that leave effects out
    double explaining_s = 0.0;         ///< steps and curves; part of the wall time, of no other
    std::vector<ThicknessRecord> thicknesses;
    std::vector<StepRecord> steps;
    std::vector<CurveRecord> curves;
    double counting_s = 0.0; ///< fetches; part of the wall time, of no other
    std::vector<FetchRecord> fetches;
    RepeatsRecord repeats;
    std::vector<MachineRecord> machine; ///< one a timing replay
};

/// A run folder on disk.
class RunFolder {
  public:
    /// Creates it. Throws InputError if it cannot be written to or already holds a run.
    [[nodiscard]] static RunFolder create(const std::filesystem::path& path,
                                          const ContextRecord& context, const PlanRecord& plan);
    /// Opens an existing one. Throws InputError naming the file, line or key on anything malformed,
    /// and on another schema version.
    [[nodiscard]] static RunFolder open(const std::filesystem::path& path);

    [[nodiscard]] const std::filesystem::path& path() const noexcept { return m_path; }
    [[nodiscard]] const ContextRecord& context() const noexcept { return m_context; }
    [[nodiscard]] const PlanRecord& plan() const noexcept { return m_plan; }

    [[nodiscard]] bool is_finished(const std::string& round_id) const;
    /// All rounds of the plan are finished.
    [[nodiscard]] bool is_complete() const;

    /// Writes rounds/<id> under a temporary name, syncs, renames, then rebuilds the two CSVs on
    /// top.
    void finish_round(const std::string& round_id, const std::vector<SampleRow>& samples,
                      const std::vector<MetricRow>& metrics, const RoundDone& done);
    /// Writes samples.csv and metrics.csv anew from the finished rounds.
    void rebuild_tables() const;

    /// Rows of all finished rounds.
    [[nodiscard]] std::vector<SampleRow> read_samples() const;
    [[nodiscard]] std::vector<MetricRow> read_metrics() const;
    [[nodiscard]] std::optional<RoundDone> read_done(const std::string& round_id) const;

    /// images/<round>/<cell>/<name>, relative to the run folder with '/' separators. `cell` may be
    /// "reference".
    [[nodiscard]] static std::string make_image_path(const std::string& round_id,
                                                     const std::string& cell_id, int frame,
                                                     std::string_view picture);

  private:
    RunFolder(std::filesystem::path path, ContextRecord context, PlanRecord plan);
    std::filesystem::path m_path;
    ContextRecord m_context;
    PlanRecord m_plan;
};

} // namespace alcove
