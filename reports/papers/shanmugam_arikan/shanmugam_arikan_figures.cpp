#include "reports/papers/shanmugam_arikan/shanmugam_arikan_parts.hpp"

namespace alcove {
namespace {

/// Pictures of some cells of a part, in one of its views.
PaperFigure make_figure(const Evidence& evidence, const std::string& title, const std::string& part,
                        std::size_t round, const std::string& picture,
                        const std::vector<std::string>& labels, std::size_t view) {
    const RoundRecord& record = evidence.get_round(part, round);
    PaperFigure figure{title, picture + "; one of the views of " + record.scene, {}};
    const int frame = record.image_frames.at(view);
    for (const std::string& label : labels) {
        figure.pictures.push_back(
            make_cell_picture(evidence, find_native(part, label, round), frame, picture, label));
    }
    return figure;
}

} // namespace

std::vector<PaperFigure> make_shanmugam_arikan_figures(const Evidence& evidence) {
    const std::vector<std::string> rays{"160 units", "40 units", "10 units", "2 units"};
    const std::vector<std::string> parts{"near",           "far",        "combined", "as printed",
                                         "multiplicative", "silhouettes"};
    return {make_figure(evidence, "Figure 5 a to d: lengths of rays", "occlusion", 0, "visibility",
                        rays, 0),
            make_figure(evidence, "Figure 5 e and g: both parts", "figure5", kStatue, "visibility",
                        parts, 0),
            make_figure(evidence, "Figure 5 f and h: errors to 160 units", "figure5", kStatue,
                        "error", parts, 0),
            make_figure(evidence, "Figure 5, nearer", "figure5", kStatue, "visibility", parts, 7),
            make_figure(evidence, "Figure 1 d: a molecule", "figure5", kMolecule, "visibility",
                        parts, 0),
            make_figure(evidence, "Section 5.3: a closed room", "closed_room", 0, "visibility",
                        {"near", "combined", "epsilon 0.5", "epsilon 0.005", "as printed",
                         "multiplicative"},
                        0)};
}

} // namespace alcove
