#include "harness/run/round_runner.hpp"

#include "core/base/domain.hpp"
#include "core/base/hash.hpp"
#include "core/base/image_file.hpp"
#include "harness/run/error_map.hpp"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <random>

namespace alcove {
namespace {

/// Frames timed once a method's history has converged (DESIGN 3.5).
constexpr int kConvergedFrames = 8;
/// Seed of methods' noise; one for all runs, so that images are comparable between them.
constexpr std::uint32_t kNoiseSeed = 1;

/// Adds the wall time of its life to a sum.
class WallTime {
  public:
    explicit WallTime(double& seconds) : m_seconds(seconds) {}
    ~WallTime() { m_seconds += std::chrono::duration<double>(Clock::now() - m_begin).count(); }
    WallTime(const WallTime&) = delete;
    WallTime& operator=(const WallTime&) = delete;

  private:
    using Clock = std::chrono::steady_clock;
    double& m_seconds;
    Clock::time_point m_begin = Clock::now();
};

/// The cells' order in one frame of one repeat: a permutation that depends on the seed alone.
std::vector<std::size_t> shuffle_order(std::size_t count, std::uint64_t seed, int repeat,
                                       int frame) {
    Hasher hasher;
    hasher.add(seed).add(repeat).add(frame);
    std::mt19937_64 random(hasher.finish64());
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t i = count; i > 1; --i) {
        std::swap(order[i - 1], order[random() % i]);
    }
    return order;
}

} // namespace

RoundRunner::RoundRunner(gl::Context& context, gl::TimerMode timer_mode, const Units& units,
                         const PlanRecord& plan, const RoundRecord& round, const Scene& scene,
                         std::filesystem::path run_folder)
    : m_context(context), m_gl(context.functions()), m_units(units), m_plan(plan), m_round(round),
      m_scene(scene), m_run_folder(std::move(run_folder)),
      m_timer(m_gl, timer_mode), m_size{round.width, round.height},
      m_target(parse_target(round.target, {})), m_renderer(m_gl, scene), m_compose(m_gl, m_size),
      m_references(get_cache_folder(), units.methods.find("reference_ray_traced").content_hash) {
    const Precision precision = parse_precision(round.precision);
    m_gbuffers.emplace(kBaseChannels, GBuffer(m_gl, m_size, kBaseChannels, precision));
    m_cells.reserve(round.cells.size());
    for (const CellRecord& record : round.cells) {
        const MethodCell& cell =
            m_cells.emplace_back(context, units.methods.find(record.method), record, m_size);
        if (!m_gbuffers.contains(cell.channels())) {
            m_gbuffers.emplace(cell.channels(), GBuffer(m_gl, m_size, cell.channels(), precision));
        }
    }
    for (const MetricUnit& unit : units.metrics.units()) {
        if (unit.reported && !unit.is_temporal()) {
            m_metrics.emplace_back(&unit, unit.create(unit.parameters.resolve({}, {})));
        }
    }
    for (std::size_t s = 0; s < round.segments.size(); ++s) {
        for (int f = round.segments[s].begin; f < round.segments[s].end; ++f) {
            m_frames.push_back(
                {static_cast<int>(s), make_frame_view(scene.get_walkthrough(), f, m_size,
                                                      f == round.segments[s].begin)});
        }
    }
    m_context.check_errors();
}

RoundResult RoundRunner::run(const RoundEvents& events) {
    const std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();
    warm_up(m_frames.front());
    m_result.done = RoundDone{};
    for (int repeat = 0; repeat < m_plan.repeats; ++repeat) {
        time_repeat(repeat, events);
        events.repeat_done(m_result.samples, repeat + 1);
    }
    capture(events);
    m_references.prune();
    m_result.done.wall_s =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return std::move(m_result);
}

void RoundRunner::warm_up(const Frame& frame) {
    // Compilation and first use are timed apart: nothing of this frame is kept.
    render_gbuffers(frame, std::nullopt);
    for (MethodCell& cell : m_cells) {
        CellTimes times;
        const MethodInputs inputs = make_inputs(cell, frame.view);
        const MethodOutput output = cell.render(inputs, PassTiming::none, m_timer, times);
        compose(inputs, output, PassTiming::none);
        m_gl.Finish();
        m_context.check_errors();
    }
}

