#include "reports/html/pictures.hpp"

#include "reports/html/escape.hpp"

#include <fmt/core.h>

namespace alcove {

namespace fs = std::filesystem;

const std::vector<PictureKind>& list_picture_kinds(const RoundRecord& round) {
    static const std::vector<PictureKind> kPictureKinds = {
        {"method", "Picture", false, "picture"},
        {"reference", "Reference", true, "picture"},
        {"error", "Error map", false, "error"},
    };
    static const std::vector<PictureKind> kVisibilityKinds = {
        {"method", "Visibility", false, "visibility"},
        {"reference", "Reference", true, "visibility"},
        {"error", "Error map", false, "error"},
        {"shaded", "Shaded", false, "shaded"},
        {"shaded_reference", "Shaded reference", true, "shaded"},
    };
    return measures_pictures(round) ? kPictureKinds : kVisibilityKinds;
}

PictureFinder::PictureFinder(fs::path run, const fs::path& page_folder) : m_run(std::move(run)) {
    const fs::path relative = fs::absolute(m_run).lexically_normal().lexically_relative(
        fs::absolute(page_folder).lexically_normal());
    m_prefix = escape_url_path(relative.generic_string());
    if (!m_prefix.ends_with('/')) {
        m_prefix += '/';
    }
}

std::string PictureFinder::make_url(const std::string& path) const {
    return m_prefix + escape_url_path(path);
}

std::optional<std::string> PictureFinder::find_url(const std::string& round,
                                                   const std::string& cell, int frame,
                                                   const PictureKind& kind) const {
    const std::string path = RunFolder::make_image_path(
        round, kind.is_of_reference ? "reference" : cell, frame, kind.file_picture);
    if (!fs::is_regular_file(m_run / path)) {
        return std::nullopt;
    }
    return make_url(path);
}

std::vector<const CellAnalysis*> list_pictured_cells(const RoundAnalysis& round) {
    std::vector<const CellAnalysis*> cells;
    for (const CellAnalysis& cell : round.cells) {
        if (cell.cell.role == CellRole::method) {
            cells.push_back(&cell);
        }
    }
    return cells;
}

std::string make_picture_table(const RoundAnalysis& round, const PictureFinder& finder, int frame,
                               const std::vector<PictureKind>& kinds, const char* absent) {
    std::string text = "<div class=\"scroll\"><table class=\"pictures\"><thead><tr><th "
                       "class=\"name\">Method</th>";
    for (const PictureKind& kind : kinds) {
        text += fmt::format("<th>{}</th>", kind.title);
    }
    text += "</tr></thead><tbody>\n";
    for (const CellAnalysis* cell : list_pictured_cells(round)) {
        const std::string label = escape_html(cell->cell.label);
        text += fmt::format("<tr><th scope=\"row\" class=\"name\">{}</th>", label);
        for (const PictureKind& kind : kinds) {
            const auto url = finder.find_url(round.round.id, cell->cell.id, frame, kind);
            text += url ? fmt::format(
                              "<td><a href=\"{0}\"><img src=\"{0}\" alt=\"{1}, {2}, frame "
                              "{3}\" width=\"{4}\" height=\"{5}\" loading=\"lazy\"></a></td>",
                              *url, label, kind.title, frame, round.round.width, round.round.height)
                        : fmt::format("<td class=\"absent\">{}</td>", absent);
        }
        text += "</tr>\n";
    }
    return text + "</tbody></table></div>";
}

std::string make_picture_sheet(const RoundAnalysis& round, const PictureFinder& finder) {
    std::string text;
    for (const int frame : round.round.image_frames) {
        text += fmt::format(
            "<details class=\"sheet\"{}><summary>All pictures of frame "
            "{}</summary>\n{}</details>\n",
            frame == round.round.image_frames.front() ? " open" : "", frame,
            make_picture_table(round, finder, frame, list_picture_kinds(round.round), "not kept"));
    }
    return text;
}

} // namespace alcove
