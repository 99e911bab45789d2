#include "reports/papers/statvo/statvo_parts.hpp"

namespace alcove {
namespace {

/// Visibility of some cells of a part, in one of its views.
PaperFigure make_figure(const Evidence& evidence, const std::string& title, const std::string& part,
                        const std::vector<std::string>& labels, std::size_t view) {
    const RoundRecord& round = evidence.get_round(part, 0);
    PaperFigure figure{title, "visibility; one of the views of " + round.scene, {}};
    const int frame = round.image_frames.at(view);
    for (const std::string& label : labels) {
        const std::string path = RunFolder::make_image_path(
            round.id, evidence.get_cell({part, 0, label}).id, frame, "visibility");
        figure.pictures.push_back({label, "parts/" + part + "/" + path});
    }
    return figure;
}

} // namespace

std::vector<PaperFigure> make_statvo_figures(const Evidence& evidence) {
    constexpr std::size_t kView = 3;
    return {make_figure(evidence, "Figure 6: layers", "layers",
                        {"1 layer", "64 uniform", "4 adaptive"}, kView),
            make_figure(evidence, "Figures 8 and 9: regions and sizes of tables", "reference",
                        {"four regions", "full", "half", "quarter"}, kView),
            make_figure(evidence, "Figure 13: against volumetric obscurance", "reference",
                        {"256 points", "full"}, kView),
            make_figure(evidence, "Figures 11, 12, 14 and 15: other methods", "rivals",
                        {"statvo", "11 lines", "12 lines", "17 points", "16 points", "SAO"}, kView),
            make_figure(evidence, "Section 9: a row of pillars", "pillars",
                        {"1 layer", "4 layers", "8 layers", "4 layers peeled"}, kView)};
}

} // namespace alcove
