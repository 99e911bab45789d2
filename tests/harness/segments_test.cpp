#include "harness/run/segments.hpp"

#include "tests/harness/expect_error.hpp"

#include <set>
#include <utility>

namespace alcove {
namespace {

using Ranges = std::vector<std::pair<int, int>>;

Ranges list_ranges(const std::vector<SegmentRecord>& segments) {
    Ranges ranges;
    for (const SegmentRecord& segment : segments) {
        ranges.emplace_back(segment.begin, segment.end);
    }
    return ranges;
}

TEST(Segments, DefaultOfTheShippedWalkthroughsIsThreeBurstsAndEightSingles) {
    EXPECT_EQ(list_ranges(make_default_segments(120)), (Ranges{{0, 16},
                                                               {52, 68},
                                                               {104, 120},
                                                               {7, 8},
                                                               {22, 23},
                                                               {37, 38},
                                                               {52, 53},
                                                               {67, 68},
                                                               {82, 83},
                                                               {97, 98},
                                                               {112, 113}}));
}

TEST(Segments, DefaultOfALongWalkthroughReachesBothEnds) {
    EXPECT_EQ(list_ranges(make_default_segments(3500)), (Ranges{{0, 16},
                                                                {1742, 1758},
                                                                {3484, 3500},
                                                                {218, 219},
                                                                {656, 657},
                                                                {1093, 1094},
                                                                {1531, 1532},
                                                                {1968, 1969},
                                                                {2406, 2407},
                                                                {2843, 2844},
                                                                {3281, 3282}}));
}

TEST(Segments, BurstsOfTheShortestThatHasThreeMeetAndDoNotOverlap) {
    const Ranges ranges = list_ranges(make_default_segments(48));
    EXPECT_EQ(Ranges(ranges.begin(), ranges.begin() + 3), (Ranges{{0, 16}, {16, 32}, {32, 48}}));
    EXPECT_EQ(ranges.size(), 11u);
}

TEST(Segments, ShorterWalkthroughsHaveOneBurst) {
    const Ranges ranges = list_ranges(make_default_segments(47));
    EXPECT_EQ(ranges.front(), (std::pair<int, int>{0, 16}));
    EXPECT_EQ(ranges.size(), 9u);
    EXPECT_EQ(
        list_ranges(make_default_segments(20)),
        (Ranges{{0, 16}, {1, 2}, {3, 4}, {6, 7}, {8, 9}, {11, 12}, {13, 14}, {16, 17}, {18, 19}}));
    // Fewer frames than singles: each frame once.
    EXPECT_EQ(list_ranges(make_default_segments(3)), (Ranges{{0, 3}, {0, 1}, {1, 2}, {2, 3}}));
}

TEST(Segments, OneFrameIsReplayedOnce) {
    EXPECT_EQ(list_ranges(make_default_segments(1)), (Ranges{{0, 1}}));
    EXPECT_EQ(list_ranges(make_quick_segments(1)), (Ranges{{0, 1}}));
}

TEST(Segments, EveryFrameExistsWhateverTheLength) {
    for (int count = 1; count <= 200; ++count) {
        for (const SegmentRecord& segment : make_default_segments(count)) {
            EXPECT_GE(segment.begin, 0) << count;
            EXPECT_LT(segment.begin, segment.end) << count;
            EXPECT_LE(segment.end, count) << count;
        }
    }
}

TEST(Segments, QuickReplaysTwentyFourFrames) {
    int frames = 0;
    for (const SegmentRecord& segment : make_quick_segments(120)) {
        frames += segment.end - segment.begin;
    }
    EXPECT_EQ(frames, 24);
}

TEST(Segments, FramesAreAHalfOpenRange) {
    const SegmentRecord segment = parse_frames("3:10", 10);
    EXPECT_EQ(segment.begin, 3);
    EXPECT_EQ(segment.end, 10);
    EXPECT_TRUE(parse_frames("9:10", 10).is_single());
}

TEST(Segments, FramesThatAreNoRangeOfTheWalkthroughAreRefused) {
    for (const char* text : {"", "3", "3:4:5", "3:3", "4:3", "-1:3", "0:11", "a:b", "0:1.5",
                             "0x1:2", ":", "0:", "99999999999999999999:1"}) {
        SCOPED_TRACE(text);
        expect_error([&] { static_cast<void>(parse_frames(text, 10)); }, 2, {"--frames"});
    }
    expect_error([] { static_cast<void>(parse_frames("0:11", 10)); }, 2, {"0:11", "B <= 10"});
}

TEST(Segments, PicturesAreKeptOfSingles) {
    EXPECT_EQ(choose_image_frames(make_default_segments(120)),
              (std::vector<int>{7, 22, 37, 52, 67, 82, 97, 112}));
}

TEST(Segments, PicturesOfABurstAreSpreadOverIt) {
    EXPECT_EQ(choose_image_frames({{10, 26}}), (std::vector<int>{12, 16, 20, 24}));
    EXPECT_EQ(choose_image_frames({{5, 7}}), (std::vector<int>{5, 6}));
    EXPECT_EQ(choose_image_frames({{5, 6}}), (std::vector<int>{5}));
}

TEST(Segments, NoPictureIsKeptTwice) {
    for (int count = 1; count <= 200; ++count) {
        const std::vector<int> frames = choose_image_frames(make_default_segments(count));
        EXPECT_EQ(std::set<int>(frames.begin(), frames.end()).size(), frames.size()) << count;
    }
}

TEST(Segments, TheFilmIsTheMiddleBurst) {
    const SegmentRecord film = choose_film(make_default_segments(120));
    EXPECT_EQ(film.begin, 52);
    EXPECT_EQ(film.end, 68);
    // Of two the later; singles are not counted.
    EXPECT_EQ(choose_film({{3, 4}, {0, 5}, {7, 8}, {10, 14}, {20, 21}}).begin, 10);
}

TEST(Segments, TheFilmIsCutAtItsLongest) {
    const SegmentRecord film = choose_film({{7, 7 + kMostFilmFrames + 1}});
    EXPECT_EQ(film.begin, 7);
    EXPECT_EQ(film.end, 7 + kMostFilmFrames);
    EXPECT_EQ(choose_film({{7, 7 + kMostFilmFrames}}).end, 7 + kMostFilmFrames);
}

TEST(Segments, WithoutABurstThereIsNoFilm) {
    for (const std::vector<SegmentRecord>& segments :
         {std::vector<SegmentRecord>{}, std::vector<SegmentRecord>{{3, 4}, {5, 6}}}) {
        const SegmentRecord film = choose_film(segments);
        EXPECT_EQ(film.begin, film.end);
    }
}

} // namespace
} // namespace alcove
