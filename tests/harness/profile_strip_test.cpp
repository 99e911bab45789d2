// The middle rows of a film, stacked.
#include "harness/run/profile_strip.hpp"

#include <gtest/gtest.h>

namespace alcove {
namespace {

TEST(ProfileStrip, StacksTheMiddleRowOfEachFrameFromTopToBottom) {
    ProfileStrip strip;
    EXPECT_TRUE(strip.is_empty());
    for (int t = 0; t < 3; ++t) {
        Image frame({5, 4}, 1, 0.9f);
        for (int x = 0; x < 5; ++x) {
            frame.at(x, 2) = static_cast<float>(10 * t + x);
        }
        strip.add(frame);
    }
    const Image image = strip.make_image();
    ASSERT_EQ(image.size(), (ImageSize{5, 3 * ProfileStrip::kFrameHeight}));
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < 5; ++x) {
            EXPECT_EQ(image.at(x, y),
                      static_cast<float>(10 * (y / ProfileStrip::kFrameHeight) + x));
        }
    }
    strip.clear();
    EXPECT_TRUE(strip.is_empty());
}

TEST(ProfileStrip, KeepsColours) {
    ProfileStrip strip;
    Image frame({2, 1}, 3);
    frame.at(1, 0, 0) = 0.1f;
    frame.at(1, 0, 2) = 0.3f;
    strip.add(frame);
    const Image image = strip.make_image();
    ASSERT_EQ(image.channels(), 3);
    for (int y = 0; y < ProfileStrip::kFrameHeight; ++y) {
        EXPECT_EQ(image.at(0, y, 2), 0.0f);
        EXPECT_EQ(image.at(1, y, 0), 0.1f);
        EXPECT_EQ(image.at(1, y, 2), 0.3f);
    }
}

} // namespace
} // namespace alcove
