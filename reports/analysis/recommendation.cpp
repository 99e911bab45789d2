#include "reports/analysis/recommendation.hpp"

#include "core/base/error.hpp"
#include "core/base/nearest_name.hpp"
#include "core/base/text.hpp"
#include "reports/analysis/metric_table.hpp"
#include "reports/analysis/wording.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/core.h>

namespace alcove {
namespace {

enum class Meets { surely, perhaps, no };

Meets check(const TradeoffPoint& point, const QualityBound& quality) {
    const Interval bounds = get_bounds(point.error);
    const bool has_all =
        quality.is_below ? bounds.upper < quality.bound : bounds.lower > quality.bound;
    const bool has_some =
        quality.is_below ? bounds.lower < quality.bound : bounds.upper > quality.bound;
    return has_all ? Meets::surely : (has_some ? Meets::perhaps : Meets::no);
}

std::string describe_point(const TradeoffPoint& point, const std::string& metric) {
    const std::string time =
        point.time.n == 0 ? "no passes" : describe_estimate(point.time) + " x anchor";
    return fmt::format("{}: {}, {} {}", point.label, time, metric, describe_estimate(point.error));
}

} // namespace

QualityBound parse_quality(std::string_view text, const PlanRecord& plan) {
    const std::size_t sign = text.find_first_of("<>");
    const char* const expected = "METRIC<NUMBER or METRIC>NUMBER, for example RMSE<0.05";
    if (sign == std::string_view::npos || sign == 0 || sign + 1 == text.size()) {
        throw InputError("--quality", "cannot be read", text, expected);
    }
    QualityBound quality;
    for (const char c : text.substr(0, sign)) {
        quality.metric += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    quality.is_below = text[sign] == '<';
    quality.bound = parse_number(text.substr(sign + 1), "--quality");
    if (!std::isfinite(quality.bound)) {
        throw InputError("--quality", "out of range", text, "a finite number");
    }
    std::vector<std::string> names;
    for (const MetricDescription& metric : plan.metrics) {
        if (metric.kind == "image") {
            names.push_back(metric.name);
        }
    }
    if (std::find(names.begin(), names.end(), quality.metric) == names.end()) {
        throw InputError("--quality", "the run has no such metric", quality.metric,
                         describe_choices(quality.metric, names));
    }
    if (quality.is_below != is_lower_better(plan, quality.metric)) {
        throw InputError("--quality", "a bound against the metric's direction", text,
                         quality.metric + (quality.is_below ? ">" : "<") + "NUMBER");
    }
    return quality;
}

std::vector<Recommendation> recommend(const RunAnalysis& run, const QualityBound& quality) {
    std::vector<Recommendation> recommendations;
    for (const Tradeoff& tradeoff : compute_tradeoffs(run, quality.metric)) {
        Recommendation recommendation;
        recommendation.scene = tradeoff.scene;
        recommendation.target = tradeoff.target;
        recommendation.width = tradeoff.width;
        recommendation.height = tradeoff.height;
        const double sign = quality.is_below ? 1.0 : -1.0;
        recommendation.most_accurate =
            *std::min_element(tradeoff.points.begin(), tradeoff.points.end(),
                              [sign](const TradeoffPoint& a, const TradeoffPoint& b) {
                                  return sign * a.error.value < sign * b.error.value;
                              });
        for (const TradeoffPoint& point : tradeoff.points) { // from fast to slow
            const Meets meets = check(point, quality);
            if (meets == Meets::surely) {
                const bool is_first = recommendation.cells.empty();
                const bool is_told_apart =
                    !is_first && get_bounds(point.time).lower >
                                     get_bounds(recommendation.cells.front().time).upper;
                if (is_first || !is_told_apart) {
                    recommendation.cells.push_back(point);
                }
            } else if (meets == Meets::perhaps && recommendation.cells.empty()) {
                recommendation.uncertain.push_back(point);
            }
        }
        recommendations.push_back(std::move(recommendation));
    }
    return recommendations;
}

std::string describe_recommendation(const Recommendation& recommendation,
                                    const QualityBound& quality) {
    std::string text = fmt::format("{} {}x{}, {}: ", recommendation.scene, recommendation.width,
                                   recommendation.height, recommendation.target);
    if (recommendation.cells.empty()) {
        text += recommendation.uncertain.empty()
                    ? "nothing that ran has this quality"
                    : "the data cannot decide: no cell surely has this quality";
        text +=
            "; most accurate is " + describe_point(recommendation.most_accurate, quality.metric);
    } else if (recommendation.cells.size() == 1) {
        text += describe_point(recommendation.cells.front(), quality.metric);
    } else {
        text += "the data cannot decide between";
        for (const TradeoffPoint& point : recommendation.cells) {
            text += "\n  " + describe_point(point, quality.metric);
        }
    }
    for (const TradeoffPoint& point : recommendation.uncertain) {
        text += (recommendation.cells.empty() ? "\n  perhaps: " : "\n  faster, and perhaps: ") +
                describe_point(point, quality.metric);
    }
    return text;
}

} // namespace alcove
