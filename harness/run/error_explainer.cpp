#include "harness/run/error_explainer.hpp"

#include "harness/run/wall_time.hpp"

#include <algorithm>
#include <limits>

namespace alcove {
namespace {

constexpr const char* kMarch = "reference_brute_force";
/// Enough to tell thicknesses apart: the noise of 48 rays (0.01) averages out over a frame.
constexpr int kSearchRays = 48;
/// In each of two randomisations, whose difference is the march's noise.
constexpr int kMarchRays = 128;
constexpr double kInfinite = std::numeric_limits<double>::infinity();

double compute_mse(const Image& a, const Image& b) {
    return compute_steps({a, nullptr, b, b}).total;
}

} // namespace

ErrorExplainer::ErrorExplainer(RoundStage& stage, RoundDone& done, std::filesystem::path run_folder)
    : m_stage(stage), m_done(done), m_pictures(stage, done, std::move(run_folder)) {}

void ErrorExplainer::run() {
    const WallTime wall(m_done.explaining_s);
    const auto is_method = [](const MethodCell& cell) {
        return cell.record().role == CellRole::method;
    };
    std::vector<MethodCell>& cells = m_stage.cells();
    if (m_stage.list_singles().empty() || std::none_of(cells.begin(), cells.end(), is_method)) {
        return;
    }
    take_truth();
    choose_thickness();
    march_frames();
    for (MethodCell& cell : cells) {
        if (is_method(cell)) {
            explain_cell(cell);
        }
    }
}

void ErrorExplainer::take_truth() {
    const std::unique_ptr<TruthSource> source = make_truth_source(m_stage);
    for (const RoundFrame& single : m_stage.list_singles()) {
        Frame frame;
        frame.frame = single;
        frame.truth = source->get(single.view);
        if (frame.truth.halves) {
            const double noise = compute_noise(*frame.truth.halves);
            frame.truth_noise = noise * noise;
        }
        m_frames.push_back(std::move(frame));
    }
}

CellRecord ErrorExplainer::make_march(double thickness, int rays) const {
    const MethodUnit& unit = m_stage.units().methods.find(kMarch);
    MethodSpec spec;
    spec.method = kMarch;
    spec.label = kMarch;
    spec.overrides = {{"thickness", to_text(ParameterValue{thickness})},
                      {"rays", std::to_string(rays)}};
    return make_cell_record(unit, spec, parse_target(m_stage.round().target, {}),
                            m_stage.round().ao_radius_m);
}

void ErrorExplainer::choose_thickness() {
    ThicknessRecord best{0.0, kInfinite, true};
    std::vector<double> thicknesses(kThicknesses.begin(), kThicknesses.end());
    thicknesses.push_back(kInfinite);
    for (const double thickness : thicknesses) {
        const std::vector<Image> images = take_images(make_march(thickness, kSearchRays), 1);
        double sum = 0.0;
        for (std::size_t i = 0; i < images.size(); ++i) {
            sum += compute_mse(images[i], m_frames[i].truth.mean);
        }
        const double mse = sum / static_cast<double>(images.size());
        m_done.thicknesses.push_back({thickness, mse, false});
        if (thickness != kInfinite && mse < best.mse) {
            best = {thickness, mse, true};
        }
    }
    m_best_thickness = best.thickness;
    for (ThicknessRecord& record : m_done.thicknesses) {
        record.is_best = record.thickness == best.thickness;
    }
}

void ErrorExplainer::march_frames() {
    for (const bool is_infinite : {true, false}) {
        const CellRecord record =
            make_march(is_infinite ? kInfinite : m_best_thickness, kMarchRays);
        std::vector<Image> a = take_images(record, 1);
        std::vector<Image> b = take_images(record, 2);
        for (std::size_t i = 0; i < m_frames.size(); ++i) {
            const ImageHalves halves{std::move(a[i]), std::move(b[i])};
            (is_infinite ? m_frames[i].infinite : m_frames[i].best) = halves.compute_mean();
            (is_infinite ? m_frames[i].infinite_noise : m_frames[i].best_noise) =
                halves.compute_noise();
        }
    }
    for (const Frame& frame : m_frames) {
        const int index = frame.frame.view.index;
        if (m_pictures.is_kept(index)) {
            m_pictures.write_step("reference", index, "step3_infinite", frame.infinite,
                                  frame.truth.mean);
            m_pictures.write_step("reference", index, "step3_best", frame.best, frame.truth.mean);
        }
    }
}

std::vector<Image> ErrorExplainer::take_images(MethodCell& cell, std::uint32_t seed) {
    std::vector<Image> images;
    for (const Frame& frame : m_frames) {
        m_stage.warm_up(cell, frame.frame.view);
        MethodInputs inputs = m_stage.make_measured_inputs(cell);
        inputs.noise_seed = seed;
        CellTimes times;
        const MethodOutput output = cell.render(inputs, PassTiming::none, m_stage.timer(), times);
        images.push_back(m_stage.read_measured(cell, output));
    }
    return images;
}

std::vector<Image> ErrorExplainer::take_images(const CellRecord& record, std::uint32_t seed) {
    MethodCell cell(m_stage.context(), m_stage.units().methods.find(record.method), record,
                    m_stage.size());
    m_stage.add_gbuffers(RoundStage::list_keys(cell));
    return take_images(cell, seed);
}

void ErrorExplainer::explain_cell(MethodCell& cell) {
    const MethodUnit& unit = m_stage.units().methods.find(cell.record().method);
    const std::vector<Image> images = take_images(cell, kRoundNoiseSeed);
    std::vector<Image> converged;
    if (unit.converged_preset) {
        converged = take_images(
            override_cell(unit, cell.record(), unit.find_preset(*unit.converged_preset).overrides),
            kRoundNoiseSeed);
    }
    for (std::size_t i = 0; i < m_frames.size(); ++i) {
        explain_frame(cell, i, images[i], converged.empty() ? nullptr : &converged[i]);
    }
    fit_curves(cell, images);
}

void ErrorExplainer::explain_frame(const MethodCell& cell, std::size_t index, const Image& image,
                                   const Image* converged) {
    const Frame& frame = m_frames[index];
    const std::string& id = cell.record().id;
    const Image& form = converged != nullptr ? *converged : image;
    const bool is_kept = m_pictures.is_kept(frame.frame.view.index);
    if (is_kept && converged != nullptr) {
        m_pictures.write_step(id, frame.frame.view.index, "step1", image, form);
    }
    for (const bool is_infinite : {true, false}) {
        const Image& march = is_infinite ? frame.infinite : frame.best;
        StepRecord steps = compute_steps({image, converged, march, frame.truth.mean});
        steps.cell = id;
        steps.segment = frame.frame.segment;
        steps.frame = frame.frame.view.index;
        steps.thickness = is_infinite ? kInfinite : m_best_thickness;
        steps.truth_noise = frame.truth_noise;
        steps.march_noise = is_infinite ? frame.infinite_noise : frame.best_noise;
        m_done.steps.push_back(std::move(steps));
        if (is_kept) {
            m_pictures.write_step(id, frame.frame.view.index,
                                  is_infinite ? "step2_infinite" : "step2_best", form, march);
        }
    }
}

void ErrorExplainer::fit_curves(const MethodCell& cell, const std::vector<Image>& images) {
    std::array<CurveMoments, 2> folds;
    CurveMoments all;
    for (std::size_t i = 0; i < images.size(); ++i) {
        CurveMoments moments;
        moments.add(images[i].values(), m_frames[i].truth.mean.values());
        folds.at(i % 2).add(moments);
        all.add(moments);
    }
    CurveRecord record;
    record.cell = cell.record().id;
    record.frames = static_cast<int>(images.size());
    const MonotoneCurve curve = all.fit();
    record.visibility = curve.x;
    record.curved = curve.y;
    record.mse = all.compute_mse();
    record.mse_fitted = all.compute_mse(curve);
    double held_out = 0.0;
    for (std::size_t fold = 0; fold < 2; ++fold) {
        const CurveMoments& judged = folds.at(1 - fold);
        if (folds.at(fold).count() > 0.0 && judged.count() > 0.0) {
            held_out += judged.compute_mse(folds.at(fold).fit()) * judged.count() / all.count();
        }
    }
    // One frame has nothing to be held out.
    record.mse_held_out = images.size() > 1 ? held_out : std::numeric_limits<double>::quiet_NaN();
    m_done.curves.push_back(std::move(record));
}

} // namespace alcove
