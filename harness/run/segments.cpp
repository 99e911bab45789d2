#include "harness/run/segments.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"

#include <algorithm>
#include <iterator>

namespace alcove {
namespace {

constexpr int kBurst = 16;
constexpr int kSingles = 8;

void add_singles(int frame_count, std::vector<SegmentRecord>& segments) {
    if (frame_count == 1) {
        return; // the burst is that single
    }
    int last = -1;
    for (int k = 0; k < kSingles; ++k) {
        // floor((k + 0.5) N / 8) in integers
        const int frame = (2 * k + 1) * frame_count / (2 * kSingles);
        if (frame != last) {
            segments.push_back({frame, frame + 1});
        }
        last = frame;
    }
}

} // namespace

std::vector<SegmentRecord> make_default_segments(int frame_count) {
    std::vector<SegmentRecord> segments{{0, std::min(kBurst, frame_count)}};
    if (frame_count >= 3 * kBurst) {
        const int middle = (frame_count - kBurst) / 2;
        segments.push_back({middle, middle + kBurst});
        segments.push_back({frame_count - kBurst, frame_count});
    }
    add_singles(frame_count, segments);
    return segments;
}

std::vector<SegmentRecord> make_quick_segments(int frame_count) {
    std::vector<SegmentRecord> segments{{0, std::min(kBurst, frame_count)}};
    add_singles(frame_count, segments);
    return segments;
}

SegmentRecord parse_frames(std::string_view text, int frame_count) {
    const std::vector<std::string> parts = split(text, ':');
    const std::string expected = "A:B with 0 <= A < B <= " + std::to_string(frame_count);
    if (parts.size() != 2) {
        throw InputError("--frames", "not a range", text, expected);
    }
    const std::int64_t begin = parse_integer(parts[0], "--frames");
    const std::int64_t end = parse_integer(parts[1], "--frames");
    if (begin < 0 || end <= begin || end > frame_count) {
        throw InputError("--frames", "out of range", text, expected);
    }
    return {static_cast<int>(begin), static_cast<int>(end)};
}

SegmentRecord choose_film(const std::vector<SegmentRecord>& segments) {
    std::vector<SegmentRecord> bursts;
    std::copy_if(segments.begin(), segments.end(), std::back_inserter(bursts),
                 [](const SegmentRecord& segment) { return !segment.is_single(); });
    if (bursts.empty()) {
        return {};
    }
    SegmentRecord film = bursts[bursts.size() / 2];
    film.end = std::min(film.end, film.begin + kMostFilmFrames);
    return film;
}

std::vector<int> choose_image_frames(const std::vector<SegmentRecord>& segments) {
    constexpr std::size_t kMost = 4;
    std::vector<int> singles;
    std::vector<int> all;
    for (const SegmentRecord& segment : segments) {
        for (int frame = segment.begin; frame < segment.end; ++frame) {
            all.push_back(frame);
            if (segment.is_single()) {
                singles.push_back(frame);
            }
        }
    }
    if (!singles.empty()) {
        return singles;
    }
    std::vector<int> chosen;
    const std::size_t count = std::min(kMost, all.size());
    for (std::size_t i = 0; i < count; ++i) {
        chosen.push_back(all[(2 * i + 1) * all.size() / (2 * count)]);
    }
    return chosen;
}

} // namespace alcove
