#include "harness/app/kept_pictures.hpp"

#include "core/base/file.hpp"

#include <numeric>

namespace alcove {
namespace {

namespace fs = std::filesystem;

void add_frames(const RunFolder& run, const RoundRecord& round, const CellRecord& cell,
                const std::string& picture, const std::vector<int>& frames, KeptPictures& kept) {
    for (const int frame : frames) {
        const auto find = [&](const std::string& who) {
            return resolve_inside(run.path(),
                                  RunFolder::make_image_path(round.id, who, frame, picture));
        };
        KeptPicture entry{round.id, round.scene, cell.id,       cell.label,
                          frame,    picture,     find(cell.id), find("reference")};
        if (fs::is_regular_file(entry.test) && fs::is_regular_file(entry.reference)) {
            kept.pictures.push_back(std::move(entry));
        } else {
            ++kept.missing;
        }
    }
}

} // namespace

KeptPictures list_kept_pictures(const RunFolder& run) {
    KeptPictures kept;
    for (const RoundRecord& round : run.plan().rounds) {
        if (!run.is_finished(round.id)) {
            ++kept.unfinished_rounds;
            continue;
        }
        const std::string measured = measures_pictures(round) ? "picture" : "visibility";
        std::vector<int> film(static_cast<std::size_t>(round.film.end - round.film.begin));
        std::iota(film.begin(), film.end(), round.film.begin);
        for (const CellRecord& cell : round.cells) {
            if (cell.role == CellRole::method) {
                add_frames(run, round, cell, measured, round.image_frames, kept);
                add_frames(run, round, cell, "film_" + measured, film, kept);
            }
        }
    }
    return kept;
}

} // namespace alcove
