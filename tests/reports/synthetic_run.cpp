#include "tests/reports/synthetic_run.hpp"

#include "core/base/image_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace alcove::synthetic {
namespace {

namespace fs = std::filesystem;

constexpr int kWarmFrames = 32;

std::int64_t to_ns(double value) {
    return static_cast<std::int64_t>(std::llround(value));
}

bool has_anchor_cost(const CellRecord& cell) {
    return cell.role != CellRole::method;
}

/// Cost in units of the anchor in one repeat.
double cost(const CellRecord& cell, int repeat, int repeats) {
    const double ratio = true_ratio(cell.id);
    return cell.role == CellRole::anchor ? ratio : ratio * repeat_factor(repeat, repeats);
}

CellRecord make_cell(const std::string& id, const std::string& label, CellRole role) {
    CellRecord cell;
    cell.id = id;
    cell.label = label;
    cell.method = label.substr(0, label.find_first_of("@:"));
    cell.preset = "default";
    cell.role = role;
    cell.target = "radius=0.5 m, falloff=linear, weighting=cosine, normals=shading";
    return cell;
}

std::vector<CellRecord> make_cells() {
    std::vector<CellRecord> cells = {
        make_cell("anchor", "anchor", CellRole::anchor),
        make_cell("anchor_repeat", "anchor (again)", CellRole::anchor_repeat),
        make_cell("none", "none", CellRole::method),
        make_cell("hemisphere_ssao", "hemisphere_ssao", CellRole::method),
        make_cell("hemisphere_ssao-samples64", "hemisphere_ssao:samples=64", CellRole::method),
        make_cell("tssao", "tssao", CellRole::method),
    };
    cells[2].has_passes = false;
    cells[3].parameters = {{"samples", "16", "samples", "n", "default"},
                           {"radius", "0.5", "m", "r", "default"}};
    cells[3].sampling_pass = "hemisphere_ssao/occlusion";
    cells[3].samples_per_pixel = 16.0;
    cells[4].parameters = {{"samples", "64", "samples", "n", "command line"},
                           {"radius", "0.5", "m", "r", "default"}};
    cells[4].target_note = "linear falloff is approximated by 1 / (1 + d)";
    cells[5].warm_frames = kWarmFrames;
    cells[5].preset = "sharp";
    cells[5].parameters = {{"history_cap", "1000", "samples", "n_max", "preset"}};
    return cells;
}

RoundRecord make_round(const std::string& id, const std::string& scene) {
    RoundRecord round;
    round.id = id;
    round.scene = scene;
    round.walkthrough = "walk";
    round.target = "radius=0.5 m, falloff=linear, weighting=cosine, normals=shading";
    round.width = 320;
    round.height = 180;
    round.precision = "raster_depth=32F,eye_depth=32F";
    round.segments = {{0, 16}, {40, 56}, {80, 96}};
    for (int k = 0; k < 8; ++k) {
        const int frame = (2 * k + 1) * kFrames / 16;
        round.segments.push_back({frame, frame + 1});
    }
    round.image_frames.assign(std::begin(kImageFrames), std::end(kImageFrames));
    round.reference = make_cell("reference", "reference_ray_traced", CellRole::method);
    round.cells = make_cells();
    round.scene_vertices = 48210;
    round.scene_triangles = 95004;
    round.ao_radius_m = 0.5;
    return round;
}

void make_hostile(PlanRecord& plan) {
    const std::string mark =
        "<img src=x onerror=document.title='owned'>\"'</script><script>document.title='owned'"
        "</script>&amp;<!--";
    plan.experiment += mark;
    plan.command_line += mark;
    for (RoundRecord& round : plan.rounds) {
        round.scene += mark;
        round.walkthrough += mark;
        round.target += mark;
        round.reference.label += mark;
        for (EventRecord& event : round.events) {
            event.label += mark;
        }
        for (CellRecord& cell : round.cells) {
            cell.label += mark;
            cell.target_note += mark;
            for (ParameterRecord& parameter : cell.parameters) {
                parameter.value += mark;
            }
        }
    }
    for (SkippedRecord& skipped : plan.skipped) {
        skipped.reason += mark;
    }
    for (MetricDescription& metric : plan.metrics) {
        metric.title += mark;
        metric.definition += mark;
    }
    for (SceneDescription& scene : plan.scenes) {
        scene.license += mark;
    }
}

/// A row of balls on a floor, seen from above at a slant: something that looks like occlusion.
float visibility_at(double x, double y, double shift, double strength) {
    double open = 1.0;
    if (y < 0.34) {
        return 1.0f;
    }
    for (int i = 0; i < 5; ++i) {
        const double cx = 0.16 + 0.36 * i - shift;
        const double dx = x - cx;
        const double dy = y - 0.62;
        const double r = std::sqrt(dx * dx + dy * dy);
        if (r < 0.12) {
            const double low = std::max(0.0, dy / 0.12);
            open = 1.0 - 0.75 * strength * low * low;
            break;
        }
        const double fx = dx / 0.17;
        const double fy = (y - 0.74) / 0.07;
        open *= 1.0 - 0.8 * strength * std::exp(-(fx * fx + fy * fy));
    }
    if (y < 0.4) {
        open *= 1.0 - 0.5 * strength * (0.4 - y) / 0.06;
    }
    return static_cast<float>(open);
}

void write_pictures(const fs::path& run, const RoundRecord& round, const std::string& cell,
                    int frame, double error) {
    const ImageSize size{round.width, round.height};
    Image visibility(size, 1);
    Image shaded(size, 3);
    Image map(size, 3);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const double u = static_cast<double>(x) / size.height;
            const double v = static_cast<double>(y) / size.height;
            const double shift = 0.004 * frame;
            const float truth = visibility_at(u, v, shift, 1.0);
            const double grain = std::sin(12.9898 * x + 78.233 * y) * 43758.5453;
            const double noise = (grain - std::floor(grain) - 0.5) * error * 3.0 * (truth < 0.999f);
            const float value = cell == "none"
                                    ? 1.0f
                                    : std::clamp(visibility_at(u, v, shift, 1.0 + 2.0 * error) +
                                                     static_cast<float>(noise),
                                                 0.0f, 1.0f);
            visibility.at(x, y) = encode_srgb(value);
            const float colour[3] = {0.72f, 0.66f, 0.55f};
            const float difference = std::clamp(4.0f * (value - truth), -1.0f, 1.0f);
            for (int c = 0; c < 3; ++c) {
                shaded.at(x, y, c) = encode_srgb(colour[c] * value * (v < 0.34 ? 1.0f : 0.8f));
            }
            map.at(x, y, 0) = difference < 0.0f ? 1.0f : 1.0f - difference;
            map.at(x, y, 1) = 1.0f - std::abs(difference);
            map.at(x, y, 2) = difference > 0.0f ? 1.0f : 1.0f + difference;
        }
    }
    if (measures_pictures(round)) {
        write_png(run / RunFolder::make_image_path(round.id, cell, frame, "picture"), shaded,
                  Domain::view);
    } else {
        write_png(run / RunFolder::make_image_path(round.id, cell, frame, "visibility"), visibility,
                  Domain::view);
        write_png(run / RunFolder::make_image_path(round.id, cell, frame, "shaded"), shaded,
                  Domain::view);
    }
    if (cell != "reference") {
        write_png(run / RunFolder::make_image_path(round.id, cell, frame, "error"), map,
                  Domain::srgb);
    }
}

