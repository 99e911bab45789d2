#include "harness/run/round_timing.hpp"

#include "core/base/hash.hpp"
#include "harness/run/wall_time.hpp"

#include <algorithm>
#include <numeric>
#include <random>

namespace alcove {
namespace {

/// Frames timed once a method's history has converged (DESIGN 3.5).
constexpr int kConvergedFrames = 8;

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

std::string name_input(const MethodCell& cell) {
    std::string name = name_extra_channels(cell.channels());
    const auto add = [&name](const char* part) {
        name += name.empty() ? "" : "+";
        name += part;
    };
    if (cell.border() != Border{}) {
        add("border");
    }
    if (!cell.has_light()) {
        add("without_light");
    }
    return "input/" + name;
}

} // namespace

void RoundTiming::warm_up() {
    m_stage.set_frame(m_stage.frames().front().view);
    m_stage.render_gbuffers(m_stage.list_gbuffers());
    for (MethodCell& cell : m_stage.cells()) {
        CellTimes times;
        const MethodOutput output =
            cell.render(m_stage.make_inputs(cell), PassTiming::none, m_stage.timer(), times);
        m_stage.compose(&cell, output, PassTiming::none);
        m_stage.gl().Finish();
        m_stage.context().check_errors();
    }
}

void RoundTiming::add_sample(const std::string& cell, const RoundFrame& frame, int repeat,
                             SampleKind kind, SampleState state, const std::string& pass,
                             std::int64_t time_ns) {
    SampleRow row;
    row.round = m_stage.round().id;
    row.cell = cell;
    row.segment = frame.segment;
    row.frame = frame.view.index;
    row.repeat = repeat;
    row.kind = kind;
    row.state = state;
    row.pass = pass;
    row.time_ns = time_ns;
    m_samples.push_back(std::move(row));
}

void RoundTiming::add_cell_samples(const MethodCell& cell, const RoundFrame& frame, int repeat,
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

std::optional<RoundTiming::InputTime>
RoundTiming::time_gbuffer(const GBufferKey& key, const RoundFrame& frame, int repeat) {
    if (const std::optional<std::int64_t> time_ns = m_stage.time_gbuffer(key)) {
        const auto place = static_cast<std::size_t>(&frame - m_stage.frames().data());
        m_gbuffer_times[{place, key}].push_back(*time_ns);
        return InputTime{*time_ns, false};
    }
    // The repeats of the run that drew it stand for this run's.
    const std::span<const std::int64_t> stored = m_stage.find_stored_times(key);
    const auto index = static_cast<std::size_t>(repeat);
    if (index >= stored.size()) {
        return std::nullopt;
    }
    return InputTime{stored[index], true};
}

void RoundTiming::time_gbuffers(const RoundFrame& frame, int repeat) {
    const WallTime wall(m_done.gbuffer_s);
    std::optional<InputTime> base;
    for (const GBufferKey& key : m_stage.list_gbuffers()) {
        const std::optional<InputTime> time = time_gbuffer(key, frame, repeat);
        if (!time) {
            continue;
        }
        if (key == kBaseGBuffer) {
            base = time;
            add_sample("harness", frame, repeat, SampleKind::divided, SampleState::cold,
                       "input/base", time->ns);
            m_samples.back().cached = time->is_cached;
            continue;
        }
        // An ordinary G-buffer costs what it takes longer than the base; a part all it takes.
        const bool is_part = key.part.kind != PartKind::nearest;
        for (const MethodCell& cell : m_stage.cells()) {
            const std::vector<GBufferKey> keys = RoundStage::list_keys(cell);
            if (base && std::find(keys.begin(), keys.end(), key) != keys.end()) {
                add_sample(cell.record().id, frame, repeat, SampleKind::divided, SampleState::cold,
                           is_part ? "input/" + to_text(key.part) : name_input(cell),
                           time->ns - (is_part ? 0 : base->ns));
                m_samples.back().cached = time->is_cached;
            }
        }
    }
}

void RoundTiming::time_frame(const RoundFrame& frame, int repeat) {
    m_stage.set_frame(frame);
    time_gbuffers(frame, repeat);
    const WallTime wall(m_done.passes_s);
    const bool divided = (repeat + frame.view.index) % 2 != 0;
    std::vector<MethodCell>& cells = m_stage.cells();
    for (const std::size_t index :
         shuffle_order(cells.size(), m_stage.plan().shuffle_seed, repeat, frame.view.index)) {
        MethodCell& cell = cells[index];
        const PassTiming timing = !cell.has_passes() ? PassTiming::none
                                  : divided          ? PassTiming::divided
                                                     : PassTiming::envelope;
        CellTimes times;
        const MethodOutput output =
            cell.render(m_stage.make_inputs(cell), timing, m_stage.timer(), times);
        if (timing != PassTiming::none) {
            add_cell_samples(cell, frame, repeat, SampleState::cold, timing, times);
        }
        if (cell.record().role == CellRole::method && cell.has_light()) {
            m_stage.compose(&cell, output, PassTiming::divided);
            add_sample(cell.record().id, frame, repeat, SampleKind::divided, SampleState::cold,
                       "harness/compose", m_stage.timer().collect().front());
        }
    }
}

void RoundTiming::time_repeat(int repeat, const std::function<void()>& frame_done) {
    for (const RoundFrame& frame : m_stage.frames()) {
        m_stage.prepare_histories(frame);
        time_frame(frame, repeat);
        frame_done();
    }
    time_converged(repeat);
    m_stage.context().check_errors();
}

void RoundTiming::store_gbuffers() {
    const WallTime wall(m_done.gbuffer_s);
    m_stage.store_gbuffers(m_gbuffer_times);
}

void RoundTiming::warm_converged_cells() {
    const std::vector<RoundFrame> singles = m_stage.list_singles();
    if (singles.empty()) {
        return;
    }
    std::vector<RoundFrame> ends{singles.front()};
    if (singles.size() > 1) {
        ends.push_back(singles.back());
    }
    const WallTime wall(m_done.passes_s);
    for (const RoundFrame& single : ends) {
        for (const MethodCell& cold : m_stage.cells()) {
            const CellRecord& record = cold.record();
            if (record.warm_frames == 0) {
                continue;
            }
            ConvergedCell converged{
                {single.segment, hold(single.view)},
                std::make_unique<MethodCell>(m_stage.context(),
                                             m_stage.units().methods.find(record.method), record,
                                             m_stage.size())};
            m_stage.warm_up(*converged.cell, single.view);
            m_converged.push_back(std::move(converged));
        }
    }
}

void RoundTiming::time_converged(int repeat) {
    if (repeat == 0) {
        warm_converged_cells();
    }
    const WallTime wall(m_done.passes_s);
    for (const ConvergedCell& converged : m_converged) {
        m_stage.set_frame(converged.frame.view);
        m_stage.render_gbuffers(RoundStage::list_keys(*converged.cell));
        for (int i = 0; i < kConvergedFrames; ++i) {
            const PassTiming timing =
                (repeat + i) % 2 != 0 ? PassTiming::divided : PassTiming::envelope;
            CellTimes times;
            static_cast<void>(converged.cell->render(m_stage.make_inputs(*converged.cell), timing,
                                                     m_stage.timer(), times));
            add_cell_samples(*converged.cell, converged.frame, repeat, SampleState::converged,
                             timing, times);
        }
    }
}

} // namespace alcove