void RoundRunner::reset_histories() {
    for (MethodCell& cell : m_cells) {
        cell.method().reset_history();
    }
}

const GBuffer& RoundRunner::get_gbuffer(const MethodCell& cell) const {
    return m_gbuffers.at(cell.channels());
}

MethodInputs RoundRunner::make_inputs(const MethodCell& cell, const FrameView& view) const {
    MethodInputs inputs{view, get_gbuffer(cell)};
    inputs.geometry = cell.needs_geometry() ? &m_geometry : nullptr;
    inputs.lights = &m_scene.get_lights();
    inputs.noise_seed = kNoiseSeed;
    return inputs;
}

void RoundRunner::render_gbuffers(const Frame& frame, std::optional<int> repeat) {
    const WallTime wall(m_result.done.gbuffer_s);
    std::int64_t base_ns = 0;
    // The base comes first: it is the smallest set of channels.
    for (const auto& [channels, gbuffer] : m_gbuffers) {
        m_context.reset_state();
        m_gl.Finish();
        m_timer.begin();
        m_renderer.render(gbuffer, frame.view);
        m_timer.end();
        const std::int64_t time_ns = m_timer.collect().front();
        if (!repeat) {
            continue;
        }
        if (channels == kBaseChannels) {
            base_ns = time_ns;
            add_sample("harness", frame, *repeat, SampleKind::divided, SampleState::cold,
                       "input/base", time_ns);
            continue;
        }
        for (const MethodCell& cell : m_cells) {
            if (cell.channels() == channels) {
                add_sample(cell.record().id, frame, *repeat, SampleKind::divided, SampleState::cold,
                           "input/" + name_extra_channels(channels), time_ns - base_ns);
            }
        }
    }
    const bool needs_geometry =
        std::any_of(m_cells.begin(), m_cells.end(),
                    [](const MethodCell& cell) { return cell.needs_geometry(); });
    if (needs_geometry) {
        m_geometry = pose_geometry(m_scene, frame.view.time_s);
    }
}

void RoundRunner::add_sample(const std::string& cell, const Frame& frame, int repeat,
                             SampleKind kind, SampleState state, const std::string& pass,
                             std::int64_t time_ns) {
    SampleRow row;
    row.round = m_round.id;
    row.cell = cell;
    row.segment = frame.segment;
    row.frame = frame.view.index;
    row.repeat = repeat;
    row.kind = kind;
    row.state = state;
    row.pass = pass;
    row.time_ns = time_ns;
    m_result.samples.push_back(std::move(row));
}

void RoundRunner::add_cell_samples(const MethodCell& cell, const Frame& frame, int repeat,
                                   SampleState state, PassTiming timing, const CellTimes& times) {
    if (timing == PassTiming::envelope) {
        add_sample(cell.record().id, frame, repeat, SampleKind::envelope, state, "envelope",
                   times.pass_ns.front());
        return;
    }
    ALCOVE_ASSERT(times.passes.size() == times.pass_ns.size(), "one time a pass");
    for (std::size_t i = 0; i < times.passes.size(); ++i) {
        add_sample(cell.record().id, frame, repeat, SampleKind::divided, state, times.passes[i],
                   times.pass_ns[i]);
    }
}

void RoundRunner::compose(const MethodInputs& inputs, const MethodOutput& output,
                          PassTiming timing) {
    m_context.reset_state();
    m_gl.Finish();
    PassRecorder recorder(timing, &m_timer);
    m_compose.render(inputs.gbuffer, m_scene.get_lights().ambient, output.visibility,
                     output.radiance, recorder);
}

