#include "reports/papers/ssdo/ssdo_parts.hpp"

namespace alcove {
namespace {

/// Pictures of some cells of a part, in one of its views; "reference" is what they are measured
/// against.
PaperFigure make_figure(const Evidence& evidence, const std::string& title, const std::string& part,
                        std::size_t round, const std::string& picture,
                        const std::vector<std::string>& labels, std::size_t view) {
    const RoundRecord& record = evidence.get_round(part, round);
    PaperFigure figure{title, picture + "; one of the views of " + record.scene, {}};
    const int frame = record.image_frames.at(view);
    for (const std::string& label : labels) {
        figure.pictures.push_back(
            make_cell_picture(evidence, {part, round, label}, frame, picture, label));
    }
    return figure;
}

} // namespace

std::vector<PaperFigure> make_ssdo_figures(const Evidence& evidence) {
    const std::vector<std::string> order{"nothing", "SSAO", "SSDO", "bounce"};
    std::vector<PaperFigure> figures{
        make_figure(evidence, "Figure 3: colours of shadows, and a yellow bounce", "fig3", 0,
                    "picture", order, 2),
        make_figure(evidence, "Figure 3: errors to path tracing", "fig3", 0, "error", order, 2),
        make_figure(evidence, "Figure 7: a hidden column", "fig7", 0, "picture",
                    {"one view", "four cameras", "two layers"}, 2),
        make_figure(evidence, "Figure 7: errors to path tracing", "fig7", 0, "error",
                    {"one view", "four cameras", "two layers"}, 2),
        make_figure(evidence, "Figure 6: a point light's shadow", "fig6", 0, "picture",
                    {"1 layer, 0.25 m", "1 layer, 1 m", "2 layers, 0.25 m", "2 layers, 1 m"}, 2),
        make_figure(evidence, "Figure 9: pebbles", "fig9", 0, "picture",
                    {"no bias", "bias", "corrected, 16 samples", "corrected, 2 layers, 8 samples"},
                    2),
        make_figure(evidence, "Figure 10: natural illumination", "fig10", 0, "picture",
                    {"bias", "corrected"}, 1),
        make_figure(evidence, "Figure 12: instant radiosity and a near bounce", "fig12", 0,
                    "picture", {"nothing", "clamped", "clamped part", "added"}, 1)};
    for (std::size_t scene = 0; scene < kFig13Scenes; ++scene) {
        const std::size_t round = find_fig13_round(scene, Reach::full);
        const std::string name = name_scene(evidence, "fig13", round);
        figures.push_back(
            make_figure(evidence, "Figure 13: " + name, "fig13", round, "picture", order, 2));
        figures.push_back(make_figure(evidence, "Figure 13, errors to path tracing: " + name,
                                      "fig13", round, "error", order, 2));
    }
    PaperFigure turning{"Figure 4: a yellow side that turns away", "picture, with a bounce", {}};
    for (const int frame : evidence.get_round("fig4", 0).image_frames) {
        turning.pictures.push_back(make_cell_picture(evidence, {"fig4", 0, "bounce"}, frame,
                                                     "picture", "frame " + std::to_string(frame)));
    }
    figures.push_back(turning);
    PaperFigure radius{"Figure 14: r_max doubles", "picture, with a bounce in the reference", {}};
    for (std::size_t round = 0; round < 4; ++round) {
        const RoundRecord& record = evidence.get_round("fig14_shadow", round);
        const CellAddress cell{"fig14_shadow", round, "SSDO"};
        radius.pictures.push_back(
            make_cell_picture(evidence, cell, record.image_frames.front(), "visibility",
                              "r_max " + evidence.find_parameter(cell, "radius") + " m"));
    }
    figures.push_back(radius);
    return figures;
}

} // namespace alcove
