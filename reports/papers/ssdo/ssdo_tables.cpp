#include "core/base/text.hpp"
#include "reports/analysis/wording.hpp"
#include "reports/papers/ssdo/ssdo_parts.hpp"

#include <cmath>
#include <string_view>

namespace alcove {
namespace {

constexpr auto kCold = SampleState::cold;

std::string describe_value(const Evidence& evidence, const CellAddress& cell,
                           const std::string& metric) {
    return describe_estimate(evidence.estimate_metric(cell, metric, kCold));
}

std::string describe_frame_ms(const Evidence& evidence, const CellAddress& cell) {
    std::vector<double> times;
    for (const auto& [repeat, time] : evidence.get_frame_ms(cell)) {
        times.push_back(time);
    }
    return describe_estimate(estimate_across_repeats(times));
}

/// Time of a's frame - b's, in percent of b's.
std::string describe_overhead(const Estimate& ratio) {
    Estimate more = ratio;
    more.value = 100.0 * (ratio.value - 1.0);
    more.minimum = 100.0 * (ratio.minimum - 1.0);
    more.maximum = 100.0 * (ratio.maximum - 1.0);
    if (ratio.interval) {
        more.interval =
            Interval{100.0 * (ratio.interval->lower - 1.0), 100.0 * (ratio.interval->upper - 1.0)};
    }
    return describe_estimate(more);
}

/// What is printed for `what` in the row of a round, if it is; 1280x960 has no row.
const SsdoRow* find_row(std::size_t round, int samples) {
    for (const SsdoRow& row : list_ssdo_rows()) {
        if (row.round == round && row.samples == samples) {
            return &row;
        }
    }
    return nullptr;
}

std::string describe_printed(const SsdoRow* row, std::string_view what) {
    if (row == nullptr) {
        return "not in print";
    }
    if (what == "SSAO") {
        return format_rounded(row->ssao_fps, 3) + " fps";
    }
    const double fps = what == "SSDO" ? row->ssdo_fps : row->bounce_fps;
    const double loss = what == "SSDO" ? row->ssdo_loss : row->bounce_loss;
    const double recomputed = 100.0 * (1.0 - fps / row->ssao_fps);
    const std::string text =
        format_rounded(fps, 3) + " fps, " + format_rounded(loss, 3) + " % as printed";
    // Frame rates have one decimal: half a unit in the last place of both is 0.5 % at most.
    return std::abs(recomputed - loss) < 0.51
               ? text
               : text + " (" + format_rounded(recomputed, 3) + " % by the frame rates)";
}

std::string describe_printed_time(const SsdoRow* row, std::string_view what) {
    if (row == nullptr || what == "SSAO") {
        return "";
    }
    const double fps = what == "SSDO" ? row->ssdo_fps : row->bounce_fps;
    return format_rounded(100.0 * (row->ssao_fps / fps - 1.0), 3);
}

/// The same without the frame that has no occlusion, 124 fps, which is printed of the largest
/// size alone.
std::string describe_printed_passes(const SsdoRow* row, std::string_view what) {
    if (row == nullptr || what == "SSAO" || std::string_view(row->size) != "1600x1200") {
        return "";
    }
    const double fps = what == "SSDO" ? row->ssdo_fps : row->bounce_fps;
    const double empty = 1.0 / 124.0;
    const double ratio = (1.0 / fps - empty) / (1.0 / row->ssao_fps - empty);
    return format_rounded(100.0 * (ratio - 1.0), 3);
}

PaperTable make_table1(const Evidence& evidence) {
    PaperTable table{
        "table1",
        "Table 1: frames and passes",
        "published on a GeForce 8800 GTX, measured here on " + describe_device(evidence.context()) +
            " at sizes in the same proportion. Loss: of SSAO's frames a second, which "
            "is what the paper's percentages are; time: of its frame's time; passes: "
            "without the frame that has no occlusion",
        {"size", "samples", "what", "published", "time %, published", "passes %, published",
         "size here", "frame, ms", "loss %", "time %", "passes %"},
        {}};
    for (std::size_t round = 0; round < list_ssdo_sizes().size(); ++round) {
        const RoundRecord& record = evidence.get_round("table1", round);
        const std::string here = std::to_string(record.width) + "x" + std::to_string(record.height);
        const std::string size = list_ssdo_sizes()[round];
        table.rows.push_back({size, "", "no occlusion", round == 3 ? "124 fps" : "", "", "", here,
                              describe_frame_ms(evidence, {"table1", round, "nothing"}), "", "",
                              ""});
        for (const int samples : {8, 16}) {
            const SsdoRow* row = find_row(round, samples);
            const CellAddress ssao = find_table1_cell(round, "SSAO", samples);
            for (const char* what : {"SSAO", "SSDO", "bounce"}) {
                const CellAddress cell = find_table1_cell(round, what, samples);
                const bool is_base = std::string_view(what) == "SSAO";
                table.rows.push_back(
                    {size, std::to_string(samples), what, describe_printed(row, what),
                     describe_printed_time(row, what), describe_printed_passes(row, what), here,
                     describe_frame_ms(evidence, cell),
                     is_base
                         ? ""
                         : describe_estimate(estimate_frame_loss(evidence, round, what, samples)),
                     is_base ? "" : describe_overhead(evidence.compare_frames(cell, ssao)),
                     is_base ? "" : describe_overhead(evidence.compare_costs(cell, ssao))});
            }
        }
    }
    return table;
}

/// What a direction for the light costs beside the same test of the same samples.
PaperTable make_direct_pass(const Evidence& evidence) {
    const std::string occlusion = "ssao_environment/occlusion";
    const std::string direct = "ssdo/direct";
    PaperTable table{
        "direct_pass",
        "The direct pass beside ambient occlusion's",
        describe_round(evidence, "table1") +
            ", at each size; time and fetches from textures of the pass that takes the samples, "
            "without a bounce; fetches are counted, and are the same on every device",
        {"size here", "samples", "time: SSDO / SSAO", "fetches a pixel: SSAO", "SSDO",
         "fetches: SSDO / SSAO"},
        {}};
    for (std::size_t round = 0; round < list_ssdo_sizes().size(); ++round) {
        const RoundRecord& record = evidence.get_round("table1", round);
        for (const int samples : {8, 16}) {
            const CellAddress ssao = find_table1_cell(round, "SSAO", samples);
            const CellAddress ssdo = find_table1_cell(round, "SSDO", samples);
            const auto of_ssao = evidence.find_fetches(ssao, occlusion);
            const auto of_ssdo = evidence.find_fetches(ssdo, direct);
            const auto show = [](const std::optional<double>& fetches) {
                return fetches ? format_rounded(*fetches, 4) : std::string();
            };
            table.rows.push_back(
                {std::to_string(record.width) + "x" + std::to_string(record.height),
                 std::to_string(samples),
                 describe_estimate(evidence.compare_passes(ssdo, {direct}, ssao, {occlusion})),
                 show(of_ssao), show(of_ssdo),
                 of_ssao && of_ssdo ? format_rounded(*of_ssdo / *of_ssao, 3) : std::string()});
        }
    }
    return table;
}

PaperTable make_figure4(const Evidence& evidence) {
    PaperTable table{"figure4",
                     "Figure 4: a yellow side that turns away",
                     describe_round(evidence, "fig4") +
                         "; chroma_error on the floor between SSDO with and without a bounce. At "
                         "the end the panel's other side comes into view",
                     {"frame", "one view", "four further cameras"},
                     {}};
    const auto get = [&](const char* label) {
        return evidence.get_values({"fig4", 0, label}, "chroma_error[floor]", kCold);
    };
    const std::vector<double> one = get("bounce");
    const std::vector<double> four = get("four cameras");
    const std::vector<SegmentRecord>& segments = evidence.get_round("fig4", 0).segments;
    for (std::size_t i = 0; i < one.size(); ++i) {
        table.rows.push_back({std::to_string(segments[i].begin), format_rounded(one[i], 3),
                              format_rounded(four[i], 3)});
    }
    return table;
}

PaperTable make_figure5(const Evidence& evidence) {
    PaperTable table{
        "figure5",
        "Figure 5: layers and samples",
        "rmse and share of pixels too dark by 0.05, against rays of the same reach and "
        "falloff: " +
            describe_round(evidence, "fig5", 0) +
            " and of three more scenes; two layers where it says one set",
        {"what"},
        {}};
    constexpr std::size_t kScenes = 4;
    for (std::size_t round = 0; round < kScenes; ++round) {
        const std::string scene = name_scene(evidence, "fig5", round);
        table.columns.push_back(scene + ": rmse");
        table.columns.push_back(scene + ": too dark");
    }
    for (const char* label : {"1 layer", "4 samples, 1 set", "16 samples, 1 set",
                              "64 samples, 1 set", "2 layers", "4 layers", "4 layers, 4 cameras"}) {
        std::vector<std::string> row{label};
        for (std::size_t round = 0; round < kScenes; ++round) {
            const CellAddress cell{"fig5", round, label};
            row.push_back(describe_value(evidence, cell, "rmse"));
            row.push_back(describe_value(evidence, cell, "false_occlusion:least=0.05"));
        }
        table.rows.push_back(row);
    }
    return table;
}

PaperTable make_figure7(const Evidence& evidence) {
    PaperTable table{"figure7",
                     "Figure 7: one view and five",
                     describe_round(evidence, "fig7") +
                         ", against path tracing; the paper prints 49.2 and 31.5 fps, 56.2 % of "
                         "time, and 160 % on a million triangles: " +
                         describe_round(evidence, "fig7_large"),
                     {"what", "frame / one view's", "rmse", "chroma_error", "wall: rmse",
                      "wall: chroma_error", "floor: rmse", "large scene: frame / one view's"},
                     {}};
    for (const char* label : {"nothing", "SSAO", "direct, one view", "one view",
                              "direct, four cameras", "four cameras", "two layers"}) {
        const CellAddress cell{"fig7", 0, label};
        const std::string_view name = label;
        const bool is_large = name == "one view" || name == "four cameras" || name == "two layers";
        std::vector<std::string> row{
            label, describe_estimate(evidence.compare_frames(cell, {"fig7", 0, "one view"}))};
        for (const char* metric :
             {"rmse", "chroma_error", "rmse[wall]", "chroma_error[wall]", "rmse[floor]"}) {
            row.push_back(describe_value(evidence, cell, metric));
        }
        row.push_back(is_large ? describe_estimate(evidence.compare_frames(
                                     {"fig7_large", 0, label}, {"fig7_large", 0, "one view"}))
                               : "");
        table.rows.push_back(row);
    }
    return table;
}

/// Parts of the frame in which `a`'s rmse is above `b`'s, in words; those that every scene has.
std::string list_exceptions(const Evidence& evidence, std::size_t round, const char* a,
                            const char* b) {
    std::string parts;
    for (const char* stratum : {"depth_edges", "creases", "angle_60_90", "dark"}) {
        const std::string metric = std::string("rmse[") + stratum + "]";
        const CellAddress of_a{"fig13", round, a};
        const CellAddress of_b{"fig13", round, b};
        const std::size_t n = evidence.get_values(of_a, metric, kCold).size();
        if (n == 0 || n != evidence.get_values(of_b, metric, kCold).size()) {
            continue;
        }
        const Estimate difference = evidence.compare_metric(of_a, of_b, metric, kCold);
        if (judge_above(difference, 0.0) == Outcome::holds) {
            parts += (parts.empty() ? "" : ", ") + std::string(stratum) + " +" +
                     format_rounded(difference.value, 2);
        }
    }
    return parts;
}

PaperTable make_figure13(const Evidence& evidence) {
    PaperTable table{
        "figure13",
        "Figure 13: against one-bounce path tracing",
        "rmse of pictures, six views of each scene at " +
            std::to_string(evidence.get_round("fig13", 0).width) + "x" +
            std::to_string(evidence.get_round("fig13", 0).height) +
            "; near: what lies within the radius, full: all there is, as in the "
            "paper. Differences say whether the first is better; SSAO, cosine: with SSDO's "
            "weights",
        {"scene", "reach", "nothing", "SSAO", "SSAO, cosine", "SSDO", "bounce", "SSAO - nothing",
         "SSDO - SSAO", "SSDO - SSAO, cosine", "bounce - SSDO", "colour: SSDO - SSAO"},
        {}};
    for (std::size_t scene = 0; scene < kFig13Scenes; ++scene) {
        for (const auto& [reach, name] :
             {std::pair{Reach::near, "near"}, std::pair{Reach::full, "full"}}) {
            const std::size_t round = find_fig13_round(scene, reach);
            std::vector<std::string> row{name_scene(evidence, "fig13", round), name};
            for (const char* label : {"nothing", "SSAO", "SSAO, cosine", "SSDO", "bounce"}) {
                row.push_back(describe_value(evidence, {"fig13", round, label}, "rmse"));
            }
            const auto add = [&](const char* a, const char* b, const char* metric) {
                const Estimate difference = compare_values(evidence, "fig13", round, a, b, metric);
                row.push_back(describe_estimate(difference) + ": " +
                              std::string(to_text(judge_below(difference, 0.0))));
            };
            add("SSAO", "nothing", "rmse");
            add("SSDO", "SSAO", "rmse");
            add("SSDO", "SSAO, cosine", "rmse");
            add("bounce", "SSDO", "rmse");
            add("SSDO", "SSAO", "chroma_error");
            table.rows.push_back(row);
        }
    }
    return table;
}

/// Where the order of figure 13 is broken.
PaperTable make_figure13_regions(const Evidence& evidence) {
    PaperTable table{"figure13_regions",
                     "Figure 13: where the order is broken",
                     "parts of the frame in which the first has more rmse than the second beyond "
                     "the 95 % interval over six views, and by how much: depth edges, creases, "
                     "surfaces seen at 60 degrees and more, dark values of the reference",
                     {"scene", "reach", "SSAO worse than nothing", "SSDO worse than SSAO",
                      "bounce worse than SSDO"},
                     {}};
    for (std::size_t scene = 0; scene < kFig13Scenes; ++scene) {
        for (const auto& [reach, name] :
             {std::pair{Reach::near, "near"}, std::pair{Reach::full, "full"}}) {
            const std::size_t round = find_fig13_round(scene, reach);
            table.rows.push_back({name_scene(evidence, "fig13", round), name,
                                  list_exceptions(evidence, round, "SSAO", "nothing"),
                                  list_exceptions(evidence, round, "SSDO", "SSAO"),
                                  list_exceptions(evidence, round, "bounce", "SSDO")});
        }
    }
    return table;
}

PaperTable make_figure14(const Evidence& evidence) {
    PaperTable table{"figure14",
                     "Figure 14: r_max",
                     describe_round(evidence, "fig14_shadow") +
                         "; shares of pixels that lose 0.05 of their visibility, and that a bounce "
                         "brightens by 0.01; false darkness of one and of two layers against rays",
                     {"r_max", "in shadow", "in bounced light"},
                     {}};
    for (std::size_t round = 0; round < 4; ++round) {
        table.rows.push_back(
            {evidence.find_parameter({"fig14_shadow", round, "SSDO"}, "radius"),
             describe_value(evidence, {"fig14_shadow", round, "SSDO"},
                            "false_occlusion:least=0.05"),
             describe_value(evidence, {"fig14_bounce", round, "SSDO"}, "false_occlusion")});
    }
    return table;
}

PaperTable make_silhouettes(const Evidence& evidence) {
    PaperTable table{"silhouettes",
                     "Section 7.2: edges that darken what is behind them",
                     "shares of pixels that are darker by 0.05 than rays of the same reach and "
                     "falloff find; 64 samples, six views",
                     {"scene", "r_max", "one layer", "two layers"},
                     {}};
    for (std::size_t round = 0; round < 8; ++round) {
        const CellAddress one{"silhouettes", round, "1 layer"};
        table.rows.push_back({name_scene(evidence, "silhouettes", round),
                              evidence.find_parameter(one, "radius"),
                              describe_value(evidence, one, "false_occlusion:least=0.05"),
                              describe_value(evidence, {"silhouettes", round, "2 layers"},
                                             "false_occlusion:least=0.05")});
    }
    return table;
}

PaperTable make_figure9(const Evidence& evidence) {
    PaperTable table{
        "figure9",
        "Figure 9: a shadow map's bias and its correction",
        describe_round(evidence, "fig9") +
            ", a map of 256 texels, against one of 4096; false shadows: pixels too "
            "dark by 0.05",
        {"what", "frame / bias's, published", "frame / bias's", "rmse", "false shadows"},
        {}};
    // 218, 103 and 73 frames a second in print.
    for (const auto& [label, published] : {std::pair{"no bias", ""}, std::pair{"bias", "1"},
                                           std::pair{"corrected, 16 samples", "2.12"},
                                           std::pair{"corrected, 2 layers, 8 samples", "2.99"}}) {
        const CellAddress cell{"fig9", 0, label};
        table.rows.push_back({label, published,
                              describe_estimate(evidence.compare_frames(cell, {"fig9", 0, "bias"})),
                              describe_value(evidence, cell, "rmse"),
                              describe_value(evidence, cell, "false_occlusion:least=0.05")});
    }
    return table;
}

} // namespace

std::vector<PaperTable> make_ssdo_tables(const Evidence& evidence) {
    return {make_table1(evidence),     make_direct_pass(evidence),      make_figure4(evidence),
            make_figure5(evidence),    make_figure7(evidence),          make_figure9(evidence),
            make_figure13(evidence),   make_figure13_regions(evidence), make_figure14(evidence),
            make_silhouettes(evidence)};
}

} // namespace alcove