void RoundRunner::time_frame(const Frame& frame, int repeat) {
    render_gbuffers(frame, repeat);
    const WallTime wall(m_result.done.passes_s);
    const bool divided = (repeat + frame.view.index) % 2 != 0;
    for (const std::size_t index :
         shuffle_order(m_cells.size(), m_plan.shuffle_seed, repeat, frame.view.index)) {
        MethodCell& cell = m_cells[index];
        const MethodInputs inputs = make_inputs(cell, frame.view);
        const PassTiming timing = !cell.has_passes() ? PassTiming::none
                                  : divided          ? PassTiming::divided
                                                     : PassTiming::envelope;
        CellTimes times;
        const MethodOutput output = cell.render(inputs, timing, m_timer, times);
        if (timing != PassTiming::none) {
            add_cell_samples(cell, frame, repeat, SampleState::cold, timing, times);
        }
        if (cell.record().role == CellRole::method) {
            compose(inputs, output, PassTiming::divided);
            add_sample(cell.record().id, frame, repeat, SampleKind::divided, SampleState::cold,
                       "harness/compose", m_timer.collect().front());
        }
    }
}

void RoundRunner::time_repeat(int repeat, const RoundEvents& events) {
    const std::size_t all = m_frames.size() * static_cast<std::size_t>(m_plan.repeats + 1);
    for (const Frame& frame : m_frames) {
        if (!frame.view.history_valid) {
            reset_histories();
        }
        time_frame(frame, repeat);
        events.progress(++m_frames_done, all);
    }
    time_converged(repeat);
    m_context.check_errors();
}

std::vector<RoundRunner::Frame> RoundRunner::list_singles() const {
    std::vector<Frame> singles;
    for (const Frame& frame : m_frames) {
        if (m_round.segments[static_cast<std::size_t>(frame.segment)].is_single()) {
            singles.push_back(frame);
        }
    }
    return singles;
}

void RoundRunner::time_converged(int repeat) {
    const std::vector<Frame> singles = list_singles();
    const bool any = std::any_of(m_cells.begin(), m_cells.end(), [](const MethodCell& cell) {
        return cell.record().warm_frames > 0;
    });
    if (singles.empty() || !any) {
        return;
    }
    std::vector<Frame> ends{singles.front()};
    if (singles.size() > 1) {
        ends.push_back(singles.back());
    }
    for (const Frame& single : ends) {
        const Frame held{single.segment, hold(single.view)};
        render_gbuffers(held, std::nullopt);
        const WallTime wall(m_result.done.passes_s);
        for (MethodCell& cell : m_cells) {
            if (cell.record().warm_frames == 0) {
                continue;
            }
            cell.method().reset_history();
            CellTimes times;
            for (int i = 0; i < cell.record().warm_frames; ++i) {
                const Frame& shown = i == 0 ? single : held;
                static_cast<void>(
                    cell.render(make_inputs(cell, shown.view), PassTiming::none, m_timer, times));
            }
            for (int i = 0; i < kConvergedFrames; ++i) {
                const PassTiming timing =
                    (repeat + i) % 2 != 0 ? PassTiming::divided : PassTiming::envelope;
                static_cast<void>(
                    cell.render(make_inputs(cell, held.view), timing, m_timer, times));
                add_cell_samples(cell, held, repeat, SampleState::converged, timing, times);
            }
        }
    }
}

void RoundRunner::capture(const RoundEvents& events) {
    const std::size_t all = m_frames.size() * static_cast<std::size_t>(m_plan.repeats + 1);
    m_result.done.reference_cached = true;
    for (const Frame& frame : m_frames) {
        if (!frame.view.history_valid) {
            reset_histories();
        }
        capture_frame(frame, SampleState::cold);
        events.progress(++m_frames_done, all);
    }
    for (const Frame& single : list_singles()) {
        capture_frame(single, SampleState::converged);
    }
}

