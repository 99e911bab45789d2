#include "tests/reports/tradeoff_runs.hpp"

#include <utility>

namespace alcove {
namespace {

MetricDescription describe(const char* name, bool lower_is_better) {
    MetricDescription metric;
    metric.name = name;
    metric.lower_is_better = lower_is_better;
    return metric;
}

} // namespace

Estimate known(double value, double half_width) {
    return {value, Interval{value - half_width, value + half_width}, value - half_width,
            value + half_width, 6};
}

CellAnalysis make_cell(const std::string& label, Estimate time, const std::string& metric,
                       Estimate error) {
    CellAnalysis cell;
    cell.cell.id = label;
    cell.cell.label = label;
    cell.cell.method = label.substr(0, label.find(':'));
    cell.ratio = time;
    MetricAnalysis analysis;
    analysis.metric = metric;
    analysis.frames = 6;
    analysis.value = error.value;
    analysis.content = error;
    cell.cold.push_back(analysis);
    return cell;
}

RoundAnalysis make_round(const std::string& id, std::vector<CellAnalysis> cells) {
    RoundAnalysis round;
    round.round.id = id;
    round.round.scene = "hall";
    round.round.width = 64;
    round.round.height = 48;
    round.round.target = "radius=1 m";
    round.round.segments = {{10, 14}};
    round.front_metric = "rmse";
    round.cells = std::move(cells);
    return round;
}

RunAnalysis make_run(std::vector<RoundAnalysis> rounds) {
    RunAnalysis run;
    run.plan.metrics = {describe("rmse", true), describe("ssim", false)};
    run.rounds = std::move(rounds);
    return run;
}

RunAnalysis make_simple_run(double width) {
    const auto make = [width](const char* label, double time, double error) {
        return make_cell(label, known(time, width * time), "rmse", known(error, width * error));
    };
    return make_run({make_round("r0", {make("slow", 8.0, 0.01), make("a:n=1", 1.0, 0.08),
                                       make("a:n=4", 4.0, 0.02), make("b", 5.0, 0.04)})});
}

Labels list_labels(const std::vector<TradeoffPoint>& points) {
    Labels labels;
    for (const TradeoffPoint& point : points) {
        labels.push_back(point.label);
    }
    return labels;
}

} // namespace alcove