/// The film's pictures of one frame of a cell: a flat one each, different for every kind and frame.
void write_film_frame(const fs::path& run, const RoundRecord& round, const std::string& cell,
                      int frame, const std::vector<std::string>& pictures) {
    for (std::size_t kind = 0; kind < pictures.size(); ++kind) {
        Image image({round.width, round.height}, 3);
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                const bool is_past = x * (round.film.end - round.film.begin) <
                                     (frame - round.film.begin + 1) * image.width();
                image.at(x, y, static_cast<int>(kind % 3)) = is_past ? 0.8f : 0.3f;
            }
        }
        write_png(run / RunFolder::make_image_path(round.id, cell, frame, pictures[kind]), image,
                  Domain::view);
    }
}

void write_film(const fs::path& run, const RoundRecord& round) {
    const std::string measured = measures_pictures(round) ? "film_picture" : "film_visibility";
    for (int frame = round.film.begin; frame < round.film.end; ++frame) {
        write_film_frame(run, round, "reference", frame, {measured});
        for (const CellRecord& cell : round.cells) {
            if (cell.role != CellRole::method) {
                continue;
            }
            std::vector<std::string> pictures = {measured, "film_error"};
            if (frame > round.film.begin) {
                pictures.emplace_back("film_temporal_flicker");
            }
            if (cell.warm_frames > 0) {
                pictures.insert(pictures.end(),
                                {"film_age", "film_cause", "film_convergence", "film_samples"});
            }
            if (frame + 1 == round.film.end) {
                pictures.emplace_back("accumulated_flicker_p95");
                if (cell.warm_frames > 0) {
                    pictures.insert(pictures.end(),
                                    {"accumulated_invalidations", "accumulated_samples"});
                }
            }
            write_film_frame(run, round, cell.id, frame, pictures);
        }
    }
}

