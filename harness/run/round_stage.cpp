#include "harness/run/round_stage.hpp"

#include <algorithm>

namespace alcove {
namespace {

/// Seed of methods' noise; one for all runs, so that images are comparable between them.
constexpr std::uint32_t kNoiseSeed = 1;

} // namespace

RoundStage::RoundStage(gl::Context& context, gl::TimerMode timer_mode, const Units& units,
                       const PlanRecord& plan, const RoundRecord& round, const Scene& scene)
    : m_context(context), m_units(units), m_plan(plan), m_round(round), m_scene(scene),
      m_timer(context.functions(), timer_mode), m_size{round.width, round.height},
      m_renderer(context.functions(), scene), m_compose(context.functions(), m_size),
      m_precision(parse_precision(round.precision)) {
    m_views.emplace(Border{}, FrameView{});
    add_gbuffer(kBaseGBuffer);
    m_cells.reserve(round.cells.size());
    for (const CellRecord& record : round.cells) {
        m_cells.emplace_back(context, units.methods.find(record.method), record, m_size);
        add_gbuffer(get_key(m_cells.back()));
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

std::vector<GBufferKey> RoundStage::list_gbuffers() const {
    std::vector<GBufferKey> keys{kBaseGBuffer};
    for (const MethodCell& cell : m_cells) {
        if (std::find(keys.begin(), keys.end(), get_key(cell)) == keys.end()) {
            keys.push_back(get_key(cell));
        }
    }
    return keys;
}

void RoundStage::add_gbuffer(const GBufferKey& key) {
    if (m_gbuffers.contains(key)) {
        return;
    }
    const ImageSize size{m_size.width + 2 * key.border.x, m_size.height + 2 * key.border.y};
    m_gbuffers.emplace(key, GBuffer(gl(), size, key.channels, m_precision));
    m_views.try_emplace(key.border);
}

void RoundStage::set_frame(const FrameView& view) {
    for (auto& [border, extended] : m_views) {
        extended = extend(view, border);
    }
    // The camera without border is the walkthrough's own, free of rounding.
    m_views.at({}) = view;
    const bool needs_geometry =
        std::any_of(m_cells.begin(), m_cells.end(),
                    [](const MethodCell& cell) { return cell.needs_geometry(); });
    if (needs_geometry) {
        m_geometry = pose_geometry(m_scene, view.time_s);
    }
}

void RoundStage::render_gbuffer(const GBufferKey& key, PassTiming timing) {
    m_context.reset_state();
    gl().Finish();
    PassRecorder recorder(timing, &m_timer);
    const auto pass = recorder.scope("input");
    m_renderer.render(m_gbuffers.at(key), m_views.at(key.border));
}

void RoundStage::render_gbuffers() {
    for (const GBufferKey& key : list_gbuffers()) {
        render_gbuffer(key);
    }
}

MethodInputs RoundStage::make_inputs(const MethodCell& cell) const {
    const GBufferKey key = get_key(cell);
    MethodInputs inputs{m_views.at(key.border), m_gbuffers.at(key)};
    inputs.geometry = cell.needs_geometry() ? &m_geometry : nullptr;
    inputs.lights = &m_scene.get_lights();
    inputs.noise_seed = kNoiseSeed;
    return inputs;
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
            set_frame(i == 0 ? view : hold(view));
            render_gbuffer(get_key(cell));
        }
        CellTimes times;
        static_cast<void>(cell.render(make_inputs(cell), PassTiming::none, m_timer, times));
    }
    set_frame(hold(view));
    render_gbuffer(get_key(cell));
}

void RoundStage::draw(const GBuffer& gbuffer) {
    m_context.reset_state();
    m_renderer.render(gbuffer, m_views.at({}));
}

void RoundStage::compose(const MethodOutput& output, PassTiming timing) {
    m_context.reset_state();
    gl().Finish();
    PassRecorder recorder(timing, &m_timer);
    m_compose.render(m_gbuffers.at(kBaseGBuffer), m_scene.get_lights().ambient, output.visibility,
                     output.radiance, recorder);
}

} // namespace alcove
