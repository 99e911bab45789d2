#include "reports/papers/tssao/tssao_parts.hpp"

#include "core/base/text.hpp"
#include "reports/analysis/wording.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/core.h>

namespace alcove {
namespace {

using Row = std::vector<std::string>;

constexpr auto kCold = SampleState::cold;
constexpr auto kConverged = SampleState::converged;

PaperTable make_table1(const Evidence& evidence) {
    PaperTable table{"table1",
                     "Table 1: parameters",
                     "of the cell that ran as Table 2, Sibenik",
                     {"parameter", "symbol", "published", "ran with"},
                     {}};
    struct Line {
        const char* parameter;
        const char* symbol;
        const char* published;
    };
    constexpr std::array kLines{
        Line{"initial_samples", "k1", "32"},
        Line{"converged_samples", "k2", "8-16"},
        Line{"filter_off_conv", "c_adaptive", "0.2"},
        Line{"sample_switch_conv", "c_spatial", "0.3"},
        Line{"rotation_off_conv", "c_rot", "0.5"},
        Line{"history_cap", "n_max", "500-1500"},
        Line{"filter_radius", "F", "2 (5x5)"},
    };
    for (const Line& line : kLines) {
        table.rows.push_back(
            {line.parameter, line.symbol, line.published,
             evidence.find_parameter({"table2", kLargest, kTssao16}, line.parameter)});
    }
    return table;
}

struct PublishedRow {
    const char* part;
    std::size_t round;
    const char* size;
    double ssao_fps;
    double tssao_fps;
};

/// Sibenik's columns, as read in errata.csv.
constexpr std::array kPublished{
    PublishedRow{"table2", kLargest, "1600x1200", 10, 12},
    PublishedRow{"table2", kMiddle, "1024x768", 21, 25},
    PublishedRow{"table2", kSmallest, "800x600", 29, 34},
    PublishedRow{"table2_half", 0, "800x600 half", 47, 49},
};

PaperTable make_table2(const Evidence& evidence) {
    PaperTable table{"table2",
                     "Table 2: frame rates, Sibenik's columns",
                     "published on a GeForce GTX 280 in Sibenik, measured here on " +
                         describe_device(evidence.context()) +
                         " in the cathedral: ratios compare, milliseconds do not",
                     {"size", "here", "TSSAO / SSAO fps, published", "measured, k2 = 16",
                      "measured, k2 = 8", "deferred ms", "SSAO ms", "TSSAO ms, k2 = 16"},
                     {}};
    for (const PublishedRow& row : kPublished) {
        const auto at = [&row](const char* label) {
            return CellAddress{row.part, row.round, label};
        };
        const auto describe_frame = [&](const char* label) {
            std::vector<double> times;
            for (const auto& [repeat, time] : evidence.get_frame_ms(at(label))) {
                times.push_back(time);
            }
            return describe_estimate(estimate_across_repeats(times));
        };
        const RoundRecord& round = evidence.get_round(row.part, row.round);
        table.rows.push_back({row.size, fmt::format("{}x{}", round.width, round.height),
                              format_rounded(row.tssao_fps / row.ssao_fps, 3),
                              describe_estimate(evidence.compare_frames(at(kSsao), at(kTssao16))),
                              describe_estimate(evidence.compare_frames(at(kSsao), at(kTssao8))),
                              describe_frame(kDeferred), describe_frame(kSsao),
                              describe_frame(kTssao16)});
    }
    return table;
}

PaperTable make_figure4() {
    PaperTable table{"figure4",
                     "Figure 4: weight of a new sample, and what is left of an old solution",
                     "equations 5 and 6 with k = 8; the figure plots the limit k << n",
                     {"samples", "weight, 500", "weight, 1000", "weight, 1500", "left, 500",
                      "left, 1000", "left, 1500"},
                     {}};
    constexpr int kStep = 250;
    constexpr int kLast = 5000;
    constexpr double kSamples = 8.0;
    for (int taken = 0; taken <= kLast; taken += kStep) {
        Row row{std::to_string(taken)};
        for (const double cap : {500.0, 1000.0, 1500.0}) {
            row.push_back(format_rounded(1.0 / (std::min<double>(taken, cap) + kSamples), 4));
        }
        for (const double cap : {500.0, 1000.0, 1500.0}) {
            row.push_back(format_rounded(std::pow(cap / (cap + kSamples), taken / kSamples), 4));
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

PaperTable make_figure6(const Evidence& evidence) {
    PaperTable table{
        "figure6",
        "Figure 6: invalidation by speed of rotation",
        "a bunny that turns on a floor, converged start; mean over frames",
        {"degrees a frame", "lost history", "disoccluded", "neighbourhood", "mean convergence"},
        {}};
    constexpr std::array kSpeeds{"0.25", "1", "3", "10"};
    for (std::size_t round = 0; round < kSpeeds.size(); ++round) {
        Row row{kSpeeds.at(round)};
        for (const char* number : {"history_invalidated", "history_disocclusion",
                                   "history_neighbourhood", "history_convergence"}) {
            row.push_back(describe_estimate(
                evidence.estimate_metric({"rotation", round, kTssao}, number, kCold)));
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

PaperTable make_figure8(const Evidence& evidence) {
    PaperTable table{"figure8",
                     "Figure 8: invalidation where a box leaves",
                     "converged start, against ray tracing; mean over frames",
                     {"invalidation", "trail energy", "temporal flicker", "rmse"},
                     {}};
    for (const char* label : {"disocclusion only", "full", "smooth 16", "smooth 32", "smooth 64",
                              "smooth 256", "graded", "SSAO"}) {
        Row row{label};
        for (const char* metric : {"trail_energy", "temporal_flicker", "rmse"}) {
            row.push_back(describe_estimate(
                evidence.estimate_metric({"invalidation", 0, label}, metric, kCold)));
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

PaperTable make_figure9(const Evidence& evidence) {
    PaperTable table{"figure9",
                     "Figure 9: the adaptive filter over a turning object",
                     "against 480 samples of the same estimator; mean over frames",
                     {"filter", "temporal flicker", "rmse"},
                     {}};
    for (const char* label : {"filter off", "filter on", "SSAO"}) {
        table.rows.push_back(
            {label,
             describe_estimate(
                 evidence.estimate_metric({"filter", 0, label}, "temporal_flicker", kCold)),
             describe_estimate(evidence.estimate_metric({"filter", 0, label}, "rmse", kCold))});
    }
    return table;
}

PaperTable make_figure10(const Evidence& evidence) {
    PaperTable table{"figure10",
                     "Figures 1 and 10: still views against 480 samples",
                     "eight views of the cathedral, TSSAO converged; mean over views",
                     {"estimator", "method", "rmse", "ssim"},
                     {}};
    for (const auto& [part, name] :
         {std::pair{"stills", "Fox & Compton"}, {"stills_ritschel", "Ritschel et al."}}) {
        for (const char* label : {"SSAO weak blur", "SSAO strong blur", kTssao, "reference 480"}) {
            table.rows.push_back(
                {name, label,
                 describe_estimate(evidence.estimate_metric({part, 0, label}, "rmse", kConverged)),
                 describe_estimate(
                     evidence.estimate_metric({part, 0, label}, "ssim", kConverged))});
        }
    }
    return table;
}

PaperTable make_figure13(const Evidence& evidence) {
    PaperTable table{"figure13",
                     "Figure 13: cost of AO by frame",
                     "passes and inputs, median over repeats, milliseconds on " +
                         describe_device(evidence.context()),
                     {"frame", "cathedral SSAO", "cathedral TSSAO", "moving SSAO", "moving TSSAO"},
                     {}};
    const std::array columns{
        evidence.get_frame_costs_ms({"table2", kMiddle, kSsao}),
        evidence.get_frame_costs_ms({"table2", kMiddle, kTssao16}),
        evidence.get_frame_costs_ms({"moving", 0, kSsao}),
        evidence.get_frame_costs_ms({"moving", 0, kTssao}),
    };
    for (std::size_t frame = 0; frame < columns.front().size(); ++frame) {
        Row row{std::to_string(frame)};
        for (const std::vector<double>& column : columns) {
            row.push_back(frame < column.size() ? format_rounded(column[frame], 4) : "");
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

} // namespace

std::vector<PaperTable> make_tssao_tables(const Evidence& evidence) {
    return {make_table1(evidence),   make_table2(evidence),  make_figure4(),
            make_figure6(evidence),  make_figure8(evidence), make_figure9(evidence),
            make_figure10(evidence), make_figure13(evidence)};
}

} // namespace alcove
