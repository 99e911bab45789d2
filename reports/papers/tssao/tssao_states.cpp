#include "reports/papers/tssao/tssao_parts.hpp"

#include "core/base/text.hpp"
#include "reports/papers/claim.hpp"

#include <array>
#include <cmath>
#include <set>

namespace alcove {
namespace {

/// A setting that must be what is shipped.
struct Setting {
    const char* claim;
    CellAddress cell;
    const char* parameter;
    double least;
    double most;
};

const std::vector<Setting>& list_settings() {
    static const CellAddress kSibenik{"table2", kLargest, kTssao16};
    static const CellAddress kVienna{"table2", kLargest, kTssao8};
    static const CellAddress kBaseline{"table2", kLargest, kSsao};
    static const CellAddress kReference{"costs", 0, "SSAO 480"};
    static const CellAddress kStills{"stills", 0, kTssao};
    static const std::vector<Setting> kSettings{
        {"TSSAO-056", kSibenik, "initial_samples", 32, 32},
        {"TSSAO-057", kSibenik, "converged_samples", 8, 16},
        {"TSSAO-058", kSibenik, "filter_off_conv", 0.2, 0.2},
        {"TSSAO-059", kSibenik, "sample_switch_conv", 0.3, 0.3},
        {"TSSAO-060", kSibenik, "rotation_off_conv", 0.5, 0.5},
        {"TSSAO-061", kSibenik, "history_cap", 500, 1500},
        {"TSSAO-062", kSibenik, "filter_radius", 2, 2}, // taps on each side: 5x5
        {"TSSAO-110", kSibenik, "filter_off_conv", 0.2, 0.2},
        {"TSSAO-120", kSibenik, "cut", 2, 2},
        {"TSSAO-121", kStills, "grazing_cosine", 1e-6, 0.3}, // eps not published
        {"TSSAO-123", kVienna, "converged_samples", 8, 8},
        {"TSSAO-124", kSibenik, "converged_samples", 16, 16},
        {"TSSAO-125", kBaseline, "initial_samples", 32, 32},
        {"TSSAO-126", kReference, "initial_samples", 480, 480},
    };
    return kSettings;
}

void judge_settings(const Evidence& evidence, Judge& judge) {
    for (const Setting& setting : list_settings()) {
        const double value =
            parse_number(evidence.find_parameter(setting.cell, setting.parameter), "plan");
        judge.set(setting.claim, {judge_within(make_single(value), setting.least, setting.most),
                                  std::string(setting.parameter) + " of the cell that ran",
                                  make_single(value), setting.cell.label});
    }
    const std::string border = evidence.find_parameter({"table2", kLargest, kTssao16}, "border");
    judge.set("TSSAO-115", {border == "clamp" ? Outcome::holds : Outcome::fails,
                            "samples off the screen take the border's value: border=clamp",
                            std::nullopt, border});
}

CellAddress get_state_cell(int cap, int samples) {
    return {"states", 0,
            "tssao@paper_table2_vienna:converged_samples=" + std::to_string(samples) +
                ",history_cap=" + std::to_string(cap)};
}

std::vector<double> get_convergence(const Evidence& evidence, int cap, int samples) {
    return evidence.get_values(get_state_cell(cap, samples), "history_convergence",
                               SampleState::cold);
}

/// The frame, counted from 1, after which the convergence has reached `threshold`; 0 if never.
int find_frame(const std::vector<double>& convergence, double threshold) {
    for (std::size_t i = 0; i < convergence.size(); ++i) {
        if (convergence[i] >= threshold - 1e-6) {
            return static_cast<int>(i) + 1;
        }
    }
    return 0;
}

struct StateRow {
    const char* claim;
    int cap;
    int samples;
};

constexpr std::array kStates{
    StateRow{"TSSAO-145", 500, 8},  StateRow{"TSSAO-146", 500, 16},
    StateRow{"TSSAO-147", 1000, 8}, StateRow{"TSSAO-148", 1000, 16},
    StateRow{"TSSAO-149", 1500, 8}, StateRow{"TSSAO-150", 1500, 16},
};

void judge_state_machine(const Evidence& evidence, Judge& judge) {
    std::set<double> taken;
    for (const StateRow& row : kStates) {
        const std::vector<double> convergence = get_convergence(evidence, row.cap, row.samples);
        std::string found;
        for (const double threshold : {0.2, 0.3, 0.5, 1.0}) {
            found += found.empty() ? "" : " / ";
            found += std::to_string(find_frame(convergence, threshold));
        }
        std::string published;
        for (const Claim& claim : load_claims("TSSAO")) {
            published = claim.id == row.claim ? claim.value : published;
        }
        judge.set(row.claim, {found == published ? Outcome::holds : Outcome::fails,
                              "frames until filter off / k2 / rotation off / cap", std::nullopt,
                              "measured " + found + " on a view at rest"});
        if (row.samples == 8) {
            for (const double samples : evidence.get_values(get_state_cell(row.cap, row.samples),
                                                            "history_samples", SampleState::cold)) {
                taken.insert(std::round(samples));
            }
        }
    }
    judge.set("TSSAO-113", {taken == std::set<double>{8.0, 32.0} ? Outcome::holds : Outcome::fails,
                            "a frame at rest takes k1 or k2 samples a pixel and nothing between",
                            std::nullopt, std::to_string(taken.size()) + " numbers of samples"});
}

struct WeightRow {
    const char* plateau_claim;
    const char* decay_claim;
    int cap;
};

constexpr std::array kWeights{WeightRow{"TSSAO-072", "TSSAO-073", 500},
                              WeightRow{"TSSAO-074", "TSSAO-075", 1000},
                              WeightRow{"TSSAO-076", "TSSAO-077", 1500}};

/// Figure 4, from the counts that the histories report: a new sample weighs 1 / (n + k), and every
/// frame multiplies what was there by n / (n + k).
void judge_weights(const Evidence& evidence, Judge& judge) {
    constexpr int kSamples = 8;
    constexpr double kPlotted = 5000.0; // samples, the figure's axis
    for (const WeightRow& row : kWeights) {
        const double reached = get_convergence(evidence, row.cap, kSamples).back() * row.cap;
        const double weight = 1.0 / (reached + kSamples);
        const double remaining = std::pow(reached / (reached + kSamples), kPlotted / kSamples);
        const double limit = 1.0 / row.cap;
        // What is printed is the limit k << n; k/n_max is 1.6 % at most here.
        judge.set(row.plateau_claim,
                  {judge_within(make_single(weight / limit), 0.9, 1.1),
                   "weight of a new sample at the cap over the printed limit within 10 % of 1",
                   make_single(weight / limit), "from the count that the history reports, k = 8"});
        const double printed = std::exp(-kPlotted / row.cap);
        judge.set(row.decay_claim,
                  {judge_within(make_single(remaining / printed), 0.9, 1.1),
                   "what 5000 samples leave of an old solution, over the printed limit, within "
                   "10 % of 1",
                   make_single(remaining / printed),
                   "from the count that the history reports, k = 8"});
    }
}

} // namespace

void judge_tssao_states(const Evidence& evidence, Judge& judge) {
    judge_settings(evidence, judge);
    judge_state_machine(evidence, judge);
    judge_weights(evidence, judge);
}

} // namespace alcove
