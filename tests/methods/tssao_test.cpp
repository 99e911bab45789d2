// tssao's state machine and its sums, on images that are written straight into the G-buffer.

#include "core/base/history_state.hpp"
#include "tests/methods/tssao_rig.hpp"

#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace alcove {
namespace {

constexpr ImageSize kSize{24, 16};
constexpr int kX = 12;
constexpr int kY = 8;

float get(const Image& state, HistoryChannel channel, int x = kX, int y = kY) {
    return state.at(x, y, static_cast<int>(channel));
}

HistoryCause get_cause(const Image& state, int x, int y) {
    return static_cast<HistoryCause>(static_cast<int>(get(state, HistoryChannel::cause, x, y)));
}

/// A wall whose normals point away from the viewer: every sample lies behind it, so that with
/// directions distributed as the cosine every contribution is 1; 0 with normals to the viewer.
DepthImage make_blocked_wall(ImageSize size = kSize) {
    DepthImage image = make_wall_image(size, 5.0f);
    for (float& value : image.normal.values()) {
        value = -value;
    }
    return image;
}

struct Schedule {
    int cap;
    int converged_samples;
    int filter_off;   ///< frame, counted from 1, after which convergence is over the limit
    int fewer;        ///< ... over sample_switch_conv
    int rotation_off; ///< ... over rotation_off_conv
    int full;         ///< ... 1
};

class TssaoSchedule : public TssaoTest, public testing::WithParamInterface<Schedule> {};

// Requirements of the paper's parameters, section 1.6: derived from equations (5), (6), (10).
INSTANTIATE_TEST_SUITE_P(
    Published, TssaoSchedule,
    testing::Values(Schedule{500, 8, 4, 5, 17, 48}, Schedule{500, 16, 4, 5, 11, 27},
                    Schedule{1000, 8, 7, 10, 33, 95}, Schedule{1000, 16, 7, 10, 22, 53},
                    Schedule{1500, 8, 10, 15, 49, 143}, Schedule{1500, 16, 10, 15, 32, 79}),
    [](const auto& tested) {
        return std::to_string(tested.param.cap) + "_" +
               std::to_string(tested.param.converged_samples);
    });

TEST_P(TssaoSchedule, IsThePublishedOneToTheFrame) {
    const Schedule& expected = GetParam();
    make(kSize, "history_cap=" + std::to_string(expected.cap) +
                    ",converged_samples=" + std::to_string(expected.converged_samples));
    const DepthImage wall = make_wall_image(kSize, 5.0f);
    std::map<double, int> reached;
    int last_many = 0;
    for (int frame = 1; frame <= expected.full + 2; ++frame) {
        const Image state = render(wall).state;
        const double convergence = get(state, HistoryChannel::convergence);
        for (const double limit : {params().filter_off_conv, params().sample_switch_conv,
                                   params().rotation_off_conv, 1.0}) {
            if (convergence >= limit) {
                reached.try_emplace(limit, frame);
            }
        }
        const auto samples = static_cast<int>(get(state, HistoryChannel::samples));
        EXPECT_TRUE(samples == params().initial_samples || samples == expected.converged_samples);
        last_many = samples == params().initial_samples ? frame : last_many;
    }
    EXPECT_EQ(reached.at(params().filter_off_conv), expected.filter_off);
    EXPECT_EQ(reached.at(params().sample_switch_conv), expected.fewer);
    EXPECT_EQ(last_many, expected.fewer) << "k falls in the frame behind the switch";
    EXPECT_EQ(reached.at(params().rotation_off_conv), expected.rotation_off);
    EXPECT_EQ(reached.at(1.0), expected.full);
    EXPECT_EQ(count_tssao_warm_frames(params()), expected.full);
}

TEST_F(TssaoTest, AnImpulseWeighsOneOverItsCountAndDecaysAsTheCapSays) {
    // Hemisphere contributions are 0 or 1, so the occlusion is the impulse's weight itself.
    make(kSize, "history_cap=500,invalidation=none");
    const DepthImage open = make_wall_image(kSize, 5.0f);
    const DepthImage blocked = make_blocked_wall();
    for (int frame = 0; frame < 10; ++frame) {
        ASSERT_EQ(render(open).history.at(kX, kY, 0), 0.0f);
    }
    // 5 frames of 32 and 5 of 8.
    double count = 200.0;
    Image history = render(blocked).history;
    EXPECT_NEAR(history.at(kX, kY, 0), 8.0 / (count + 8.0), 1e-5 * 8.0);
    double expected = 8.0 / (count + 8.0);
    count += 8.0;
    for (int frame = 0; frame < 120; ++frame) {
        history = render(open).history;
        expected *= count / (count + 8.0);
        count = std::min(count + 8.0, 500.0);
        ASSERT_NEAR(history.at(kX, kY, 0), expected, 1e-5) << frame;
        ASSERT_EQ(history.at(kX, kY, 1), count) << frame;
    }
    EXPECT_EQ(count, 500.0) << "the plateau was reached, where a frame keeps 500 / 508";
}

TEST_F(TssaoTest, WithoutACapTheHistoryIsThePlainMeanOfAllSamples) {
    const DepthImage step = [] {
        DepthImage image = make_wall_image(kSize, 5.0f);
        for (int y = 0; y < kSize.height; ++y) {
            for (int x = 0; x < kX; ++x) {
                image.depth.at(x, y) = 4.8f;
            }
        }
        return image;
    }();
    make(kSize, "history_cap=inf,initial_samples=32,converged_samples=32,rotation_off_conv=0,"
                "filter_radius=0");
    Image many;
    for (int frame = 0; frame < 15; ++frame) {
        many = render(step).visibility;
    }
    make(kSize, "use_history=false,initial_samples=480,rotation_off_conv=0,filter_radius=0");
    const Image one = render(step).visibility;
    float darkest = 1.0f;
    for (std::size_t i = 0; i < one.values().size(); ++i) {
        // 15 roundings of a mean: 2^-24 each.
        ASSERT_NEAR(many.values()[i], one.values()[i], 2e-6) << i;
        darkest = std::min(darkest, one.values()[i]);
    }
    EXPECT_LT(darkest, 0.97f) << "there is something to add up";
}

TEST_F(TssaoTest, ConstantContributionsStayConstantUnderAnyInvalidation) {
    for (const char* settings :
         {"invalidation=smooth", "invalidation=full", "invalidation=smooth,smooth_clamp=after",
          "confidence=graded", "invalidation=none", "top_up=false", "resolution=half"}) {
        make(kSize, std::string(settings) + ",cut=4");
        DepthImage image = make_blocked_wall();
        Image motion(kSize, 3);
        for (int frame = 0; frame < 12; ++frame) {
            // Cameras jump about and motion says nonsense: histories are lost here and there.
            image.camera.position.x = 0.05 * ((frame * 7) % 5);
            for (std::size_t i = 0; i < motion.values().size(); ++i) {
                motion.values()[i] =
                    0.02f * static_cast<float>((i * 31 + static_cast<std::size_t>(frame)) % 7);
            }
            const TssaoFrame result = render(image, &motion);
            for (int y = 0; y < result.history.height(); ++y) {
                for (int x = 4; x < result.history.width() - 4; ++x) {
                    // Off the border, where samples outside the image are open.
                    if (get(result.state, HistoryChannel::surface, x, y) != 0.0f) {
                        ASSERT_LE(result.history.at(x, y, 0), 1.0f + 1e-6f) << settings;
                    }
                }
            }
            const float centre =
                result.history.at(result.history.width() / 2, result.history.height() / 2, 0);
            ASSERT_NEAR(centre, 1.0f, 1e-6f) << settings << ", frame " << frame;
        }
    }
}

TEST_F(TssaoTest, ANanInAHistoryIsGoneAfterAFrameAndReachesNoNeighbour) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    for (int channel = 0; channel < 4; ++channel) {
        for (const float bad : {nan, infinity, -1.0f}) {
            make(kSize, "");
            DepthImage wall = make_wall_image(kSize, 5.0f);
            render(wall);
            render(wall);
            std::array<float, 4> planted{0.0f, 64.0f, 64.0f, 5.0f};
            planted.at(static_cast<std::size_t>(channel)) = bad;
            plant(kX, kY, planted);
            // Half a pixel to the side: the planted texel is a tap of its neighbours.
            wall.camera.position.x +=
                0.5 * 5.0 * 2.0 * std::tan(std::numbers::pi / 6.0) / kSize.height;
            const TssaoFrame after = render(wall);
            for (int y = 0; y < kSize.height; ++y) {
                for (int x = 0; x < kSize.width; ++x) {
                    ASSERT_GE(after.visibility.at(x, y), 0.0f) << channel << " " << bad;
                    ASSERT_LE(after.visibility.at(x, y), 1.0f) << channel << " " << bad;
                    for (int c = 0; c < 4; ++c) {
                        ASSERT_TRUE(std::isfinite(after.history.at(x, y, c)))
                            << "channel " << c << " of " << x << ", " << y;
                    }
                }
            }
            if (channel == 0) {
                EXPECT_GT(get(after.state, HistoryChannel::convergence, kX + 4, kY), 0.09f)
                    << "others keep their history";
            }
        }
    }
}

