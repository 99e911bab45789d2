#include "core/base/image_file.hpp"
#include "reports/analysis/comparison_quality.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <fmt/core.h>

namespace alcove {
namespace {

namespace fs = std::filesystem;

/// How many changed frames are named.
constexpr std::size_t kNamedFrames = 5;

/// Segment, frame and state.
using ImageKey = std::tuple<int, int, SampleState>;

std::map<ImageKey, std::string> read_hashes(const std::vector<MetricRow>& rows) {
    std::map<ImageKey, std::string> hashes;
    for (const MetricRow& row : rows) {
        if (!row.image_hash.empty()) {
            hashes[{row.segment, row.frame, row.state}] = row.image_hash;
        }
    }
    return hashes;
}

/// The kept picture of an image (harness/run/round_capture): singles, converged where the method
/// has a history, or bursts if there is no single; and the film. Nothing if it was not kept.
std::optional<std::string> find_picture(const MeasuredCell& side, const ImageKey& key) {
    const auto& [segment, frame, state] = key;
    const RoundRecord& round = side.round;
    const bool is_single = round.segments[static_cast<std::size_t>(segment)].is_single();
    const bool has_singles = std::any_of(round.segments.begin(), round.segments.end(),
                                         [](const SegmentRecord& s) { return s.is_single(); });
    const bool is_picture = measures_pictures(round);
    const bool is_held = state == SampleState::converged;
    std::vector<std::string_view> pictures;
    if (!has_singles || (is_single && is_held == (side.cell.warm_frames > 0))) {
        pictures.emplace_back(is_picture ? "picture" : "visibility");
    }
    if (!is_single && !is_held && frame >= round.film.begin && frame < round.film.end) {
        pictures.emplace_back(is_picture ? "film_picture" : "film_visibility");
    }
    for (const std::string_view picture : pictures) {
        std::string path = RunFolder::make_image_path(round.id, side.cell.id, frame, picture);
        if (fs::is_regular_file(side.run.path() / path)) {
            return path;
        }
    }
    return std::nullopt;
}

std::optional<double> measure_difference(const fs::path& base, const fs::path& next) {
    const Image a = read_image_file(base).image;
    const Image b = read_image_file(next).image;
    if (a.size() != b.size() || a.channels() != b.channels()) {
        return std::nullopt;
    }
    double sum = 0.0;
    for (std::size_t i = 0; i < a.values().size(); ++i) {
        sum += std::abs(static_cast<double>(b.values()[i]) - static_cast<double>(a.values()[i]));
    }
    return 255.0 * sum / static_cast<double>(a.values().size());
}

} // namespace

ImageComparison compare_images(const MeasuredCell& base, const MeasuredCell& next) {
    const std::map<ImageKey, std::string> base_hashes = read_hashes(base.rows);
    const std::map<ImageKey, std::string> next_hashes = read_hashes(next.rows);
    std::map<ImageKey, bool> changed;
    for (const auto& [key, hash] : base_hashes) {
        const auto found = next_hashes.find(key);
        changed[key] = found == next_hashes.end() || found->second != hash;
    }
    for (const auto& [key, hash] : next_hashes) {
        changed.try_emplace(key, true);
    }
    ImageComparison images;
    images.images = changed.size();
    for (const auto& [key, is_changed] : changed) {
        if (!is_changed) {
            continue;
        }
        ++images.changed;
        const auto& [segment, frame, state] = key;
        if (images.first.size() < kNamedFrames) {
            images.first.push_back(fmt::format("frame {} {}", frame, to_text(state)));
        }
        const auto base_picture = find_picture(base, key);
        const auto next_picture = find_picture(next, key);
        if (base_picture && next_picture) {
            images.pictures.push_back({frame, *base_picture, *next_picture,
                                       measure_difference(base.run.path() / *base_picture,
                                                          next.run.path() / *next_picture)});
        }
    }
    return images;
}

} // namespace alcove
