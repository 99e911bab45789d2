#include "reports/papers/findings.hpp"
#include "reports/papers/tssao/tssao_parts.hpp"

namespace alcove {
namespace {

PaperFigure make_figure6(const Evidence& evidence) {
    PaperFigure figure{"Figure 6: frames since a pixel lost its history",
                       "a bunny that turns; red is just now, black 32 frames ago, white converged",
                       {}};
    const char* const kSpeeds[] = {"0.25 degrees a frame", "1 degree", "3 degrees", "10 degrees"};
    for (std::size_t round = 0; round < std::size(kSpeeds); ++round) {
        const RoundRecord& record = evidence.get_round("rotation", round);
        figure.pictures.push_back(make_cell_picture(evidence, {"rotation", round, kTssao},
                                                    record.film.end - 1, "film_age",
                                                    kSpeeds[round]));
    }
    return figure;
}

PaperFigure make_film_figure(const Evidence& evidence, const std::string& title,
                             const std::string& note, const std::string& part,
                             const std::vector<std::string>& labels, int frames_before_end) {
    PaperFigure figure{title, note, {}};
    const int frame = evidence.get_round(part, 0).film.end - frames_before_end;
    for (const std::string& label : labels) {
        figure.pictures.push_back(
            make_cell_picture(evidence, {part, 0, label}, frame, "film_visibility", label));
    }
    return figure;
}

PaperFigure make_still_figure(const Evidence& evidence, const std::string& title,
                              const std::string& part, const std::vector<std::string>& labels) {
    PaperFigure figure{title, "visibility; one of eight views of the cathedral", {}};
    constexpr std::size_t kView = 3;
    const int frame = evidence.get_round(part, 0).image_frames.at(kView);
    for (const std::string& label : labels) {
        figure.pictures.push_back(
            make_cell_picture(evidence, {part, 0, label}, frame, "visibility", label));
    }
    return figure;
}

} // namespace

std::vector<PaperFigure> make_tssao_figures(const Evidence& evidence) {
    const std::vector<std::string> stills{"SSAO weak blur", "SSAO strong blur", kTssao,
                                          "reference 480"};
    // A third of a second after the box has left.
    constexpr int kAfterLift = 28;
    return {make_figure6(evidence),
            make_film_figure(evidence, "Figure 8: invalidation where a box leaves", "visibility",
                             "invalidation",
                             {"disocclusion only", "full", "smooth 32", "smooth 64"}, kAfterLift),
            make_film_figure(evidence, "Figure 9: the adaptive filter", "visibility", "filter",
                             {"filter off", "filter on", kSsao}, 1),
            make_still_figure(evidence, "Figure 10: Fox and Compton", "stills", stills),
            make_still_figure(evidence, "Figure 10: Ritschel et al.", "stills_ritschel", stills),
            make_still_figure(evidence, "Figure 12: both estimators", "ray_traced",
                              {"TSSAO Ritschel", "TSSAO Fox & Compton"})};
}

} // namespace alcove
