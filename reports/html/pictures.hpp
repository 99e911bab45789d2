#pragma once
// Pictures of the chosen frames: which were kept, and the sheet that shows them all without
// JavaScript.

#include "reports/analysis/analysis.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace alcove {

/// One kind of picture of the viewer, the film and their sheets.
struct PictureKind {
    const char* key; ///< what the front end calls it
    const char* title;
    bool is_of_reference;     ///< in the reference's folder instead of the cell's
    const char* file_picture; ///< the name in the file
};

/// Of a round of visibility, or of radiance.
[[nodiscard]] const std::vector<PictureKind>& list_picture_kinds(const RoundRecord& round);

/// Finds pictures of one run as seen from one page.
class PictureFinder {
  public:
    /// `page_folder` is where index.html will stand.
    PictureFinder(std::filesystem::path run, const std::filesystem::path& page_folder);

    /// The URL of a picture relative to the page; nothing if it was not kept.
    [[nodiscard]] std::optional<std::string> find_url(const std::string& round,
                                                      const std::string& cell, int frame,
                                                      const PictureKind& kind) const;
    /// The URL of a file of the run folder relative to the page, whether it is there or not.
    [[nodiscard]] std::string make_url(const std::string& path) const;

  private:
    std::filesystem::path m_run;
    std::string m_prefix;
};

/// Methods that have pictures: everything but the anchors.
[[nodiscard]] std::vector<const CellAnalysis*> list_pictured_cells(const RoundAnalysis& round);

/// A table of one frame's pictures: a row a method, a column a kind; `absent` stands where there is
/// no picture.
[[nodiscard]] std::string make_picture_table(const RoundAnalysis& round,
                                             const PictureFinder& finder, int frame,
                                             const std::vector<PictureKind>& kinds,
                                             const char* absent);

/// Markup of the sheet: a folding block a frame, a row a method.
[[nodiscard]] std::string make_picture_sheet(const RoundAnalysis& round,
                                             const PictureFinder& finder);

} // namespace alcove