void RoundRunner::capture_frame(const Frame& frame, SampleState state) {
    const bool is_converged = state == SampleState::converged;
    const auto takes_part = [is_converged](const MethodCell& cell) {
        return cell.record().role == CellRole::method &&
               (!is_converged || cell.record().warm_frames > 0);
    };
    if (std::none_of(m_cells.begin(), m_cells.end(), takes_part)) {
        return;
    }
    render_gbuffers(frame, std::nullopt);
    TraceSettings settings;
    settings.target = m_target;
    settings.rays_per_half = m_plan.reference_rays_per_half;
    // Noise that stood still on the screen would cancel in differences over time.
    settings.seed = static_cast<std::uint32_t>(frame.view.index);
    ReferencePair reference;
    {
        const WallTime wall(m_result.done.reference_s);
        bool was_cached = false;
        reference = m_references.get(m_scene, frame.view, settings, was_cached);
        m_result.done.reference_cached = m_result.done.reference_cached && was_cached;
    }
    const Image mean = compute_mean(reference);
    const bool keeps_images =
        std::find(m_round.image_frames.begin(), m_round.image_frames.end(), frame.view.index) !=
            m_round.image_frames.end() &&
        (is_converged || m_round.segments[static_cast<std::size_t>(frame.segment)].is_single() ||
         list_singles().empty());
    if (keeps_images && !is_converged) {
        write_picture("reference", frame.view.index, "visibility", encode_view(mean));
        gl::Texture truth(m_gl, GL_R32F, m_size);
        gl::write_texture(m_gl, truth, mean);
        compose({frame.view, m_gbuffers.at(kBaseChannels)}, {&truth, nullptr}, PassTiming::none);
        write_picture("reference", frame.view.index, "shaded",
                      encode_view(tone_map(gl::read_texture(m_gl, m_compose.picture(), 3))));
    }
    for (MethodCell& cell : m_cells) {
        if (!takes_part(cell)) {
            continue;
        }
        if (is_converged) {
            CellTimes times;
            cell.method().reset_history();
            for (int i = 0; i < cell.record().warm_frames; ++i) {
                const FrameView view = i == 0 ? frame.view : hold(frame.view);
                static_cast<void>(
                    cell.render(make_inputs(cell, view), PassTiming::none, m_timer, times));
            }
        }
        const Frame shown{frame.segment, is_converged ? hold(frame.view) : frame.view};
        // A method with history keeps its converged picture, the one that its table speaks of.
        const bool keeps = keeps_images && (is_converged || cell.record().warm_frames == 0 ||
                                            list_singles().empty());
        capture_cell(cell, shown, state, reference, mean, keeps);
    }
}

void RoundRunner::capture_cell(MethodCell& cell, const Frame& frame, SampleState state,
                               const ReferencePair& reference, const Image& reference_mean,
                               bool keeps_images) {
    const MethodInputs inputs = make_inputs(cell, frame.view);
    CellTimes times;
    MethodOutput output;
    {
        const WallTime wall(m_result.done.passes_s);
        output = cell.render(inputs, PassTiming::none, m_timer, times);
        m_gl.Finish();
    }
    m_context.check_errors();
    ALCOVE_ASSERT(output.visibility != nullptr, "methods so far give visibility");
    const Image visibility = gl::read_texture(m_gl, *output.visibility, 1);
    {
        const WallTime wall(m_result.done.metrics_s);
        const MetricInput images{visibility, reference_mean, &reference.a, &reference.b};
        const std::string image_hash = to_hex(hash_image(visibility));
        for (const auto& [unit, metric] : m_metrics) {
            MetricRow row;
            row.round = m_round.id;
            row.cell = cell.record().id;
            row.segment = frame.segment;
            row.frame = frame.view.index;
            row.state = state;
            row.metric = unit->name;
            row.image_hash = image_hash;
            if (visibility.width() < unit->smallest_side ||
                visibility.height() < unit->smallest_side) {
                row.note = "image smaller than the metric's window";
            } else {
                const MetricResult result =
                    evaluate_in_domain(*unit, *metric, images, Domain::visibility);
                row.value = result.value;
                row.debiased = result.debiased;
                row.floor = result.floor;
                row.note = result.undefined_reason;
            }
            m_result.metrics.push_back(std::move(row));
        }
    }
    if (keeps_images) {
        compose(inputs, output, PassTiming::none);
        const int index = frame.view.index;
        write_picture(cell.record().id, index, "visibility", encode_view(visibility));
        write_picture(cell.record().id, index, "error", make_error_map(visibility, reference_mean));
        write_picture(cell.record().id, index, "shaded",
                      encode_view(tone_map(gl::read_texture(m_gl, m_compose.picture(), 3))));
    }
}

void RoundRunner::write_picture(const std::string& cell, int frame, const char* picture,
                                const Image& codes) {
    const WallTime wall(m_result.done.images_s);
    write_png(m_run_folder / RunFolder::make_image_path(m_round.id, cell, frame, picture), codes,
              Domain::view);
}

} // namespace alcove
