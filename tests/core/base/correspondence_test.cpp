#include "core/base/correspondence.hpp"

#include <array>
#include <limits>

#include <gtest/gtest.h>

namespace alcove {
namespace {

constexpr ImageSize kSize{12, 9};

/// No two pixels alike, exact in float.
Image make_pattern(int channels = 1) {
    Image image(kSize, channels);
    for (std::size_t i = 0; i < image.values().size(); ++i) {
        image.values()[i] = static_cast<float>((i * 37) % 512) / 512.0f;
    }
    return image;
}

/// Every pixel was `dx`, `dy` further right and down; valid where that is inside the image.
Correspondence make_pan(float dx, float dy) {
    Correspondence pan = make_identity_correspondence(kSize);
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            float& from_x = pan.position.at(x, y, 0);
            float& from_y = pan.position.at(x, y, 1);
            from_x += dx;
            from_y += dy;
            const bool inside =
                from_x >= 0.0f && from_x < kSize.width && from_y >= 0.0f && from_y < kSize.height;
            pan.valid.at(x, y) = inside ? 1.0f : 0.0f;
        }
    }
    return pan;
}

TEST(Correspondence, IdentityGivesBackEveryBit) {
    Image image = make_pattern(2);
    image.at(0, 0, 0) = std::numeric_limits<float>::denorm_min();
    image.at(11, 8, 1) = -1e30f;
    EXPECT_EQ(hash_image(warp_image(image, make_identity_correspondence(kSize))),
              hash_image(image));
}

TEST(Correspondence, PixelCentresLieAtHalves) {
    const Correspondence identity = make_identity_correspondence(kSize);
    EXPECT_EQ(identity.position.at(0, 0, 0), 0.5f);
    EXPECT_EQ(identity.position.at(0, 0, 1), 0.5f);
    EXPECT_EQ(identity.position.at(11, 3, 0), 11.5f);
    EXPECT_EQ(identity.position.at(11, 3, 1), 3.5f);
}

TEST(Correspondence, APanByWholePixelsMovesThemUnchanged) {
    const Image image = make_pattern(3);
    for (const auto& [dx, dy] : {std::array{1, 0}, std::array{0, 2}, std::array{-3, 1}}) {
        const Correspondence pan = make_pan(static_cast<float>(dx), static_cast<float>(dy));
        const Image warped = warp_image(image, pan);
        for (int y = 0; y < kSize.height; ++y) {
            for (int x = 0; x < kSize.width; ++x) {
                for (int c = 0; c < 3; ++c) {
                    EXPECT_EQ(warped.at(x, y, c),
                              pan.valid.at(x, y) != 0.0f ? image.at(x + dx, y + dy, c) : 0.0f)
                        << x << " " << y;
                }
            }
        }
    }
}

TEST(Correspondence, HalfAPixelIsTheMeanOfTwo) {
    const Image image = make_pattern();
    const Image across = warp_image(image, make_pan(0.5f, 0.0f));
    const Image down = warp_image(image, make_pan(0.0f, 0.5f));
    const Image both = warp_image(image, make_pan(0.5f, 0.5f));
    for (int y = 0; y + 1 < kSize.height; ++y) {
        for (int x = 0; x + 1 < kSize.width; ++x) {
            EXPECT_EQ(across.at(x, y), 0.5f * (image.at(x, y) + image.at(x + 1, y)));
            EXPECT_EQ(down.at(x, y), 0.5f * (image.at(x, y) + image.at(x, y + 1)));
            EXPECT_EQ(both.at(x, y), 0.25f * (image.at(x, y) + image.at(x + 1, y) +
                                              image.at(x, y + 1) + image.at(x + 1, y + 1)));
        }
    }
}

