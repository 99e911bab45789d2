#include "reports/analysis/history_points.hpp"

#include "core/base/hash.hpp"
#include "reports/analysis/analysis.hpp"
#include "reports/analysis/comparison_matching.hpp"
#include "reports/analysis/comparison_time.hpp"
#include "reports/analysis/metric_table.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include <fmt/core.h>

namespace alcove {
namespace {

constexpr const char* kEnvelope = "envelope";
constexpr const char* kAnchors = "x anchor";
constexpr const char* kCold = "cold";
constexpr const char* kConverged = "converged";

/// "llvmpipe" of "llvmpipe (LLVM 15.0.6, 256 bits)": what is in brackets are versions.
std::string drop_versions(const std::string& renderer) {
    return renderer.substr(0, renderer.find(" ("));
}

std::string find_scene_content(const RunFolder& run, const RoundRecord& round,
                               const RoundDone& done) {
    for (const ReuseRecord& reuse : done.reuse) {
        for (const IngredientRecord& content : reuse.contents) {
            if (content.name == kShownIngredient) {
                return content.value;
            }
        }
    }
    for (const SceneDescription& scene : run.plan().scenes) {
        if (scene.name == round.scene.substr(0, round.scene.find(':'))) {
            return scene.content_hash;
        }
    }
    return {};
}

std::string describe_reference(const RunFolder& run, const RoundRecord& round) {
    std::string text = describe_configuration(round.reference);
    for (const MethodDescription& method : run.plan().methods) {
        if (method.name == round.reference.method) {
            text += " sources " + method.content_hash;
        }
    }
    return fmt::format("{}, {} rays in each half", text, run.plan().reference_rays_per_half);
}

/// The points of one round.
class RoundPoints {
  public:
    RoundPoints(const RunFolder& run, const RoundAnalysis& round, std::vector<NightPoint>& points)
        : m_run(run), m_round(round), m_points(points) {
        const ContextRecord& context = run.context();
        const std::string drawing = fmt::format("{}, {}, {}", context.gl_renderer,
                                                context.gl_version, context.cpu_features);
        const std::string scene = find_scene_content(run, round.round, round.done);
        m_of_times = {0,
                      fmt::format("{}, {}, {}", drawing, context.context_kind, context.timer_mode),
                      context.anchor_version, scene, ""};
        m_of_images = {0, drawing, "", scene, ""};
        m_of_metrics = {0, drawing, "", scene, describe_reference(run, round.round)};
    }

    void add(const CellAnalysis& cell, const AnchoredCell& times,
             const std::vector<const MetricRow*>& rows) {
        m_name = make_name(cell.cell);
        add_times(cell, times);
        add_metrics(cell.cold, kCold);
        add_metrics(cell.converged, kConverged);
        add_metrics(cell.temporal, kCold);
        add_images(rows);
    }

  private:
    SeriesName make_name(const CellRecord& cell) const {
        const RoundRecord& round = m_round.round;
        return {name_device(m_run.context()),
                m_run.plan().experiment,
                round.scene,
                round.walkthrough,
                (round.warm ? "warm " : "") + describe_segments(round),
                round.target,
                fmt::format("{}x{}", round.width, round.height),
                round.precision,
                cell.label,
                cell.effects,
                "",
                "",
                ""};
    }

    NightPoint& add(SeriesKind kind, const StoredSegment& segment, std::string state,
                    std::string pass, std::string metric, double value, std::size_t n) {
        NightPoint& point = m_points.emplace_back();
        point.name = m_name;
        point.name.state = std::move(state);
        point.name.pass = std::move(pass);
        point.name.metric = std::move(metric);
        point.kind = kind;
        point.segment = segment;
        point.value = value;
        point.n = static_cast<std::int64_t>(n);
        point.round = m_round.round.id;
        return point;
    }

    void add_time(SeriesKind kind, const char* state, const std::string& pass, const char* metric,
                  const Estimate& estimate) {
        // A pass of no time at all, on a clock with coarse ticks, has no ratio.
        if (std::isfinite(estimate.value) && (estimate.value > 0.0 || !has_logarithm(kind))) {
            add(kind, m_of_times, state, pass, metric, estimate.value, estimate.n).interval =
                estimate.interval;
        }
    }