TEST_F(TssaoTest, ANanInTheGeometryIsGoneAfterAFrame) {
    make(kSize, "");
    const DepthImage wall = make_wall_image(kSize, 5.0f);
    render(wall);
    DepthImage broken = wall;
    broken.depth.at(kX, kY) = std::numeric_limits<float>::quiet_NaN();
    broken.normal.at(kX + 4, kY, 0) = std::numeric_limits<float>::quiet_NaN();
    render(broken);
    const TssaoFrame after = render(wall);
    for (const float value : after.visibility.values()) {
        ASSERT_GE(value, 0.0f);
        ASSERT_LE(value, 1.0f);
    }
}

TEST_F(TssaoTest, AStillCameraResamplesNothing) {
    // Fractional places would blur the step a little more every frame.
    DepthImage step = make_wall_image(kSize, 5.0f);
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kX; ++x) {
            step.depth.at(x, y) = 4.99f;
        }
    }
    make(kSize, "invalidation=none,filter_radius=0");
    render(step);
    plant(kX, kY, {0.9f, 64.0f, 64.0f, 5.0f});
    const Image before = render(step).history;
    EXPECT_NEAR(before.at(kX, kY, 0), 0.9f * 64.0f / 96.0f, 0.2f);
    EXPECT_LT(before.at(kX + 1, kY, 0), 0.2f) << "nothing spreads";
    EXPECT_LT(before.at(kX, kY + 1, 0), 0.2f);
}