RoundDone make_done(const Options& options) {
    RoundDone done;
    done.repeats.taken = options.repeats;
    for (int repeat = 0; repeat < options.repeats; ++repeat) {
        done.machine.push_back({10.0, 1.5, 0.02, 0.0, 40.0, 2400.0 + repeat});
    }
    done.fetches.push_back({"hemisphere_ssao", "hemisphere_ssao/occlusion", 18.5, 3});
    done.wall_s = 61.5;
    done.gbuffer_s = 4.0;
    done.passes_s = 40.0;
    done.metrics_s = 6.0;
    done.temporal_s = 1.5;
    done.reference_s = 9.5;
    done.images_s = 2.0;
    return done;
}

} // namespace

double true_ratio(const std::string& cell) {
    if (cell == "hemisphere_ssao") {
        return 2.5;
    }
    if (cell == "hemisphere_ssao-samples64") {
        return 8.0;
    }
    return cell == "tssao" ? 3.0 : 1.0;
}

double true_rmse(const std::string& cell, int frames_since_reset) {
    if (cell == "none") {
        return 0.12;
    }
    if (cell == "hemisphere_ssao") {
        return 0.06;
    }
    if (cell == "hemisphere_ssao-samples64") {
        return 0.045;
    }
    return 0.003 * (1.0 + 12.0 * std::exp2(-frames_since_reset));
}

double true_flicker(const std::string& cell) {
    if (cell == "none") {
        return 0.01;
    }
    return cell == "tssao" ? 0.001 : 0.02;
}

double anchor_ns(int frame, int repeat) {
    return 4e6 * (1.0 + 0.2 * std::sin(0.3 * frame)) * (1.0 + 0.05 * repeat);
}

double repeat_factor(int repeat, int repeats) {
    return std::exp(0.002 * (repeat - 0.5 * (repeats - 1)));
}

ContextRecord make_context() {
    ContextRecord context;
    context.started_utc = "2026-03-04T05:06:07Z";
    context.build_id = "00112233445566778899aabbccddeeff";
    context.build_type = "Release";
    context.compiler = "GNU 12.2.0";
    context.device_class = "software";
    context.gl_vendor = "Mesa";
    context.gl_renderer = "llvmpipe (LLVM 15.0.6, 256 bits)";
    context.gl_version = "4.5 (Core Profile) Mesa 22.3.6";
    context.context_kind = "osmesa";
    context.cpu = "A made-up processor";
    context.cpu_features = "avx2 fma";
    context.cpu_threads = 8;
    context.driver_threads = 8;
    context.timer_mode = "timestamp_finish";
    context.timer_tick_ns = 1000.0;
    context.timer_trials = {{"time_elapsed", "D", 0, 0, 0.0135, false},
                            {"timestamp_flush", "DC", 1, 0, 0.0538, false},
                            {"timestamp_finish", "DC", 0, 0, 1.004, true},
                            {"timestamp_finish", "DC", 1, 0, 0.997, true}};
    context.anchor_version = "1";
    return context;
}

