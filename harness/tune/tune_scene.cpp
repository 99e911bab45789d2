#include "harness/tune/tune_scene.hpp"

#include "core/base/error.hpp"
#include "harness/run/scene_source.hpp"

#include <algorithm>

namespace alcove {
namespace {

/// Only single frames: the stage looks at every frame of its round.
PlanRecord keep_singles(PlanRecord plan) {
    RoundRecord& round = plan.rounds.front();
    std::erase_if(round.segments,
                  [](const SegmentRecord& segment) { return !segment.is_single(); });
    if (round.segments.empty()) {
        throw InputError("tune", "no single frames in the walkthrough", round.scene,
                         "a walkthrough of eight frames or more");
    }
    round.film = {};
    round.image_frames.clear();
    // Methods come and go: the stage has none of its own.
    round.cells.clear();
    return plan;
}

bool is_same(const CellRecord& a, const CellRecord& b) {
    return a.method == b.method &&
           std::equal(a.parameters.begin(), a.parameters.end(), b.parameters.begin(),
                      b.parameters.end(), [](const ParameterRecord& p, const ParameterRecord& q) {
                          return p.name == q.name && p.value == q.value;
                      });
}

} // namespace

TuneScene::TuneScene(gl::Context& context, const Units& units, const Experiment& experiment)
    : m_units(units), m_plan(keep_singles(make_plan(experiment, units).record)) {
    std::vector<std::string> warnings; // a plan has told them
    m_scene = open_scene(units.scenes, m_plan.rounds.front().scene, warnings);
    m_stage = std::make_unique<RoundStage>(context, gl::TimerMode::fenced_wall, units, m_plan,
                                           m_plan.rounds.front(), *m_scene);
    m_frames = m_stage->frames();
    const std::unique_ptr<TruthSource> source = make_truth_source(*m_stage);
    for (const RoundFrame& frame : m_frames) {
        m_truths.push_back(source->get(frame.view));
    }
}

double TuneScene::target_radius_m() const {
    return m_stage->target().radius_m;
}

CellRecord TuneScene::make_cell(const MethodSpec& spec) const {
    return make_cell_record(m_units.methods.find(spec.method), spec, m_stage->target(),
                            round().ao_radius_m);
}

Image TuneScene::render(const CellRecord& cell, std::size_t frame) {
    if (!m_record || !is_same(*m_record, cell)) {
        m_cell.reset();
        m_record = std::make_unique<CellRecord>(cell);
        m_cell = std::make_unique<MethodCell>(m_stage->context(), m_units.methods.find(cell.method),
                                              *m_record, m_stage->size());
        m_stage->add_gbuffers(RoundStage::list_keys(*m_cell));
    }
    m_stage->warm_up(*m_cell, m_frames[frame].view);
    CellTimes times;
    const MethodOutput output = m_cell->render(m_stage->make_measured_inputs(*m_cell),
                                               PassTiming::none, m_stage->timer(), times);
    return m_stage->read_measured(*m_cell, output);
}

double TuneScene::measure(const TuneMetric& metric, const Image& image, std::size_t frame) {
    const Truth& truth = m_truths[frame];
    const MetricResult result =
        evaluate_in_domain(*metric.unit, *metric.metric, {image, truth.mean, truth.a(), truth.b()},
                           m_stage->measured_domain(), metric.domain);
    if (!result.value) {
        throw InputError("tune", metric.text + " has no value: " + result.undefined_reason,
                         name() + " frame " + std::to_string(frame_index(frame)), "another metric");
    }
    return result.debiased.value_or(*result.value);
}

} // namespace alcove