    void add_times(const CellAnalysis& cell, const AnchoredCell& times) {
        if (cell.ratio) {
            add_time(SeriesKind::time, kCold, kEnvelope, kAnchors, *cell.ratio);
        }
        if (cell.time_ms && cell.cell.has_passes) {
            add_time(SeriesKind::milliseconds, kCold, kEnvelope, "ms", *cell.time_ms);
        }
        for (const PartShare& part : estimate_parts(times)) {
            if (part.part == kConvergedPart) {
                add_time(SeriesKind::time, kConverged, kEnvelope, kAnchors, part.share);
            } else if (!is_input_pass(part.part)) {
                add_time(SeriesKind::pass, kCold, part.part, kAnchors, part.share);
            } else if (!part.is_cached) {
                add_time(SeriesKind::input, kCold, part.part, kAnchors, part.share);
            }
        }
    }

    void add_metrics(const std::vector<MetricAnalysis>& table, const char* state) {
        for (const MetricAnalysis& metric : table) {
            if (metric.frames > 0 && std::isfinite(metric.shown())) {
                add(SeriesKind::quality, m_of_metrics, state, "", metric.metric, metric.shown(),
                    metric.frames)
                    .lower_is_better = is_lower_better(m_run.plan(), metric.metric);
            }
        }
    }

    /// Of all frames and states, in an order of their own.
    void add_images(const std::vector<const MetricRow*>& rows) {
        std::set<std::tuple<int, int, int, std::string>> images;
        for (const MetricRow* row : rows) {
            if (!row->image_hash.empty()) {
                images.emplace(row->segment, row->frame, static_cast<int>(row->state),
                               row->image_hash);
            }
        }
        if (images.empty()) {
            return;
        }
        Hasher hasher;
        for (const auto& [segment, frame, state, hash] : images) {
            hasher.add(segment).add(frame).add(state).add(hash);
        }
        add(SeriesKind::images, m_of_images, "all", "", "images",
            static_cast<double>(images.size()), images.size())
            .image_hash = to_hex(hasher.finish64());
    }

    const RunFolder& m_run;
    const RoundAnalysis& m_round;
    std::vector<NightPoint>& m_points;
    StoredSegment m_of_times;
    StoredSegment m_of_images;
    StoredSegment m_of_metrics;
    SeriesName m_name;
};

/// Two cells of a run can bear one label (`--method tssao --method tssao`): the later ones are
/// numbered.
void number_repeated(std::vector<NightPoint>& points) {
    std::map<SeriesName, int> seen;
    for (NightPoint& point : points) {
        if (const int before = seen[point.name]++; before > 0) {
            point.name.method += fmt::format(" ({})", before + 1);
        }
    }
}

} // namespace

std::string name_device(const ContextRecord& context) {
    return fmt::format("{}: {}, {}, {} threads", context.device_class,
                       drop_versions(context.gl_renderer), context.cpu, context.driver_threads);
}

StoredRun describe_night(const RunFolder& run) {
    const ContextRecord& context = run.context();
    StoredRun night;
    night.utc = context.started_utc;
    night.build = context.build_id;
    night.device = name_device(context);
    night.device_class = context.device_class;
    night.timer_mode = context.timer_mode;
    night.suite = run.plan().experiment;
    return night;
}

std::vector<NightPoint> collect_points(const RunFolder& run) {
    const RunAnalysis analysis = analyze_run(run);
    std::map<std::string, std::vector<SampleRow>> samples;
    for (SampleRow& row : run.read_samples()) {
        samples[row.round].push_back(std::move(row));
    }
    const std::vector<MetricRow> metrics = run.read_metrics();
    std::map<std::pair<std::string, std::string>, std::vector<const MetricRow*>> rows;
    for (const MetricRow& row : metrics) {
        rows[{row.round, row.cell}].push_back(&row);
    }
    std::vector<NightPoint> points;
    for (const RoundAnalysis& round : analysis.rounds) {
        RoundSeries series = sort_samples(samples[round.round.id]);
        const auto anchor =
            std::find_if(round.cells.begin(), round.cells.end(), [](const CellAnalysis& cell) {
                return cell.cell.role == CellRole::anchor;
            });
        const CellSeries unit =
            anchor == round.cells.end() ? CellSeries() : series.cells[anchor->cell.id];
        RoundPoints adder(run, round, points);
        for (const CellAnalysis& cell : round.cells) {
            if (cell.cell.role == CellRole::method) {
                adder.add(cell, {series.cells[cell.cell.id], unit},
                          rows[{round.round.id, cell.cell.id}]);
            }
        }
    }
    number_repeated(points);
    return points;
}

} // namespace alcove
