#include "reports/html/film.hpp"

#include "reports/html/heat_legend.hpp"

#include <algorithm>
#include <iterator>
#include <set>

#include <fmt/core.h>

namespace alcove {
namespace {

/// Frames of the film that the sheet shows.
constexpr int kSheetFrames = 4;

/// Maps of the film's last frame that look back on all of it.
const std::vector<PictureKind>& list_accumulated_kinds() {
    static const std::vector<PictureKind> kKinds = {
        {"flicker_p95", "Flicker, 95th percentile over time", false, "accumulated_flicker_p95"},
        {"profile", "Temporal profile: middle row, time down", false, "accumulated_profile"},
        {"profile_truth", "Temporal profile of the reference", true, "accumulated_profile"},
        {"invalidations", "Share of frames that lost history", false, "accumulated_invalidations"},
        {"all_samples", "Samples, summed over the film", false, "accumulated_samples"},
    };
    return kKinds;
}

std::set<int> choose_sheet_frames(const SegmentRecord& film) {
    std::set<int> frames;
    const int last = film.end - film.begin - 1;
    for (int i = 0; i < kSheetFrames; ++i) {
        frames.insert(film.begin + last * i / (kSheetFrames - 1));
    }
    return frames;
}

/// The front end finds a kind's legend by data-legend.
std::string make_legends(const std::vector<PictureKind>& kinds, int film_frames) {
    std::string items;
    for (const PictureKind& kind : kinds) {
        const std::string legend = make_heat_legend(kind.key, film_frames);
        if (!legend.empty()) {
            items += fmt::format("<li data-legend=\"{}\"><b>{}</b>{}</li>\n", kind.key, kind.title,
                                 legend);
        }
    }
    return "<ul class=\"legends\">\n" + items + "</ul>\n";
}

/// Those of `kinds` that some method has on a frame.
std::vector<PictureKind> list_kept_kinds(const RoundAnalysis& round, const PictureFinder& finder,
                                         int frame, const std::vector<PictureKind>& kinds) {
    const std::vector<const CellAnalysis*> cells = list_pictured_cells(round);
    std::vector<PictureKind> kept;
    std::copy_if(
        kinds.begin(), kinds.end(), std::back_inserter(kept), [&](const PictureKind& kind) {
            return std::any_of(cells.begin(), cells.end(), [&](const CellAnalysis* cell) {
                return finder.find_url(round.round.id, cell->cell.id, frame, kind).has_value();
            });
        });
    return kept;
}

std::string make_accumulated_maps(const RoundAnalysis& round, const PictureFinder& finder) {
    const SegmentRecord& film = round.round.film;
    const std::vector<PictureKind> kinds =
        list_kept_kinds(round, finder, film.end - 1, list_accumulated_kinds());
    if (kinds.empty()) {
        return {};
    }
    return "<h4>Accumulated over the film</h4>\n" + make_legends(kinds, film.end - film.begin) +
           "<div class=\"accumulated\">" +
           make_picture_table(round, finder, film.end - 1, kinds, "&ndash;") + "</div>\n";
}

} // namespace

std::vector<PictureKind> list_film_kinds(const RoundRecord& round) {
    const bool is_picture = measures_pictures(round);
    const char* const file = is_picture ? "film_picture" : "film_visibility";
    return {
        {is_picture ? "picture" : "visibility", is_picture ? "Picture" : "Visibility", false, file},
        {"reference", "Reference", true, file},
        {"error", "Error map", false, "film_error"},
        {"flicker", "Temporal flicker", false, "film_temporal_flicker"},
        {"age", "Age of the history", false, "film_age"},
        {"cause", "Why history was lost", false, "film_cause"},
        {"convergence", "Convergence", false, "film_convergence"},
        {"samples", "Samples a pixel", false, "film_samples"},
        {"missed", "Missed invalidation", false, "film_missed_invalidation"},
        {"false", "False invalidation", false, "film_false_invalidation"},
    };
}

std::string make_film_block(const RoundAnalysis& round, const PictureFinder& finder) {
    const SegmentRecord& film = round.round.film;
    if (film.begin == film.end) {
        return {};
    }
    std::string text = fmt::format("<h4>Film of frames {} to {}</h4>\n", film.begin, film.end - 1);
    std::string sheets;
    std::vector<PictureKind> legends;
    for (const int frame : choose_sheet_frames(film)) {
        const std::vector<PictureKind> kinds =
            list_kept_kinds(round, finder, frame, list_film_kinds(round.round));
        if (kinds.empty()) {
            continue;
        }
        legends = kinds.size() > legends.size() ? kinds : legends;
        // The last frame is open: the first has no flicker yet and no history.
        sheets += fmt::format(
            "<details class=\"sheet\"{}><summary>Film, frame {}</summary>\n{}</details>\n",
            frame + 1 == film.end ? " open" : "", frame,
            make_picture_table(round, finder, frame, kinds, "&ndash;"));
    }
    if (sheets.empty()) {
        return text + "<p class=\"note\">Its pictures were not kept.</p>\n";
    }
    return text + fmt::format("<div class=\"film\" data-film=\"{}\"></div>\n", round.round.id) +
           make_legends(legends, film.end - film.begin) + sheets +
           make_accumulated_maps(round, finder);
}

} // namespace alcove
