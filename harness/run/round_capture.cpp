#include "harness/run/round_capture.hpp"

#include "core/base/domain.hpp"
#include "core/base/hash.hpp"
#include "harness/run/wall_time.hpp"

#include <algorithm>

namespace alcove {
namespace {

/// Its maps are accumulated over the film.
constexpr const char* kFlicker = "temporal_flicker";

bool begins_sequence(const RoundFrame& frame) {
    return frame.is_warmed || !frame.view.history_valid;
}

/// Luminance is linear in the channels: halves stay independent and free of bias.
Truth make_luma(const Truth& truth) {
    Truth luma;
    luma.mean = compute_luma(truth.mean);
    if (truth.halves) {
        luma.halves = {compute_luma(truth.halves->a), compute_luma(truth.halves->b), 0};
    }
    return luma;
}

} // namespace

RoundCapture::RoundCapture(RoundStage& stage, const RoundReuse& reuse, std::vector<MetricRow>& rows,
                           RoundDone& done, std::filesystem::path run_folder)
    : m_stage(stage), m_reuse(reuse), m_rows(rows), m_done(done),
      m_pictures(stage, done, std::move(run_folder)), m_truth(make_truth_source(stage)),
      m_sequence(stage), m_cells(stage.cells().size()),
      m_has_singles(!stage.list_singles().empty()) {
    choose_strata();
    for (const MetricDescription& metric : stage.plan().metrics) {
        if (metric.kind == "history" || metric.kind == kStratumKind) {
            continue; // no unit: numbers that histories carry, and other metrics' values over parts
        }
        const ResolvedMetric resolved = resolve_metric(
            stage.units().metrics, parse_metric_spec(metric.name, "metric of the plan"));
        m_needs_depth = m_needs_depth || resolved.unit->needs_depth;
        if (!resolved.unit->is_temporal()) {
            m_metrics.push_back({metric.name, resolved, resolved.create()});
            continue;
        }
        for (CellSequence& cell : m_cells) {
            cell.metrics.push_back({metric.name, resolved.unit, resolved.create_temporal()});
        }
    }
}

void RoundCapture::choose_strata() {
    const auto has_column = [this](const std::string& name) {
        const std::vector<MetricDescription>& metrics = m_stage.plan().metrics;
        return std::any_of(metrics.begin(), metrics.end(),
                           [column = make_pixels_column(name)](const MetricDescription& metric) {
                               return metric.name == column;
                           });
    };
    m_has_strata = has_column(list_strata().front().name);
    for (const Object& object : m_stage.scene().get_objects()) {
        const bool is_known =
            std::find(m_regions.begin(), m_regions.end(), object.name) != m_regions.end();
        if (!is_known && has_column(object.name)) {
            m_regions.push_back(object.name);
        }
    }
}

bool RoundCapture::takes_part(const MethodCell& cell) const {
    return cell.record().role == CellRole::method && m_reuse.is_wanted(cell.record().id);
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
    m_done.audited += static_cast<int>(m_truth->audited());
}

Truth RoundCapture::get_truth(const FrameView& view) {
    const WallTime wall(m_done.reference_s);
    Truth truth = m_truth->get(view);
    m_done.reference_cached = m_done.reference_cached && truth.was_cached;
    ++(truth.was_cached ? m_done.references_reused : m_done.references_made);
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
            for (const SequenceMetric& sequence : cell.metrics) {
                sequence.metric->reset();
            }
        }
    }
    if (!m_reuse.is_anything_wanted()) {
        return;
    }
    const Truth truth = get_truth(frame.view);
    const bool ends = index + 1 == frames.size() || begins_sequence(frames[index + 1]);
    const SegmentRecord& film = m_stage.round().film;
    const std::vector<int>& kept = m_stage.round().image_frames;
    const bool is_in_sequence = !is_single(frame);
    const std::optional<Truth> own_luma =
        m_stage.measures_pictures() ? std::optional(make_luma(truth)) : std::nullopt;
    const Truth& luma = own_luma ? *own_luma : truth;
    if (is_in_sequence) {
        const WallTime wall(m_done.temporal_s);
        m_sequence.add(frame.view, luma);
    }
    const Geometry geometry =
        make_geometry(frame.view, luma, is_in_sequence ? &m_sequence.surfaces() : nullptr);
    Shot shot{frame, SampleState::cold, truth, luma, geometry, is_in_sequence, ends, false, false,
              false};
    // A frame that stands in the film's burst and as a single is filmed once.
    shot.is_film =
        shot.is_in_sequence && frame.view.index >= film.begin && frame.view.index < film.end;
    shot.ends_film = shot.is_film && (ends || frame.view.index + 1 == film.end);
    shot.keeps_pictures = std::find(kept.begin(), kept.end(), frame.view.index) != kept.end() &&
                          (is_single(frame) || !m_has_singles);
    {
        const WallTime wall(m_done.gbuffer_s);
        m_stage.render_gbuffers(m_stage.list_gbuffers());
    }
    const bool takes_reference = m_reuse.is_wanted("reference");
    if (shot.is_film && takes_reference) {
        m_pictures.write_film_reference(frame.view.index, truth);
        m_truth_profile.add(truth.mean);
        if (shot.ends_film) {
            m_pictures.write_profile("reference", frame.view.index, m_truth_profile);
            m_truth_profile.clear();
        }
    }
    if (shot.keeps_pictures && takes_reference) {
        m_pictures.write_reference(frame.view.index, truth);
    }
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
            m_pictures.write_cell(cell, shot.frame.view.index, images.measured, output, truth);
        }
    }
}

