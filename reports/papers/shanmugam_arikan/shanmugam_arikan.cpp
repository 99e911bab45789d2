#include "reports/papers/shanmugam_arikan/shanmugam_arikan.hpp"

#include "reports/papers/shanmugam_arikan/shanmugam_arikan_parts.hpp"
#include "reports/papers/start_reproduction.hpp"

#include <array>
#include <numbers>

namespace alcove {

CellAddress find_native(const std::string& part, const std::string& label, std::size_t round) {
    return {part, round, label + " (native)"};
}

Estimate estimate_native(const Evidence& evidence, const std::string& part,
                         const std::string& label, const std::string& metric, std::size_t round) {
    return evidence.estimate_metric(find_native(part, label, round), metric, SampleState::cold);
}

Estimate compare_native(const Evidence& evidence, const std::string& part, const std::string& a,
                        const std::string& b, const std::string& metric, std::size_t round) {
    return evidence.compare_metric(find_native(part, a, round), find_native(part, b, round), metric,
                                   SampleState::cold);
}

double FillStep::get_area() const {
    const double x = epsilon / (2.0 * std::numbers::pi);
    return 1.0 / (x * (2.0 - x));
}

std::span<const FillStep> list_fill_steps() {
    static constexpr std::array<FillStep, 5> kSteps{{{"epsilon 0.5", 0.5},
                                                     {"epsilon 0.3", 0.3},
                                                     {"epsilon 0.2", 0.2},
                                                     {"epsilon 0.1", 0.1},
                                                     {"epsilon 0.05", 0.05}}};
    return kSteps;
}

const std::vector<double>& list_neighbour_counts() {
    static const std::vector<double> kCounts{8.0, 16.0, 32.0, 64.0, 128.0, 256.0};
    return kCounts;
}

Reproduction reproduce_shanmugam_arikan(const Evidence& evidence, const std::string& scale) {
    Judge judge;
    judge_shanmugam_arikan_figure5(evidence, judge);
    judge_shanmugam_arikan_quality(evidence, judge);
    judge_shanmugam_arikan_times(evidence, judge);
    list_shanmugam_arikan_untestable(judge);
    Reproduction reproduction =
        start_reproduction("SA07",
                           "Shanmugam, Arikan. Hardware accelerated ambient occlusion techniques "
                           "on GPUs. 2007.",
                           evidence, scale, judge);
    reproduction.tables = make_shanmugam_arikan_tables(evidence);
    reproduction.figures = make_shanmugam_arikan_figures(evidence);
    return reproduction;
}

} // namespace alcove
