#include "reports/papers/ssdo/ssdo.hpp"

#include "reports/papers/ssdo/ssdo_parts.hpp"
#include "reports/papers/start_reproduction.hpp"

#include <array>

namespace alcove {

std::span<const SsdoRow> list_ssdo_rows() {
    static constexpr std::array<SsdoRow, 6> kRows{
        {{"1024x768", 0, 8, 81.0, 81.3, 0.2, 65.8, 19.3,
          "these frame rates give -0.4 % and 18.8 %; 81.5 for ambient occlusion gives both as "
          "printed",
          1},
         {"1024x768", 0, 16, 58.0, 56.5, 2.6, 40.5, 30.2, "", 6},
         {"1200x960", 1, 8, 37.7, 37.5, 0.5, 25.5, 32.4, "", 11},
         {"1200x960", 1, 16, 25.4, 23.6, 7.1, 14.7, 22.2,
          "these frame rates give 42.1 % with a bounce; the text's mean uses 22.2 %", 16},
         {"1600x1200", 3, 8, 24.8, 24.2, 2.4, 15.9, 35.9, "", 21},
         {"1600x1200", 3, 16, 16.8, 15.3, 8.9, 9.0, 46.4, "", 26}}};
    return kRows;
}

std::span<const char* const> list_ssdo_sizes() {
    static constexpr std::array<const char*, 4> kSizes{"1024x768", "1200x960, as printed",
                                                       "1280x960, as it scales", "1600x1200"};
    return kSizes;
}

CellAddress find_table1_cell(std::size_t round, const char* what, int samples) {
    return {"table1", round, std::string(what) + " " + std::to_string(samples)};
}

namespace {

/// 1 - 1 / ratio in percent; of a ratio of times, what is lost of the rate.
Estimate make_loss(const Estimate& inverse) {
    // inverse: time of ambient occlusion / time of the other, which is fps / fps.
    Estimate loss = inverse;
    loss.value = 100.0 * (1.0 - inverse.value);
    loss.minimum = 100.0 * (1.0 - inverse.maximum);
    loss.maximum = 100.0 * (1.0 - inverse.minimum);
    if (inverse.interval) {
        loss.interval = Interval{100.0 * (1.0 - inverse.interval->upper),
                                 100.0 * (1.0 - inverse.interval->lower)};
    }
    return loss;
}

} // namespace

Estimate estimate_frame_loss(const Evidence& evidence, std::size_t round, const char* what,
                             int samples) {
    return make_loss(evidence.compare_frames(find_table1_cell(round, "SSAO", samples),
                                             find_table1_cell(round, what, samples)));
}

Estimate estimate_pass_loss(const Evidence& evidence, std::size_t round, const char* what,
                            int samples) {
    return make_loss(evidence.compare_costs(find_table1_cell(round, "SSAO", samples),
                                            find_table1_cell(round, what, samples)));
}

Estimate compare_values(const Evidence& evidence, const std::string& part, std::size_t round,
                        const std::string& a, const std::string& b, const std::string& metric) {
    return evidence.compare_metric({part, round, a}, {part, round, b}, metric, SampleState::cold);
}

std::string name_scene(const Evidence& evidence, const std::string& part, std::size_t round) {
    const std::string& scene = evidence.get_round(part, round).scene;
    return scene.substr(0, scene.find(':'));
}

Estimate estimate_value(const Evidence& evidence, const std::string& part, std::size_t round,
                        const std::string& label, const std::string& metric) {
    return evidence.estimate_metric({part, round, label}, metric, SampleState::cold);
}

std::size_t find_fig13_round(std::size_t scene, Reach reach) {
    return 2 * scene + static_cast<std::size_t>(reach);
}

Reproduction reproduce_ssdo(const Evidence& evidence, const std::string& scale) {
    Judge judge;
    judge_ssdo_times(evidence, judge);
    judge_ssdo_light(evidence, judge);
    judge_ssdo_samples(evidence, judge);
    judge_ssdo_truth(evidence, judge);
    judge_ssdo_shadows(evidence, judge);
    list_ssdo_untestable(judge);
    Reproduction reproduction =
        start_reproduction("SSDO",
                           "Ritschel, Grosch, Seidel. Approximating dynamic global illumination "
                           "in image space. 2009.",
                           evidence, scale, judge);
    reproduction.tables = make_ssdo_tables(evidence);
    reproduction.figures = make_ssdo_figures(evidence);
    return reproduction;
}

} // namespace alcove