void RoundCapture::capture_converged(const RoundFrame& single) {
    const std::vector<int>& kept = m_stage.round().image_frames;
    const RoundFrame held{single.segment, hold(single.view)};
    const auto converges = [this](const MethodCell& cell) {
        return takes_part(cell) && cell.record().warm_frames > 0;
    };
    if (std::none_of(m_stage.cells().begin(), m_stage.cells().end(), converges)) {
        return;
    }
    // Truth first: its source may use the stage.
    const Truth truth = get_truth(single.view);
    const std::optional<Truth> own_luma =
        m_stage.measures_pictures() ? std::optional(make_luma(truth)) : std::nullopt;
    const Truth& luma = own_luma ? *own_luma : truth;
    if (needs_surfaces()) {
        m_stage.set_frame(held.view);
    }
    const Geometry geometry = make_geometry(held.view, luma, nullptr);
    for (MethodCell& cell : m_stage.cells()) {
        if (!converges(cell)) {
            continue;
        }
        Shot shot{held, SampleState::converged, truth, luma, geometry, false, false, false, false,
                  false};
        shot.keeps_pictures = std::find(kept.begin(), kept.end(), single.view.index) != kept.end();
        {
            const WallTime wall(m_done.passes_s);
            m_stage.warm_up(cell, single.view);
        }
        MethodOutput output;
        const CellImages images = take_images(cell, output);
        measure_images(cell, images, shot);
        add_history_rows(cell, images, shot, nullptr);
        if (shot.keeps_pictures) {
            m_pictures.write_cell(cell, shot.frame.view.index, images.measured, output, truth);
        }
    }
}

RoundCapture::Geometry RoundCapture::make_geometry(const FrameView& view, const Truth& luma,
                                                   const SurfaceImages* surfaces) {
    Geometry geometry;
    if (!needs_surfaces()) {
        return geometry;
    }
    const WallTime wall(m_done.metrics_s);
    std::optional<SurfaceImages> read;
    if (surfaces == nullptr) {
        surfaces = &read.emplace(m_sequence.read_surfaces());
    }
    if (m_needs_depth) {
        geometry.eye_depth = surfaces->eye_depth;
    }
    if (m_has_strata) {
        std::vector<Image> masks =
            make_strata(*surfaces, luma.mean, glm::vec2(compute_tangents(view.camera, view.size)));
        for (std::size_t i = 0; i < masks.size(); ++i) {
            geometry.strata.push_back({list_strata()[i].name, std::move(masks[i])});
        }
    }
    for (const std::string& name : m_regions) {
        geometry.strata.push_back(
            {name, make_region(surfaces->instance_id, m_stage.scene().get_objects(), name)});
    }
    return geometry;
}

