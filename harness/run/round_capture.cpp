#include "harness/run/round_capture.hpp"

#include "core/base/domain.hpp"
#include "core/base/hash.hpp"
#include "core/base/image_file.hpp"
#include "harness/run/error_map.hpp"
#include "harness/run/heatmap.hpp"
#include "harness/run/wall_time.hpp"

#include <algorithm>
#include <cmath>

namespace alcove {
namespace {

/// Full scale of maps whose metric has no largest value.
constexpr float kMapRange = 0.1f;
/// Full scale of samples a pixel and frame.
constexpr float kSamplesRange = 64.0f;
/// Metrics over time whose maps are part of the film.
constexpr const char* kFlicker = "temporal_flicker";
constexpr std::array<std::string_view, 3> kFilmMaps{kFlicker, "missed_invalidation",
                                                    "false_invalidation"};

bool begins_sequence(const RoundFrame& frame) {
    return frame.is_warmed || !frame.view.history_valid;
}

/// Per pixel the value that 95 % of the frames do not exceed (nearest rank).
Image compute_p95(const std::vector<Image>& images) {
    Image p95(images.front().size(), 1);
    std::vector<float> values(images.size());
    const auto rank =
        static_cast<std::ptrdiff_t>(std::ceil(0.95 * static_cast<double>(images.size())) - 1.0);
    for (std::size_t pixel = 0; pixel < p95.values().size(); ++pixel) {
        std::transform(images.begin(), images.end(), values.begin(),
                       [pixel](const Image& image) { return image.values()[pixel]; });
        std::nth_element(values.begin(), values.begin() + rank, values.end());
        p95.values()[pixel] = values[static_cast<std::size_t>(rank)];
    }
    return p95;
}

} // namespace

RoundCapture::RoundCapture(RoundStage& stage, std::vector<MetricRow>& rows, RoundDone& done,
                           std::filesystem::path run_folder)
    : m_stage(stage), m_rows(rows), m_done(done), m_run_folder(std::move(run_folder)),
      m_truth(make_truth_source(stage)), m_sequence(stage), m_cells(stage.cells().size()),
      m_has_singles(!stage.list_singles().empty()) {
    for (const MetricUnit& unit : stage.units().metrics.units()) {
        if (!unit.reported) {
            continue;
        }
        const ResolvedParameters defaults = unit.parameters.resolve({}, {});
        if (!unit.is_temporal()) {
            m_metrics.emplace_back(&unit, unit.create(defaults));
            continue;
        }
        for (CellSequence& cell : m_cells) {
            cell.metrics.emplace_back(&unit, unit.create_temporal(defaults));
        }
    }
}

bool RoundCapture::is_single(const RoundFrame& frame) const {
    return m_stage.round().segments[static_cast<std::size_t>(frame.segment)].is_single();
}

void RoundCapture::run(const std::function<void()>& frame_done) {
    m_done.reference_cached = true;
    for (std::size_t i = 0; i < m_stage.frames().size(); ++i) {
        capture_frame(i);
        frame_done();
    }
    for (const RoundFrame& single : m_stage.list_singles()) {
        capture_converged(single);
    }
    m_truth->prune();
}

Truth RoundCapture::get_truth(const FrameView& view) {
    const WallTime wall(m_done.reference_s);
    Truth truth = m_truth->get(view);
    m_done.reference_cached = m_done.reference_cached && truth.was_cached;
    return truth;
}

void RoundCapture::capture_frame(std::size_t index) {
    const std::vector<RoundFrame>& frames = m_stage.frames();
    const RoundFrame& frame = frames[index];
    m_stage.prepare_histories(frame);
    if (begins_sequence(frame)) {
        m_sequence.reset();
        for (CellSequence& cell : m_cells) {
            cell.history.reset();
            for (const auto& [unit, metric] : cell.metrics) {
                metric->reset();
            }
        }
    }
    const auto takes_part = [](const MethodCell& cell) {
        return cell.record().role == CellRole::method;
    };
    if (std::none_of(m_stage.cells().begin(), m_stage.cells().end(), takes_part)) {
        return;
    }
    const Truth truth = get_truth(frame.view);
    const bool ends = index + 1 == frames.size() || begins_sequence(frames[index + 1]);
    const SegmentRecord& film = m_stage.round().film;
    const std::vector<int>& kept = m_stage.round().image_frames;
    Shot shot{frame, SampleState::cold, truth, !is_single(frame), ends, false, false};
    // A frame that stands in the film's burst and as a single is filmed once.
    shot.is_film =
        shot.is_in_sequence && frame.view.index >= film.begin && frame.view.index < film.end;
    shot.keeps_pictures = std::find(kept.begin(), kept.end(), frame.view.index) != kept.end() &&
                          (is_single(frame) || !m_has_singles);
    if (shot.is_in_sequence) {
        const WallTime wall(m_done.temporal_s);
        m_sequence.add(frame.view, truth);
    }
    {
        const WallTime wall(m_done.gbuffer_s);
        m_stage.render_gbuffers();
    }
    write_reference_pictures(shot);
    for (MethodCell& cell : m_stage.cells()) {
        if (!takes_part(cell)) {
            continue;
        }
        MethodOutput output;
        const CellImages images = take_images(cell, output);
        measure_images(cell, images, shot);
        if (shot.is_in_sequence) {
            measure_sequence(cell, images, shot);
        }
        // A method with history keeps its converged picture, the one that its table speaks of.
        if (shot.keeps_pictures && (cell.record().warm_frames == 0 || !m_has_singles)) {
            write_pictures(cell, images, output, shot);
        }
    }
}

void RoundCapture::capture_converged(const RoundFrame& single) {
    const std::vector<int>& kept = m_stage.round().image_frames;
    const RoundFrame held{single.segment, hold(single.view)};
    for (MethodCell& cell : m_stage.cells()) {
        if (cell.record().role != CellRole::method || cell.record().warm_frames == 0) {
            continue;
        }
        // Truth first: its source may use the stage.
        const Truth truth = get_truth(single.view);
        Shot shot{held, SampleState::converged, truth, false, false, false, false};
        shot.keeps_pictures = std::find(kept.begin(), kept.end(), single.view.index) != kept.end();
        {
            const WallTime wall(m_done.passes_s);
            m_stage.warm_up(cell, single.view);
            m_stage.render_gbuffer(kBaseGBuffer);
        }
        MethodOutput output;
        const CellImages images = take_images(cell, output);
        measure_images(cell, images, shot);
        add_history_rows(cell, images, shot, nullptr);
        if (shot.keeps_pictures) {
            write_pictures(cell, images, output, shot);
        }
    }
}

RoundCapture::CellImages RoundCapture::take_images(MethodCell& cell, MethodOutput& output) {
    const WallTime wall(m_done.passes_s);
    MethodInputs inputs = m_stage.make_inputs(cell);
    inputs.wants_history_state = true;
    CellTimes times;
    output = cell.render(inputs, PassTiming::none, m_stage.timer(), times);
    ALCOVE_ASSERT(output.visibility != nullptr, "methods so far give visibility");
    CellImages images;
    images.visibility = gl::read_texture(m_stage.gl(), *output.visibility, 1);
    if (output.history_state != nullptr) {
        images.history_state = fit_history_state(
            gl::read_texture(m_stage.gl(), *output.history_state, 4), m_stage.size());
    }
    m_stage.context().check_errors();
    images.hash = to_hex(hash_image(images.visibility));
    return images;
}

MetricRow RoundCapture::make_row(const MethodCell& cell, const CellImages& images, const Shot& shot,
                                 const std::string& metric) const {
    MetricRow row;
    row.round = m_stage.round().id;
    row.cell = cell.record().id;
    row.segment = shot.frame.segment;
    row.frame = shot.frame.view.index;
    row.state = shot.state;
    row.metric = metric;
    row.image_hash = images.hash;
    return row;
}

void RoundCapture::measure_images(const MethodCell& cell, const CellImages& images,
                                  const Shot& shot) {
    const WallTime wall(m_done.metrics_s);
    const MetricInput input{images.visibility, shot.truth.mean, shot.truth.a(), shot.truth.b()};
    for (const auto& [unit, metric] : m_metrics) {
        MetricRow row = make_row(cell, images, shot, unit->name);
        if (std::min(m_stage.size().width, m_stage.size().height) < unit->smallest_side) {
            row.note = "image smaller than the metric's window";
        } else {
            const MetricResult result =
                evaluate_in_domain(*unit, *metric, input, Domain::visibility);
            row.value = result.value;
            row.debiased = result.debiased;
            row.floor = result.floor;
            row.note = result.undefined_reason;
        }
        m_rows.push_back(std::move(row));
    }
}

void RoundCapture::measure_sequence(const MethodCell& cell, const CellImages& images,
                                    const Shot& shot) {
    const auto index = static_cast<std::size_t>(&cell - m_stage.cells().data());
    CellSequence& sequence = m_cells[index];
    std::vector<std::pair<std::string, Image>> maps;
    {
        const WallTime wall(m_done.temporal_s);
        TemporalFrame frame{.test = images.visibility,
                            .reference = shot.truth.mean,
                            .reference_a = shot.truth.a(),
                            .reference_b = shot.truth.b(),
                            .earlier = m_sequence.earlier(),
                            .surface = m_sequence.surface(),
                            .moves = m_sequence.moves(),
                            .history_state =
                                images.history_state ? &*images.history_state : nullptr,
                            .is_last = shot.is_last};
        for (const auto& [unit, metric] : sequence.metrics) {
            std::optional<MetricResult> result = metric->add(frame);
            if (!result) {
                continue;
            }
            MetricRow row = make_row(cell, images, shot, unit->name);
            row.value = result->value;
            row.debiased = result->debiased;
            row.floor = result->floor;
            row.note = result->undefined_reason;
            m_rows.push_back(std::move(row));
            const bool is_filmed =
                std::find(kFilmMaps.begin(), kFilmMaps.end(), unit->name) != kFilmMaps.end();
            if (shot.is_film && is_filmed && result->map) {
                const double range = std::isfinite(unit->maximum) ? unit->maximum : kMapRange;
                maps.emplace_back("film_" + unit->name,
                                  make_scale_map(*result->map, static_cast<float>(range)));
                if (unit->name == kFlicker) {
                    sequence.flicker.push_back(std::move(*result->map));
                }
            }
        }
        if (images.history_state) {
            const Correspondence* to_previous = m_sequence.earlier().empty()
                                                    ? nullptr
                                                    : &m_sequence.earlier().front().correspondence;
            sequence.history.add(*images.history_state, to_previous);
            add_history_rows(cell, images, shot, &sequence.history.age());
        }
    }
    if (shot.is_film) {
        for (const auto& [name, map] : maps) {
            write_picture(cell.record().id, shot.frame.view.index, name, map);
        }
        write_film(cell, images, shot);
    }
}

void RoundCapture::add_history_rows(const MethodCell& cell, const CellImages& images,
                                    const Shot& shot, const Image* age) {
    if (!images.history_state) {
        return;
    }
    for (const HistoryNumber& number : count_history(*images.history_state, age)) {
        MetricRow row = make_row(cell, images, shot, number.name);
        row.value = number.value;
        m_rows.push_back(std::move(row));
    }
}

void RoundCapture::write_film(const MethodCell& cell, const CellImages& images, const Shot& shot) {
    const auto index = static_cast<std::size_t>(&cell - m_stage.cells().data());
    CellSequence& sequence = m_cells[index];
    const std::string& id = cell.record().id;
    const int frame = shot.frame.view.index;
    write_picture(id, frame, "film_visibility", encode_view(images.visibility));
    write_picture(id, frame, "film_error", make_error_map(images.visibility, shot.truth.mean));
    if (images.history_state) {
        const Image& state = *images.history_state;
        const auto take = [&state](HistoryChannel channel) {
            return take_channel(state, static_cast<int>(channel));
        };
        write_picture(id, frame, "film_age", make_age_map(sequence.history.age(), state));
        write_picture(id, frame, "film_cause", make_cause_map(state));
        write_picture(id, frame, "film_convergence",
                      make_scale_map(take(HistoryChannel::convergence), 1.0f));
        write_picture(id, frame, "film_samples",
                      make_scale_map(take(HistoryChannel::samples), kSamplesRange));
    }
    if (!shot.is_last) {
        return;
    }
    if (!sequence.flicker.empty()) {
        write_picture(id, frame, "accumulated_flicker_p95",
                      make_scale_map(compute_p95(sequence.flicker), kMapRange));
        sequence.flicker.clear();
    }
    if (images.history_state) {
        const SegmentRecord& film = m_stage.round().film;
        write_picture(id, frame, "accumulated_invalidations",
                      make_scale_map(sequence.history.compute_invalidated_share(), 1.0f));
        write_picture(id, frame, "accumulated_samples",
                      make_scale_map(sequence.history.samples(),
                                     kSamplesRange * static_cast<float>(film.end - film.begin)));
    }
}

void RoundCapture::write_reference_pictures(const Shot& shot) {
    const int frame = shot.frame.view.index;
    if (shot.is_film) {
        write_picture("reference", frame, "film_visibility", encode_view(shot.truth.mean));
    }
    if (!shot.keeps_pictures) {
        return;
    }
    write_picture("reference", frame, "visibility", encode_view(shot.truth.mean));
    gl::Texture truth(m_stage.gl(), GL_R32F, m_stage.size());
    gl::write_texture(m_stage.gl(), truth, shot.truth.mean);
    m_stage.compose({.visibility = &truth}, PassTiming::none);
    write_picture("reference", frame, "shaded",
                  encode_view(tone_map(gl::read_texture(m_stage.gl(), m_stage.picture(), 3))));
}

void RoundCapture::write_pictures(const MethodCell& cell, const CellImages& images,
                                  const MethodOutput& output, const Shot& shot) {
    m_stage.compose(output, PassTiming::none);
    const int frame = shot.frame.view.index;
    const std::string& id = cell.record().id;
    write_picture(id, frame, "visibility", encode_view(images.visibility));
    write_picture(id, frame, "error", make_error_map(images.visibility, shot.truth.mean));
    write_picture(id, frame, "shaded",
                  encode_view(tone_map(gl::read_texture(m_stage.gl(), m_stage.picture(), 3))));
}

void RoundCapture::write_picture(const std::string& cell, int frame, const std::string& picture,
                                 const Image& codes) {
    const WallTime wall(m_done.images_s);
    write_png(m_run_folder / RunFolder::make_image_path(m_stage.round().id, cell, frame, picture),
              codes, Domain::view);
}

} // namespace alcove
