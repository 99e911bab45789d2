#include "harness/run/round_stage.hpp"

#include "core/base/error.hpp"
#include "core/contract/method_gbuffers.hpp"
#include "harness/run/environment.hpp"

#include <algorithm>

namespace alcove {

RoundStage::RoundStage(gl::Context& context, gl::TimerMode timer_mode, const Units& units,
                       const PlanRecord& plan, const RoundRecord& round, const Scene& scene)
    : m_context(context), m_units(units), m_plan(plan), m_round(round), m_scene(scene),
      m_timer(context.functions(), timer_mode), m_size{round.width, round.height},
      m_target(parse_target(round.target, {})), m_compose(context.functions(), m_size),
      m_surroundings(context.functions()),
      m_gbuffers(context.functions(), scene, m_size, parse_precision(round.precision),
                 GBufferStore(get_cache_folder(), describe_drawing(context)),
                 {plan.audit_share, plan.audit_seed},
                 describe_timing(context) + " " + std::string(gl::to_text(timer_mode))) {
    add_gbuffers({kBaseGBuffer});
    m_cells.reserve(round.cells.size());
    for (const CellRecord& record : round.cells) {
        m_cells.emplace_back(context, units.methods.find(record.method), record, m_size);
        add_gbuffers(list_keys(m_cells.back()));
    }
    for (std::size_t s = 0; s < round.segments.size(); ++s) {
        for (int f = round.segments[s].begin; f < round.segments[s].end; ++f) {
            RoundFrame frame{
                static_cast<int>(s),
                make_frame_view(scene.get_walkthrough(), f, m_size, f == round.segments[s].begin)};
            detect_motion(scene, frame.view);
            if (round.warm && f == round.segments[s].begin) {
                frame.is_warmed = true;
                frame.view = hold(frame.view);
            }
            m_frames.push_back(frame);
        }
    }
    m_loads_gbuffers = find_all_stored();
    m_context.check_errors();
}

std::vector<RoundFrame> RoundStage::list_singles() const {
    std::vector<RoundFrame> singles;
    for (const RoundFrame& frame : m_frames) {
        if (m_round.segments[static_cast<std::size_t>(frame.segment)].is_single()) {
            singles.push_back(frame);
        }
    }
    return singles;
}

std::vector<GBufferKey> RoundStage::list_keys(const MethodCell& cell) {
    std::vector<GBufferKey> keys{{cell.channels(), cell.border(), {}}};
    for (const GBufferPart& part : list_parts(cell.requests())) {
        const bool has_border = part.kind == PartKind::layer || part.kind == PartKind::back_faces;
        keys.push_back({get_part_channels(cell.requests(), part),
                        has_border ? cell.border() : Border{}, part});
    }
    return keys;
}

std::vector<GBufferKey> RoundStage::list_gbuffers() const {
    std::vector<GBufferKey> keys{kBaseGBuffer};
    for (const MethodCell& cell : m_cells) {
        for (const GBufferKey& key : list_keys(cell)) {
            if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
                keys.push_back(key);
            }
        }
    }
    return keys;
}

void RoundStage::add_gbuffers(const std::vector<GBufferKey>& keys) {
    for (const GBufferKey& key : keys) {
        m_gbuffers.add(key);
        m_views.try_emplace(key);
    }
}

std::vector<FrameView> RoundStage::list_views() const {
    std::vector<FrameView> views;
    for (const RoundFrame& frame : m_frames) {
        views.push_back(frame.view);
        const bool converges =
            std::any_of(m_cells.begin(), m_cells.end(),
                        [](const MethodCell& cell) { return cell.record().warm_frames > 0; });
        const bool is_single =
            m_round.segments[static_cast<std::size_t>(frame.segment)].is_single();
        if (converges && is_single) {
            views.push_back(hold(frame.view));
        }
    }
    return views;
}