PlanRecord make_plan(const Options& options) {
    PlanRecord plan;
    plan.experiment = "default";
    plan.command_line = "alcove run --size 320x180";
    plan.repeats = options.repeats;
    plan.shuffle_seed = 18364758544493064720ull;
    plan.reference_rays_per_half = 256;
    plan.rounds = {make_round("r0-balls", "balls:speed=fast"),
                   make_round("r1-courtyard", "courtyard")};
    if (options.radiance) {
        plan.rounds[0].target =
            "radius=0.5,falloff=linear,weighting=cosine,normals=shading,output=radiance,reach=near";
    }
    plan.rounds[0].film = kFilm;
    plan.rounds[0].events = {{4, "ball rolls"}, {40, "cut"}, {44, "box lifts"}, {60, "unseen"}};
    plan.rounds[1].events = {{80, "cut"}};
    plan.skipped = {{"sponza", "its mesh is not here: run `alcove scene fetch sponza`"}};
    plan.methods = {{"anchor", "Anchor", "", "aa"},
                    {"none", "No occlusion", "", "bb"},
                    {"hemisphere_ssao", "Hemisphere SSAO", "Author. Title. 2010.", "cc"},
                    {"tssao", "Temporal SSAO", "Mattausch, Scherzer, Wimmer. 2010.", "dd"}};
    plan.metrics = {{"rmse", "Root mean square error", "visibility",
                     "Square root of the mean squared difference of linear visibility.",
                     "Where the error stands and whether it flickers.", "values", "image", true},
                    {"ssim", "Structural similarity", "",
                     "Mean of local similarity in an 11x11 Gaussian window.", "Constant offsets.",
                     "view", "image", false}};
    const auto add = [&plan](const char* name, const char* title, const char* unit,
                             const char* kind) {
        plan.metrics.push_back({name, title, unit, std::string(title) + " by definition.",
                                "nothing here", "values", kind, true});
    };
    add("temporal_flicker", "Temporal flicker", "value", "temporal");
    add("flicker_ratio", "Flicker ratio", "1", "temporal");
    add("recovery_frames", "Recovery", "frames", "temporal");
    add("missed_invalidation", "Stale history kept", "share", "temporal");
    add("history_invalidated", "Pixels that lost history", "share", "history");
    add("history_samples", "Samples a pixel", "samples", "history");
    add("history_age", "Mean age", "frames", "history");
    plan.scenes = {{"balls", "Balls on a floor", "contact", "CC0-1.0", "ee"},
                   {"courtyard", "Courtyard", "thin features", "CC0-1.0", "ff"}};
    if (options.hostile) {
        make_hostile(plan);
    }
    return plan;
}

std::vector<SampleRow> make_samples(const PlanRecord& plan, const RoundRecord& round) {
    std::vector<SampleRow> rows;
    for (int s = 0; s < static_cast<int>(round.segments.size()); ++s) {
        const SegmentRecord& segment = round.segments[static_cast<std::size_t>(s)];
        const bool is_end = s == 3 || s == static_cast<int>(round.segments.size()) - 1;
        for (int frame = segment.begin; frame < segment.end; ++frame) {
            for (int repeat = 0; repeat < plan.repeats; ++repeat) {
                const auto add = [&](const std::string& cell, SampleKind kind, SampleState state,
                                     const std::string& pass, double ns) {
                    rows.push_back(
                        {round.id, cell, s, frame, repeat, kind, state, pass, to_ns(ns), false});
                };
                const double unit = anchor_ns(frame, repeat);
                const bool divided = (repeat + frame) % 2 == 1;
                add("harness", SampleKind::divided, SampleState::cold, "input/base", 10e6);
                for (const CellRecord& cell : round.cells) {
                    const double ns = unit * cost(cell, repeat, plan.repeats);
                    if (cell.id == "tssao") {
                        add(cell.id, SampleKind::divided, SampleState::cold, "input/motion", 0.5e6);
                    }
                    if (divided && cell.role == CellRole::method) {
                        add(cell.id, SampleKind::divided, SampleState::cold, "harness/compose",
                            1e6);
                    }
                    if (!cell.has_passes) {
                        continue;
                    }
                    if (cell.warm_frames > 0 && segment.is_single() && is_end) {
                        for (int i = 0; i < kHeldFrames; ++i) {
                            add(cell.id, SampleKind::envelope, SampleState::converged, "envelope",
                                0.5 * ns);
                        }
                    }
                    if (!divided) {
                        add(cell.id, SampleKind::envelope, SampleState::cold, "envelope", ns);
                    } else if (has_anchor_cost(cell)) {
                        add(cell.id, SampleKind::divided, SampleState::cold, "anchor/fetch",
                            1.02 * ns);
                    } else {
                        add(cell.id, SampleKind::divided, SampleState::cold,
                            cell.method + "/occlusion", 0.8 * ns);
                        add(cell.id, SampleKind::divided, SampleState::cold, cell.method + "/blur",
                            0.25 * ns);
                        add(cell.id, SampleKind::divided, SampleState::cold, cell.method + "/clear",
                            30e3);
                    }
                }
            }
        }
    }
    return rows;
}

