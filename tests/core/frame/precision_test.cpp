#include "core/frame/precision.hpp"

#include "core/base/error.hpp"
#include "core/frame/channels.hpp"
#include "core/frame/frame_view.hpp"

#include <gtest/gtest.h>

namespace alcove {
namespace {

TEST(Precision, DescriptionReadsBack) {
    for (const char* text :
         {"raster_depth=32F,eye_depth=32F", "raster_depth=24,reversed,eye_depth=raster",
          "raster_depth=16,eye_depth=16F", "raster_depth=32F,eye_depth=32F,motion=32F"}) {
        EXPECT_EQ(describe(parse_precision(text)), text);
    }
    EXPECT_EQ(describe(parse_precision("eye_depth=raster")), "raster_depth=32F,eye_depth=raster");
}

TEST(Precision, UnknownPartsAreErrors) {
    for (const char* wrong :
         {"raster_depth=48", "eye_depth=", "depth=24", "reverse", "motion=24", ""}) {
        EXPECT_THROW(static_cast<void>(parse_precision(wrong)), InputError) << wrong;
    }
}

TEST(Channels, ExtraChannelsAreNamedBeyondTheBase) {
    EXPECT_EQ(name_extra_channels(kBaseChannels), "");
    EXPECT_EQ(
        name_extra_channels(kBaseChannels | ChannelSet{Channel::instance_id, Channel::motion}),
        "motion+instance_id");
}

TEST(FrameView, HistoryIsInvalidAtStartsAndCuts) {
    Walkthrough walkthrough;
    walkthrough.cameras.resize(6);
    for (int i = 0; i < 6; ++i) {
        walkthrough.cameras[static_cast<std::size_t>(i)].position.x = i;
    }
    walkthrough.cuts = {3};
    for (const auto& [frame, starts, valid] : {std::tuple{0, false, false},
                                               {1, false, true},
                                               {3, false, false},
                                               {4, false, true},
                                               {4, true, false}}) {
        const FrameView view = make_frame_view(walkthrough, frame, {8, 8}, starts);
        EXPECT_EQ(view.history_valid, valid) << frame;
        EXPECT_EQ(view.previous_camera.position.x, valid ? frame - 1 : frame);
        EXPECT_DOUBLE_EQ(view.previous_time_s, (valid ? frame - 1 : frame) / 30.0);
    }
    EXPECT_TRUE(hold(make_frame_view(walkthrough, 0, {8, 8}, true)).history_valid);
}

} // namespace
} // namespace alcove