bool RoundStage::find_all_stored() {
    const std::vector<GBufferKey> keys = list_gbuffers();
    for (const FrameView& view : list_views()) {
        for (const GBufferKey& key : keys) {
            if (!m_gbuffers.is_stored(key, m_gbuffers.get_view(key, view))) {
                return false;
            }
        }
    }
    for (std::size_t i = 0; i < m_frames.size(); ++i) {
        for (const GBufferKey& key : keys) {
            std::optional<std::vector<std::int64_t>> times =
                m_gbuffers.read_times(key, m_gbuffers.get_view(key, m_frames[i].view));
            if (!times || times->empty()) {
                m_stored_times.clear();
                return false;
            }
            m_stored_times[{i, key}] = std::move(*times);
        }
    }
    return true;
}

void RoundStage::set_frame(const FrameView& view) {
    m_frame.reset();
    for (auto& [key, shown] : m_views) {
        shown = m_gbuffers.get_view(key, view);
    }
    m_lights = m_scene.compute_lights(view.time_s);
    m_surroundings.update(m_lights);
    m_gbuffers.raster().set_frame(view);
    const bool needs_geometry =
        std::any_of(m_cells.begin(), m_cells.end(),
                    [](const MethodCell& cell) { return cell.needs_geometry(); });
    if (needs_geometry) {
        m_geometry = pose_geometry(m_scene, view.time_s);
    }
}

void RoundStage::set_frame(const RoundFrame& frame) {
    set_frame(frame.view);
    m_frame = static_cast<std::size_t>(&frame - m_frames.data());
    ALCOVE_ASSERT(*m_frame < m_frames.size(), "a frame of frames()");
}

std::optional<std::int64_t> RoundStage::time_gbuffer(const GBufferKey& key) {
    m_context.reset_state();
    gl().Finish();
    const FrameView& view = m_views.at(key);
    if (m_loads_gbuffers && m_gbuffers.load(key, view)) {
        gl().Finish();
        return std::nullopt;
    }
    return draw_gbuffer_timed(key);
}

std::int64_t RoundStage::draw_gbuffer_timed(const GBufferKey& key) {
    m_context.reset_state();
    m_gbuffers.prepare_shadows(m_views.at(key));
    m_context.reset_state();
    gl().Finish();
    PassRecorder recorder(PassTiming::divided, &m_timer);
    {
        const auto pass = recorder.scope("input");
        m_gbuffers.draw(key, m_views.at(key));
    }
    return m_timer.collect().front();
}

void RoundStage::render_gbuffer(const GBufferKey& key) {
    m_context.reset_state();
    gl().Finish();
    const FrameView& view = m_views.at(key);
    if (!m_gbuffers.load(key, view)) {
        m_gbuffers.draw(key, view);
    }
}

void RoundStage::render_gbuffers(const std::vector<GBufferKey>& keys) {
    for (const GBufferKey& key : keys) {
        render_gbuffer(key);
    }
}

std::span<const std::int64_t> RoundStage::find_stored_times(const GBufferKey& key) const {
    if (!m_frame) {
        return {};
    }
    const auto found = m_stored_times.find({*m_frame, key});
    return found == m_stored_times.end() ? std::span<const std::int64_t>{} : found->second;
}

void RoundStage::store_gbuffers(const GBufferTimes& times_ns) {
    const std::vector<GBufferKey> keys = list_gbuffers();
    m_context.reset_state();
    for (const FrameView& frame : list_views()) {
        for (const GBufferKey& key : keys) {
            const FrameView view = m_gbuffers.get_view(key, frame);
            if (m_gbuffers.is_stored(key, view)) {
                m_gbuffers.audit(key, view);
                continue;
            }
            m_gbuffers.draw(key, view);
            m_gbuffers.store(key, view);
        }
    }
    for (const auto& [place, times] : times_ns) {
        const auto& [frame, key] = place;
        m_gbuffers.write_times(key, m_gbuffers.get_view(key, m_frames[frame].view), times);
    }
    m_context.check_errors();
}

