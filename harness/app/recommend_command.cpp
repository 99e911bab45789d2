#include "core/base/error.hpp"
#include "harness/app/verbs.hpp"
#include "reports/analysis/recommendation.hpp"
#include "reports/analysis/wording.hpp"

#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace alcove {
namespace {

struct RecommendFlags {
    std::string run;
    std::string quality;
    std::optional<double> budget_ms;
};

/// The most accurate cell of every scene whose whole frame surely is within the budget.
int recommend_by_budget(const RunAnalysis& run, double budget_ms) {
    if (run.context.device_class == "software") {
        throw InputError("--budget", "times of a software device never speak for a GPU",
                         describe_device(run.context),
                         "--quality, or a run on the device that the budget is for");
    }
    if (!(budget_ms > 0.0)) {
        throw InputError("--budget", "out of range", fmt::format("{}", budget_ms),
                         "milliseconds above 0");
    }
    for (const Tradeoff& tradeoff : compute_tradeoffs(run)) {
        const TradeoffPoint* best = nullptr;
        for (const TradeoffPoint& point : tradeoff.points) {
            for (const RoundAnalysis& round : run.rounds) {
                for (const CellAnalysis& cell : round.cells) {
                    const bool is_it = round.round.id == point.round && cell.cell.id == point.cell;
                    const bool fits = is_it && cell.total_ms && cell.total_ms->interval &&
                                      cell.total_ms->interval->upper <= budget_ms;
                    const double sign = tradeoff.lower_is_better ? 1.0 : -1.0;
                    if (fits &&
                        (best == nullptr || sign * point.error.value < sign * best->error.value)) {
                        best = &point;
                    }
                }
            }
        }
        fmt::print("{} {}x{}, {}: {}\n", tradeoff.scene, tradeoff.width, tradeoff.height,
                   tradeoff.target,
                   best == nullptr ? "no frame surely is within the budget"
                                   : fmt::format("{}, {} {}", best->label, tradeoff.metric,
                                                 describe_estimate(best->error)));
    }
    return 0;
}

int recommend_for(const RecommendFlags& flags) {
    if (flags.quality.empty() == !flags.budget_ms.has_value()) {
        throw InputError("recommend", "asks for one of two", "",
                         "--quality METRIC<NUMBER or --budget MS");
    }
    const RunAnalysis run = analyze_run(RunFolder::open(flags.run));
    if (flags.budget_ms) {
        return recommend_by_budget(run, *flags.budget_ms);
    }
    const QualityBound quality = parse_quality(flags.quality, run.plan);
    const std::vector<Recommendation> recommendations = recommend(run, quality);
    if (recommendations.empty()) {
        throw InputError(flags.run, "no round with two cells that have a time and this error",
                         quality.metric);
    }
    for (const Recommendation& recommendation : recommendations) {
        fmt::print("{}\n", describe_recommendation(recommendation, quality));
    }
    fmt::print("Times over the anchor's on {}; errors with their spread over frames.\n",
               describe_device(run.context));
    return 0;
}

} // namespace

Action add_recommend_verb(CLI::App& app) {
    auto flags = std::make_shared<RecommendFlags>();
    app.add_option("run", flags->run, "run folder")->required();
    app.add_option("--quality", flags->quality, "METRIC<NUMBER, for example RMSE<0.05");
    app.add_option("--budget", flags->budget_ms,
                   "milliseconds of a whole frame; refused for software devices");
    return [flags] { return recommend_for(*flags); };
}

} // namespace alcove