TEST_F(TssaoTest, APanOfOnePixelCarriesTheHistoryAlong) {
    const ImageSize size{32, 16};
    make(size, "invalidation=none,filter_radius=0");
    DepthImage wall = make_wall_image(size, 5.0f);
    render(wall);
    plant(10, 8, {0.9f, 160.0f, 64.0f, 5.0f});
    const double pixel_m = 5.0 * 2.0 * std::tan(std::numbers::pi / 6.0) / size.height;
    wall.camera.position.x += pixel_m;
    const TssaoFrame moved = render(wall);
    // The camera went right, so what it sees went left.
    EXPECT_NEAR(moved.history.at(9, 8, 0), 0.9 * 160.0 / 192.0, 1e-4);
    EXPECT_NEAR(moved.history.at(9, 8, 2), 96.0, 0.0) << "32 samples on from its own place";
    EXPECT_EQ(moved.history.at(10, 8, 0), 0.0f);
    // The column that came into view.
    EXPECT_EQ(get_cause(moved.state, size.width - 1, 8), HistoryCause::off_screen);
    EXPECT_EQ(get_cause(moved.state, 5, 8), HistoryCause::kept);
}

TEST_F(TssaoTest, TheIndexIsFetchedFromTheNearestTexelAndNeverMixed) {
    const ImageSize size{32, 16};
    make(size, "invalidation=none,filter_radius=0");
    DepthImage wall = make_wall_image(size, 5.0f);
    render(wall);
    plant(10, 8, {0.0f, 32.0f, 1000.0f, 5.0f});
    const double pixel_m = 5.0 * 2.0 * std::tan(std::numbers::pi / 6.0) / size.height;
    wall.camera.position.x += 0.3 * pixel_m;
    const Image history = render(wall).history;
    for (int x = 0; x < size.width - 1; ++x) {
        // Beyond twice the table stands the mark of kernels that reach over the border.
        const float index = std::fmod(history.at(x, 8, 2), 2.0f * kTssaoKernelLength);
        EXPECT_TRUE(index == 64.0f || index == 1032.0f) << x << ": " << index;
    }
}