MethodInputs RoundStage::make_inputs(const MethodCell& cell) {
    const std::vector<GBufferKey> keys = list_keys(cell);
    MethodInputs inputs{m_views.at(keys.front()), m_gbuffers.get(keys.front())};
    for (const GBufferKey& key : keys) {
        add_part(inputs, key.part, m_gbuffers.get(key), m_views.at(key));
    }
    inputs.geometry = cell.needs_geometry() ? &m_geometry : nullptr;
    inputs.lights = &m_lights;
    inputs.surroundings = m_surroundings.look_through(inputs.view.camera);
    inputs.raster = &m_gbuffers.raster();
    inputs.noise_seed = kRoundNoiseSeed;
    return inputs;
}

MethodInputs RoundStage::make_measured_inputs(const MethodCell& cell) {
    MethodInputs inputs = make_inputs(cell);
    inputs.wants_visibility = !measures_pictures();
    return inputs;
}

Image RoundStage::read_measured(const MethodCell& cell, const MethodOutput& output) {
    if (!measures_pictures() && output.visibility == nullptr) {
        throw InputError(cell.record().label, "gives radiance alone, no visibility", m_round.target,
                         "a target with output=radiance");
    }
    Image image;
    if (measures_pictures()) {
        compose(&cell, output, PassTiming::none);
        image = tone_map(gl::read_texture(gl(), picture(), 3));
    } else {
        image = gl::read_texture(gl(), *output.visibility, 1);
    }
    m_context.check_errors();
    return image;
}

void RoundStage::prepare_histories(const RoundFrame& frame) {
    for (MethodCell& cell : m_cells) {
        if (frame.is_warmed) {
            FrameView begin = frame.view;
            begin.history_valid = false;
            warm_up(cell, begin);
        } else if (!frame.view.history_valid) {
            cell.method().reset_history();
        }
    }
}

void RoundStage::warm_up(MethodCell& cell, const FrameView& view) {
    cell.method().reset_history();
    for (int i = 0; i < cell.record().warm_frames; ++i) {
        if (i <= 1) {
            set_frame_of(cell, i == 0 ? view : hold(view));
            render_gbuffers(list_keys(cell));
        }
        CellTimes times;
        static_cast<void>(cell.render(make_inputs(cell), PassTiming::none, m_timer, times));
    }
    set_frame_of(cell, hold(view));
    std::vector<GBufferKey> keys = list_keys(cell);
    if (std::find(keys.begin(), keys.end(), kBaseGBuffer) == keys.end()) {
        keys.push_back(kBaseGBuffer);
    }
    render_gbuffers(keys);
}

void RoundStage::set_frame_of(const MethodCell& cell, const FrameView& view) {
    set_frame(view);
    const bool is_posed = std::any_of(m_cells.begin(), m_cells.end(), [](const MethodCell& other) {
        return other.needs_geometry();
    });
    if (cell.needs_geometry() && !is_posed) {
        m_geometry = pose_geometry(m_scene, view.time_s);
    }
}

void RoundStage::draw(const GBuffer& gbuffer) {
    m_context.reset_state();
    m_gbuffers.draw_into(gbuffer, m_views.at(kBaseGBuffer));
}

void RoundStage::compose(const MethodCell* cell, const MethodOutput& output, PassTiming timing) {
    m_context.reset_state();
    gl().Finish();
    const GBuffer* gbuffer = &m_gbuffers.get(kBaseGBuffer);
    const gl::Texture* pixel_depth = nullptr;
    if (cell != nullptr) {
        for (const GBufferKey& key : list_keys(*cell)) {
            if (key.part.kind == PartKind::multisampled) {
                gbuffer = &m_gbuffers.get(key);
                pixel_depth = cell->requests().samples_take_nearest
                                  ? &m_gbuffers.get(kBaseGBuffer).texture(Channel::eye_depth)
                                  : nullptr;
            }
        }
    }
    PassRecorder recorder(timing, &m_timer);
    const Camera& camera = m_views.at(kBaseGBuffer).camera;
    // A method that gives both is shown by its radiance.
    const ComposedImages images{output.radiance != nullptr ? nullptr : output.visibility,
                                output.radiance, output.replaces_direct_light};
    m_compose.render(*gbuffer, m_surroundings.look_through(camera), camera, images, recorder,
                     pixel_depth);
}

} // namespace alcove