RoundCapture::CellImages RoundCapture::take_images(MethodCell& cell, MethodOutput& output) {
    const WallTime wall(m_done.passes_s);
    MethodInputs inputs = m_stage.make_measured_inputs(cell);
    inputs.wants_history_state = true;
    CellTimes times;
    output = cell.render(inputs, PassTiming::none, m_stage.timer(), times);
    CellImages images;
    images.measured = m_stage.read_measured(cell, output);
    if (output.history_state != nullptr) {
        images.history_state = fit_history_state(
            gl::read_texture(m_stage.gl(), *output.history_state, 4), m_stage.size());
    }
    m_stage.context().check_errors();
    images.hash = to_hex(hash_image(images.measured));
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
    const MetricInput input{
        images.measured, shot.truth.mean,
        shot.truth.a(),  shot.truth.b(),
        nullptr,         shot.geometry.eye_depth ? &*shot.geometry.eye_depth : nullptr};
    for (const ImageMetric& image : m_metrics) {
        add_row(cell, images, shot, image.name,
                evaluate_in_domain(*image.resolved.unit, *image.metric, input,
                                   m_stage.measured_domain(), image.resolved.domain));
    }
    measure_strata(cell, images, shot);
}

void RoundCapture::measure_strata(const MethodCell& cell, const CellImages& images,
                                  const Shot& shot) {
    for (const auto& [stratum, mask] : shot.geometry.strata) {
        MetricResult pixels;
        pixels.value = static_cast<double>(count_pixels(mask));
        add_row(cell, images, shot, make_pixels_column(stratum), pixels);
        const MetricInput input{
            images.measured, shot.truth.mean,
            shot.truth.a(),  shot.truth.b(),
            &mask,           shot.geometry.eye_depth ? &*shot.geometry.eye_depth : nullptr};
        for (const ImageMetric& image : m_metrics) {
            add_row(cell, images, shot, make_stratum_column(image.name, stratum),
                    evaluate_in_domain(*image.resolved.unit, *image.metric, input,
                                       m_stage.measured_domain(), image.resolved.domain));
        }
    }
}

void RoundCapture::add_row(const MethodCell& cell, const CellImages& images, const Shot& shot,
                           const std::string& column, const MetricResult& result) {
    MetricRow row = make_row(cell, images, shot, column);
    row.value = result.value;
    row.debiased = result.debiased;
    row.floor = result.floor;
    row.note = result.undefined_reason;
    m_rows.push_back(std::move(row));
}

void RoundCapture::measure_sequence(const MethodCell& cell, const CellImages& images,
                                    const Shot& shot) {
    const auto index = static_cast<std::size_t>(&cell - m_stage.cells().data());
    CellSequence& sequence = m_cells[index];
    const std::string& id = cell.record().id;
    const int index_of_frame = shot.frame.view.index;
    std::vector<std::pair<const MetricUnit*, Image>> maps;
    {
        const WallTime wall(m_done.temporal_s);
        const Image luma = compute_luma(images.measured);
        TemporalFrame frame{.test = luma,
                            .reference = shot.luma.mean,
                            .reference_a = shot.luma.a(),
                            .reference_b = shot.luma.b(),
                            .earlier = m_sequence.earlier(),
                            .surface = m_sequence.surface(),
                            .moves = m_sequence.moves(),
                            .history_state =
                                images.history_state ? &*images.history_state : nullptr,
                            .is_last = shot.is_last};
        for (const auto& [name, unit, metric] : sequence.metrics) {
            std::optional<MetricResult> result = metric->add(frame);
            if (!result) {
                continue;
            }
            add_row(cell, images, shot, name, *result);
            if (shot.is_film && RoundPictures::is_filmed(unit->name) && result->map) {
                maps.emplace_back(unit, std::move(*result->map));
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
    if (!shot.is_film) {
        return;
    }
    for (auto& [unit, map] : maps) {
        m_pictures.write_film_map(id, index_of_frame, unit->name, map, unit->maximum);
        if (unit->name == kFlicker) {
            sequence.flicker.push_back(std::move(map));
        }
    }
    const Image* state = images.history_state ? &*images.history_state : nullptr;
    m_pictures.write_film_frame(id, index_of_frame, images.measured, shot.truth, state,
                                sequence.history);
    sequence.profile.add(images.measured);
    if (shot.ends_film) {
        m_pictures.write_accumulated(id, index_of_frame, sequence.flicker,
                                     state != nullptr ? &sequence.history : nullptr);
        m_pictures.write_profile(id, index_of_frame, sequence.profile);
        sequence.flicker.clear();
        sequence.profile.clear();
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

} // namespace alcove