TEST(Correspondence, BeyondTheBorderTheBorderIsRepeated) {
    const Image image = make_pattern();
    Correspondence everywhere = make_identity_correspondence(kSize);
    everywhere.position.at(0, 0, 0) = 0.0f; // between the first centre and the edge
    everywhere.position.at(11, 8, 0) = 12.0f;
    everywhere.position.at(11, 8, 1) = 9.0f;
    everywhere.position.at(5, 5, 0) = -1e20f;
    everywhere.position.at(6, 5, 1) = 1e20f;
    const Image warped = warp_image(image, everywhere);
    EXPECT_EQ(warped.at(0, 0), image.at(0, 0));
    EXPECT_EQ(warped.at(11, 8), image.at(11, 8));
    EXPECT_EQ(warped.at(5, 5), image.at(0, 5));
    EXPECT_EQ(warped.at(6, 5), image.at(6, 8));
}

TEST(Correspondence, WhatIsNotValidIsZeroWhereverItPoints) {
    Correspondence holes = make_identity_correspondence(kSize);
    holes.valid.at(3, 4) = 0.0f;
    holes.position.at(3, 4, 0) = std::numeric_limits<float>::quiet_NaN();
    const Image warped = warp_image(Image(kSize, 2, 1.0f), holes);
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            const float expected = x == 3 && y == 4 ? 0.0f : 1.0f;
            EXPECT_EQ(warped.at(x, y, 0), expected);
            EXPECT_EQ(warped.at(x, y, 1), expected);
        }
    }
}

TEST(Correspondence, TwoPansAreThePanOfTheirSum) {
    for (const auto& [first, second] :
         {std::array{1.0f, 2.0f}, std::array{0.5f, 0.25f}, std::array{-1.5f, 3.0f}}) {
        const Correspondence composed =
            compose_correspondences(make_pan(first, 0.5f), make_pan(second, 0.25f));
        const Correspondence sum = make_pan(first + second, 0.75f);
        int compared = 0;
        for (int y = 0; y < kSize.height; ++y) {
            for (int x = 0; x < kSize.width; ++x) {
                if (composed.valid.at(x, y) == 0.0f) {
                    continue;
                }
                ++compared;
                EXPECT_EQ(composed.position.at(x, y, 0), sum.position.at(x, y, 0));
                EXPECT_EQ(composed.position.at(x, y, 1), sum.position.at(x, y, 1));
            }
        }
        EXPECT_GE(compared, 8 * (kSize.width - 4)) << first << " " << second;
    }
}

TEST(Correspondence, IdentityOnEitherSideChangesNothing) {
    const Correspondence pan = make_pan(1.25f, -0.5f);
    const Correspondence identity = make_identity_correspondence(kSize);
    for (const Correspondence& composed :
         {compose_correspondences(pan, identity), compose_correspondences(identity, pan)}) {
        EXPECT_EQ(hash_image(composed.valid), hash_image(pan.valid));
        for (int y = 0; y < kSize.height; ++y) {
            for (int x = 0; x < kSize.width; ++x) {
                if (pan.valid.at(x, y) != 0.0f) {
                    EXPECT_EQ(composed.position.at(x, y, 0), pan.position.at(x, y, 0));
                    EXPECT_EQ(composed.position.at(x, y, 1), pan.position.at(x, y, 1));
                }
            }
        }
    }
}

TEST(Correspondence, WhatWasNotValidOnceIsNotValidAfterwards) {
    Correspondence first = make_pan(1.0f, 0.0f);
    Correspondence second = make_pan(2.0f, 0.0f);
    first.valid.at(4, 4) = 0.0f;
    second.valid.at(7, 2) = 0.0f; // seen from pixel (6, 2) one step later
    const Correspondence composed = compose_correspondences(first, second);
    EXPECT_EQ(composed.valid.at(4, 4), 0.0f);
    EXPECT_EQ(composed.valid.at(6, 2), 0.0f);
    EXPECT_EQ(composed.valid.at(5, 2), 1.0f);
    EXPECT_EQ(composed.valid.at(7, 2), 1.0f);
    // The last three columns leave the image: one by the first step, two by the second.
    EXPECT_EQ(composed.valid.at(8, 0), 1.0f);
    for (int x = 9; x < kSize.width; ++x) {
        EXPECT_EQ(composed.valid.at(x, 0), 0.0f) << x;
    }
}

} // namespace
} // namespace alcove