/// What follows a burst of one cell; `age` counts its frames from 0.
void add_sequence_rows(std::vector<MetricRow>& rows, const MetricRow& place, int age,
                       bool is_last) {
    const auto add = [&](const char* metric, std::optional<double> value,
                         std::optional<double> debiased, std::optional<double> floor,
                         const char* note) {
        MetricRow row = place;
        row.metric = metric;
        row.value = value;
        row.debiased = debiased;
        row.floor = floor;
        row.note = note;
        rows.push_back(row);
    };
    const bool has_history = place.cell == "tssao";
    if (age > 0) {
        const double flicker = true_flicker(place.cell);
        add("temporal_flicker", std::hypot(flicker, 0.001), flicker, kFlickerFloor, "");
        add("flicker_ratio", has_history ? 0.25 : 0.75, {}, {}, "");
        if (has_history) {
            add("missed_invalidation", 0.001 * age, {}, {}, "");
        }
    }
    if (is_last && has_history) {
        add("recovery_frames", 5.0, {}, {}, "");
    } else if (is_last) {
        add("recovery_frames", {}, {}, {}, "nothing came into view");
    }
    if (has_history) {
        add("history_invalidated", age == 0 ? 1.0 : 0.02, {}, {}, "");
        add("history_samples", age == 0 ? kFirstSamples : kLaterSamples, {}, {}, "");
        add("history_age", static_cast<double>(age), {}, {}, "");
    }
}

std::vector<MetricRow> make_metrics(const RoundRecord& round) {
    std::vector<MetricRow> rows;
    for (int s = 0; s < static_cast<int>(round.segments.size()); ++s) {
        const SegmentRecord& segment = round.segments[static_cast<std::size_t>(s)];
        for (int frame = segment.begin; frame < segment.end; ++frame) {
            for (const CellRecord& cell : round.cells) {
                if (cell.role != CellRole::method) {
                    continue;
                }
                const auto add = [&](SampleState state, int age) {
                    const double rmse = true_rmse(cell.id, age);
                    rows.push_back({round.id, cell.id, s, frame, state, "rmse",
                                    std::hypot(rmse, 0.002), rmse, kRmseFloor, "",
                                    "0123456789abcdef"});
                    rows.push_back({round.id, cell.id, s, frame, state, "ssim", 1.0 - 2.0 * rmse,
                                    std::nullopt, std::nullopt, "", "0123456789abcdef"});
                };
                add(SampleState::cold, frame - segment.begin);
                if (cell.warm_frames > 0 && segment.is_single()) {
                    add(SampleState::converged, cell.warm_frames);
                    MetricRow row{round.id, cell.id, s,  frame, SampleState::converged, {}, {},
                                  {},       {},      {}, {}};
                    row.metric = "history_invalidated";
                    row.value = 0.0;
                    rows.push_back(row);
                    row.metric = "history_samples";
                    row.value = kConvergedSamples;
                    rows.push_back(row);
                }
                if (!segment.is_single()) {
                    add_sequence_rows(
                        rows,
                        {round.id, cell.id, s, frame, SampleState::cold, {}, {}, {}, {}, {}, {}},
                        frame - segment.begin, frame + 1 == segment.end);
                }
            }
        }
    }
    return rows;
}

RunFolder write_run(const fs::path& path, const Options& options) {
    RunFolder run = RunFolder::create(path, make_context(), make_plan(options));
    for (int i = 0; i < options.finished_rounds; ++i) {
        const RoundRecord& round = run.plan().rounds[static_cast<std::size_t>(i)];
        if (options.images) {
            for (const int frame : round.image_frames) {
                write_pictures(path, round, "reference", frame, 0.0);
                for (const CellRecord& cell : round.cells) {
                    // The last method of the second round keeps none, as a run cut short would.
                    if (cell.role == CellRole::method && !(i == 1 && cell.id == "tssao")) {
                        write_pictures(path, round, cell.id, frame,
                                       true_rmse(cell.id, kWarmFrames));
                    }
                }
            }
        }
        if (options.images) {
            write_film(path, round);
        }
        run.finish_round(round.id, make_samples(run.plan(), round), make_metrics(round),
                         make_done(options));
    }
    return RunFolder::open(path);
}

} // namespace alcove::synthetic