TEST_F(TssaoTest, ADeeperSurfaceBehindTheOldOneIsADisocclusionInEveryTest) {
    for (const char* test : {"plane", "relative", "absolute", "post_projective"}) {
        make(kSize, std::string("disocclusion=") + test);
        render(make_wall_image(kSize, 4.0f));
        const TssaoFrame deeper = render(make_wall_image(kSize, 5.0f));
        EXPECT_EQ(get_cause(deeper.state, kX, kY), HistoryCause::disocclusion) << test;
        EXPECT_EQ(get(deeper.state, HistoryChannel::samples), 32.0f);
    }
}

TEST_F(TssaoTest, TheRelativeTestIsRightAtEveryDepthAndTheAbsoluteOneIsNot) {
    const auto find_cause = [this](const char* test, float before, float now) {
        make(kSize, std::string("disocclusion=") + test);
        render(make_wall_image(kSize, before));
        return get_cause(render(make_wall_image(kSize, now)).state, kX, kY);
    };
    // 1 % at 50 m is the same surface, 5 % at 1 m is another one.
    EXPECT_EQ(find_cause("relative", 50.0f, 50.5f), HistoryCause::kept);
    EXPECT_EQ(find_cause("relative", 1.0f, 1.05f), HistoryCause::disocclusion);
    EXPECT_EQ(find_cause("absolute", 50.0f, 50.5f), HistoryCause::disocclusion) << "false alarm";
    EXPECT_EQ(find_cause("absolute", 1.0f, 1.05f), HistoryCause::kept) << "missed";
}

TEST_F(TssaoTest, TheNeighbourhoodTestFiresAboveItsToleranceOnly) {
    // A wall with a raised part that moves sideways along it, by its motion vectors alone.
    const ImageSize size{48, 32};
    DepthImage image = make_wall_image(size, 5.0f);
    Image motion(size, 3);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 24; x < size.width; ++x) {
            image.depth.at(x, y) = 4.8f;
        }
    }
    const auto find_cause = [&](float moved_m, const char* settings) {
        make(size, settings);
        render(image);
        for (int y = 0; y < size.height; ++y) {
            for (int x = 24; x < size.width; ++x) {
                motion.at(x, y, 0) = moved_m;
            }
        }
        return get_cause(render(image, &motion).state, 23, 16);
    };
    // The tolerance is the larger of 0.02 r = 0.01 m and the pixel's footprint, 0.18 m here.
    const float footprint =
        static_cast<float>(2.0 * std::tan(std::numbers::pi / 6.0) * 5.0 / size.height);
    EXPECT_EQ(find_cause(0.5f * footprint, ""), HistoryCause::kept);
    EXPECT_EQ(find_cause(2.0f * footprint, ""), HistoryCause::neighbourhood);
    EXPECT_EQ(find_cause(2.0f * footprint, "invalidation=none"), HistoryCause::kept);
}

