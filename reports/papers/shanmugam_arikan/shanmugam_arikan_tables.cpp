#include "reports/papers/shanmugam_arikan/shanmugam_arikan_parts.hpp"

#include "core/base/text.hpp"
#include "reports/analysis/wording.hpp"

namespace alcove {
namespace {

std::string describe_metric(const Evidence& evidence, const CellAddress& cell,
                            const std::string& metric) {
    return describe_estimate(evidence.estimate_metric(cell, metric, SampleState::cold));
}

std::string describe_pass_ms(const Evidence& evidence, const CellAddress& cell, const char* pass) {
    std::vector<double> times;
    for (const auto& [repeat, time] : evidence.get_passes_ms(cell, {pass})) {
        times.push_back(time);
    }
    return describe_estimate(estimate_across_repeats(times));
}

PaperTable make_figure5(const Evidence& evidence) {
    PaperTable table{"figure5",
                     "Figures 1 d and 5 e to h: both parts against long rays",
                     "errors to rays of 4 m (160 units), " +
                         describe_round(evidence, "figure5", kStatue) + "; " +
                         describe_round(evidence, "figure5", kMolecule),
                     {"parts", "rmse", "ssim", "share of pixels too dark by 0.05", "molecule: rmse",
                      "molecule: share too dark"},
                     {}};
    for (const char* label : {"near", "near, random", "far", "combined", "as printed",
                              "multiplicative", "silhouettes", "silhouettes, multiplied"}) {
        const CellAddress statue = find_native("figure5", label, kStatue);
        const CellAddress molecule = find_native("figure5", label, kMolecule);
        table.rows.push_back({label, describe_metric(evidence, statue, "rmse"),
                              describe_metric(evidence, statue, "ssim"),
                              describe_metric(evidence, statue, "false_occlusion:least=0.05"),
                              describe_metric(evidence, molecule, "rmse"),
                              describe_metric(evidence, molecule, "false_occlusion:least=0.05")});
    }
    return table;
}

PaperTable make_rays(const Evidence& evidence) {
    PaperTable table{"rays",
                     "Figure 5 a to d: lengths of rays",
                     describe_round(evidence, "rays") + "; errors to rays of 160 units",
                     {"what", "mean occlusion", "rmse", "ssim", "gmsd"},
                     {}};
    for (const char* label : {"160 units", "40 units", "10 units", "2 units", "near", "combined",
                              "as printed", "multiplicative"}) {
        const bool has_error =
            std::string(label).ends_with(" units") && std::string(label) != "160 units";
        const CellAddress rays = find_native("rays", label);
        const auto describe = [&](const char* metric) {
            return has_error ? describe_metric(evidence, rays, metric) : std::string();
        };
        table.rows.push_back({label,
                              describe_metric(evidence, find_native("occlusion", label), "mae"),
                              describe("rmse"), describe("ssim"), describe("gmsd")});
    }
    return table;
}

PaperTable make_layers(const Evidence& evidence) {
    PaperTable table{
        "layers",
        "Section 4.2: depth layers of the near part",
        "rmse to rays of its reach, 0.125 m: " + describe_round(evidence, "layers", kStatue) +
            "; " + describe_round(evidence, "layers", kFoliage),
        {"layers", "statue", "leaves"},
        {}};
    for (const char* label : {"1 layer", "2 layers", "3 layers", "4 layers", "back faces"}) {
        table.rows.push_back(
            {label, describe_metric(evidence, find_native("layers", label, kStatue), "rmse"),
             describe_metric(evidence, find_native("layers", label, kFoliage), "rmse")});
    }
    return table;
}

PaperTable make_neighbours(const Evidence& evidence) {
    PaperTable table{"neighbours",
                     "Section 4.3: the near part's time",
                     describe_round(evidence, "neighbours") + ", and of reaches " +
                         describe_round(evidence, "r_far"),
                     {"setting", "near pass, ms", "mean occlusion"},
                     {}};
    const auto add = [&](const std::string& title, const CellAddress& cell) {
        table.rows.push_back({title, describe_pass_ms(evidence, cell, kNearPass),
                              describe_metric(evidence, cell, "mae")});
    };
    for (const double count : list_neighbour_counts()) {
        const std::string label = std::to_string(static_cast<int>(count));
        add(label + " neighbours", find_native("neighbours", label));
    }
    for (const char* label : {"1.25 units", "2.5 units", "5 units", "10 units"}) {
        add("r_far " + std::string(label), find_native("r_far", label));
    }
    return table;
}

PaperTable make_fill(const Evidence& evidence) {
    PaperTable table{"fill",
                     "Section 5.3: the far part's time",
                     describe_round(evidence, "fill", kUncut) + "; " +
                         describe_round(evidence, "fill", kCut) +
                         "; area of a billboard from equation (5), in pi r^2; 6000 spheres unless "
                         "told otherwise, epsilon 0.1 with fewer",
                     {"setting", "area", "molecule: far pass, ms", "spheres, ms", "mean occlusion",
                      "statue: far pass, ms", "spheres, ms", "mean occlusion"},
                     {}};
    const auto add = [&](const std::string& label, const std::string& area) {
        std::vector<std::string> row{label, area};
        for (const std::size_t round : {kUncut, kCut}) {
            const CellAddress cell = find_native("fill", label, round);
            row.push_back(describe_pass_ms(evidence, cell, kFarPass));
            row.push_back(describe_pass_ms(evidence, cell, kSpheresPass));
            row.push_back(describe_metric(evidence, cell, "mae"));
        }
        table.rows.push_back(row);
    };
    for (const FillStep& step : list_fill_steps()) {
        add(step.label, format_rounded(step.get_area(), 3));
    }
    add("1000 spheres", "");
    add("3000 spheres", "");
    return table;
}

PaperTable make_shares(const Evidence& evidence) {
    PaperTable table{"shares",
                     "Figure 5 and section 5.3: six thousand spheres in a frame",
                     describe_round(evidence, "shares") + " on " +
                         describe_device(evidence.context()) +
                         "; the paper prints 36 fps for the image-space part, 34 for both, and, "
                         "maybe of another scene, more than 80 for 6000 spheres alone",
                     {"parts", "frame, ms", "frame / near's", "cost / near's"},
                     {}};
    const CellAddress near = find_native("shares", "near");
    for (const char* label : {"near", "as printed", "as printed, far", "combined", "far"}) {
        const CellAddress cell = find_native("shares", label);
        std::vector<double> times;
        for (const auto& [repeat, time] : evidence.get_frame_ms(cell)) {
            times.push_back(time);
        }
        table.rows.push_back({label, describe_estimate(estimate_across_repeats(times)),
                              describe_estimate(evidence.compare_frames(cell, near)),
                              describe_estimate(evidence.compare_costs(cell, near))});
    }
    return table;
}

PaperTable make_closed_room(const Evidence& evidence) {
    PaperTable table{"closed_room",
                     "Section 5.3: a closed room",
                     describe_round(evidence, "closed_room"),
                     {"parts", "mean occlusion", "share of pixels with visibility below 0.01"},
                     {}};
    for (const char* label : {"endless rays", "near", "combined", "epsilon 0.5", "epsilon 0.005",
                              "as printed", "multiplicative"}) {
        const CellAddress cell = find_native("closed_room", label);
        table.rows.push_back({label, describe_metric(evidence, cell, "mae"),
                              describe_metric(evidence, cell, "false_occlusion:least=0.99")});
    }
    return table;
}

} // namespace

std::vector<PaperTable> make_shanmugam_arikan_tables(const Evidence& evidence) {
    return {make_figure5(evidence),    make_rays(evidence), make_layers(evidence),
            make_neighbours(evidence), make_fill(evidence), make_shares(evidence),
            make_closed_room(evidence)};
}

} // namespace alcove
