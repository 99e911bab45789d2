// Masks of strata on planted surfaces whose edges, corners and angles are known.
#include "harness/run/strata.hpp"

#include "tests/harness/expect_error.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace alcove {
namespace {

constexpr ImageSize kSize{40, 24};
/// Half the angles of view have these tangents: squares of pixels.
constexpr glm::vec2 kTangents{0.05f, 0.03f};

SurfaceImages make_wall(float depth = 4.0f) {
    SurfaceImages wall{Image(kSize, 1, depth), Image(kSize, 3), Image(kSize, 3),
                       Image(kSize, 1, 1.0f)};
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            wall.normal.at(x, y, 2) = 1.0f;
        }
    }
    return wall;
}

Image get_stratum(const SurfaceImages& surfaces, const std::string& name,
                  const Image& truth = Image(kSize, 1, 1.0f)) {
    const std::vector<Image> masks = make_strata(surfaces, truth, kTangents);
    for (std::size_t i = 0; i < masks.size(); ++i) {
        if (list_strata()[i].name == name) {
            return masks[i];
        }
    }
    ADD_FAILURE() << "no stratum " << name;
    return Image(kSize, 1);
}

/// Columns of a mask that are the same in all rows, as text.
std::string read_columns(const Image& mask) {
    std::string text;
    for (int x = 0; x < mask.width(); ++x) {
        for (int y = 1; y < mask.height(); ++y) {
            EXPECT_EQ(mask.at(x, y), mask.at(x, 0)) << x << ", " << y;
        }
        text += mask.at(x, 0) != 0.0f ? '#' : '.';
    }
    return text;
}

TEST(Strata, ADepthEdgeReachesTwoPixelsToEachSideAndTheBackgroundHasNone) {
    SurfaceImages surfaces = make_wall();
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 20; x < kSize.width; ++x) {
            surfaces.eye_depth.at(x, y) = x < 30 ? 5.0f : std::numeric_limits<float>::infinity();
        }
    }
    EXPECT_EQ(read_columns(get_stratum(surfaces, "depth_edges")),
              "..................####......##..........");
    // Under 10 % of the nearer there is no edge.
    EXPECT_EQ(count_pixels(get_stratum(make_wall(), "depth_edges")), 0u);
}

/// Two walls that meet at column 20 at right angles; `inwards` as the corner of a room, else as the
/// corner of a box.
SurfaceImages make_corner(bool inwards) {
    SurfaceImages surfaces = make_wall();
    const float diagonal = std::sqrt(0.5f);
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            // Metres to the side at 4 metres, so that the walls lie at 45 degrees.
            const float side =
                (2.0f * (static_cast<float>(x) + 0.5f) / 40.0f - 1.0f) * kTangents.x * 4.0f;
            const float bend = inwards ? -std::abs(side) : std::abs(side);
            surfaces.eye_depth.at(x, y) = 4.0f + bend;
            const bool is_left = x < 20;
            surfaces.normal.at(x, y, 0) = is_left == inwards ? diagonal : -diagonal;
            surfaces.normal.at(x, y, 2) = diagonal;
        }
    }
    return surfaces;
}

TEST(Strata, ACornerOfARoomIsACreaseAndACornerOfABoxIsNot) {
    EXPECT_EQ(read_columns(get_stratum(make_corner(true), "creases")),
              "..................####..................");
    EXPECT_EQ(count_pixels(get_stratum(make_corner(false), "creases")), 0u);
    EXPECT_EQ(count_pixels(get_stratum(make_wall(), "creases")), 0u);
}

TEST(Strata, AnglesPartTheSurface) {
    SurfaceImages surfaces = make_wall();
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            // 15, 45 and 75 degrees up from the view axis; the last column is background.
            const float degrees = x < 10 ? 15.0f : x < 20 ? 45.0f : 75.0f;
            const float angle = degrees * 3.14159265f / 180.0f;
            surfaces.normal.at(x, y, 1) = std::sin(angle);
            surfaces.normal.at(x, y, 2) = std::cos(angle);
        }
        surfaces.eye_depth.at(39, y) = std::numeric_limits<float>::infinity();
    }
    EXPECT_EQ(read_columns(get_stratum(surfaces, "angle_0_30")),
              "##########..............................");
    EXPECT_EQ(read_columns(get_stratum(surfaces, "angle_30_60")),
              "..........##########....................");
    EXPECT_EQ(read_columns(get_stratum(surfaces, "angle_60_90")),
              "....................###################.");
}

TEST(Strata, MovingAndDarkPixelsAreCounted) {
    SurfaceImages surfaces = make_wall();
    Image truth(kSize, 1, 0.22f); // sRGB code 0.507
    surfaces.motion.at(3, 4, 1) = 0.01f;
    surfaces.motion.at(5, 4, 2) = -0.01f;
    truth.at(7, 8) = 0.2f; // 0.485
    const Image moving = get_stratum(surfaces, "moving", truth);
    EXPECT_EQ(count_pixels(moving), 2u);
    EXPECT_EQ(moving.at(3, 4) + moving.at(5, 4), 2.0f);
    const Image dark = get_stratum(surfaces, "dark", truth);
    EXPECT_EQ(count_pixels(dark), 1u);
    EXPECT_EQ(dark.at(7, 8), 1.0f);
}

const std::vector<Object> kObjects{{"floor", 0}, {"box", 1}, {"leg", 2}, {"leg", 2}};

TEST(Regions, ShowAllObjectsOfTheirName) {
    Image ids(kSize, 1);
    ids.at(0, 0) = 1.0f; // the floor; 0 is background
    ids.at(1, 0) = 3.0f;
    ids.at(2, 0) = 4.0f;
    const Image legs = make_region(ids, kObjects, "leg");
    EXPECT_EQ(count_pixels(legs), 2u);
    EXPECT_EQ(legs.at(1, 0) + legs.at(2, 0), 2.0f);
    EXPECT_EQ(count_pixels(make_region(ids, kObjects, "floor")), 1u);
    EXPECT_EQ(count_pixels(make_region(ids, kObjects, "box")), 0u);
}

TEST(Regions, AreNamesOfObjects) {
    EXPECT_NO_THROW(check_regions({"leg", "floor"}, kObjects, "--regions"));
    const auto refuse = [](const std::vector<std::string>& names, std::span<const Object> objects,
                           std::initializer_list<const char*> parts) {
        expect_error([&] { check_regions(names, objects, "--regions"); }, 2, parts);
    };
    refuse({"flor"}, kObjects, {"--regions", "flor", "nearest: floor"});
    refuse({"floor", "floor"}, kObjects, {"twice"});
    refuse({""}, kObjects, {"--regions"});
    const std::vector<Object> odd{{"moving", 0}, {"a[1]", 0}};
    refuse({"moving"}, odd, {"stratum"});
    refuse({"a[1]"}, odd, {"brackets"});
}

} // namespace
} // namespace alcove