TEST_F(TssaoTest, SmoothInvalidationLeavesItsCountAndBringsEverythingBack) {
    const ImageSize size{48, 32};
    DepthImage image = make_wall_image(size, 5.0f);
    Image still(size, 3);
    Image motion(size, 3);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 24; x < size.width; ++x) {
            image.depth.at(x, y) = 4.8f;
            motion.at(x, y, 0) = 0.5f;
        }
    }
    const auto settle = [&](const std::string& settings) {
        make(size, "history_cap=500" + settings);
        for (int frame = 0; frame < 60; ++frame) {
            render(image, &still);
        }
        return render(image, &motion);
    };
    // k2 samples find the change, top-up takes k1; 32 of the old count are left.
    const TssaoFrame smooth = settle("");
    EXPECT_EQ(get(smooth.state, HistoryChannel::samples, 23, 16), 32.0f);
    EXPECT_EQ(smooth.history.at(23, 16, 1), 64.0f);
    EXPECT_EQ(settle(",top_up=false").history.at(23, 16, 1), 40.0f);
    EXPECT_EQ(settle(",invalidation=full").history.at(23, 16, 1), 32.0f);
    EXPECT_EQ(settle(",smooth_clamp=after").history.at(23, 16, 1), 32.0f);
    EXPECT_EQ(settle(",invalidation=none").history.at(23, 16, 1), 500.0f);
    // Convergence 0.064 after invalidation to 32 of 500 turns filter, k1 and rotation on again.
    EXPECT_LT(get(smooth.state, HistoryChannel::convergence, 23, 16), params().filter_off_conv);
    EXPECT_EQ(smooth.history.at(8, 16, 1), 500.0f) << "far from it nothing is lost";
}

TEST_F(TssaoTest, TheFilterChangesOnlyUnconvergedPixelsAndNeverTheHistory) {
    const ImageSize size{48, 32};
    DepthImage image = make_wall_image(size, 5.0f);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 24; x < size.width; ++x) {
            image.depth.at(x, y) = 4.8f;
        }
    }
    const auto run = [&](const std::string& settings, int frames) {
        make(size, settings);
        TssaoFrame frame;
        for (int i = 0; i < frames; ++i) {
            frame = render(image);
        }
        return frame;
    };
    // Frame 6 of a cap of 1000 is the last below 0.2, frame 7 the first above.
    const TssaoFrame filtered = run("", 6);
    const TssaoFrame plain = run("filter_radius=0", 6);
    EXPECT_NE(hash_image(filtered.visibility), hash_image(plain.visibility));
    EXPECT_EQ(hash_image(filtered.history), hash_image(plain.history));
    EXPECT_EQ(hash_image(run("", 7).visibility), hash_image(run("filter_radius=0", 7).visibility));
    EXPECT_EQ(plain.passes, std::vector<std::string>{"tssao/accumulate"});
}

TEST_F(TssaoTest, WhereNothingMovesLeavingOutTheTestChangesNoBit) {
    const ImageSize size{48, 32};
    DepthImage image = make_wall_image(size, 5.0f);
    for (int y = 10; y < 20; ++y) {
        for (int x = 24; x < 40; ++x) {
            image.depth.at(x, y) = 4.7f;
        }
    }
    const Image still(size, 3);
    const auto run = [&](const Image* motion) {
        make(size, "");
        TssaoFrame frame;
        for (int i = 0; i < 20; ++i) {
            image.camera.position.x = 0.01 * i;
            frame = render(image, motion);
        }
        return frame;
    };
    EXPECT_EQ(hash_image(run(nullptr).history), hash_image(run(&still).history));
}

TEST_F(TssaoTest, HalfResolutionIsTheFullOneAwayFromEdges) {
    const ImageSize size{49, 33};
    make(size, "resolution=half");
    const TssaoFrame half = render(make_wall_image(size, 5.0f));
    EXPECT_EQ(half.history.size(), (ImageSize{25, 17}));
    EXPECT_EQ(half.visibility.size(), size);
    EXPECT_EQ(half.passes.back(), "tssao/upsample");
    for (const float value : half.visibility.values()) {
        ASSERT_EQ(value, 1.0f);
    }
}

} // namespace
} // namespace alcove
