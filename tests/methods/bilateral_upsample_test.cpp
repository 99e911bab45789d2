// Half resolution: every texel stands for a real pixel, and the way back keeps to surfaces.
#include "methods/common/bilateral_upsample.hpp"
#include "tests/methods/depth_image_rig.hpp"

#include <algorithm>
#include <cmath>

namespace alcove {
namespace {

class BilateralUpsampleTest : public GlTest {
  protected:
    struct Result {
        Image selection; ///< rows from the top
        Image visibility;
        std::vector<std::string> passes;
    };

    /// `value(x, y)` of the selected pixel, rows from the bottom, is what the texel holds.
    template <class Value>
    Result run(const DepthImage& input, int width, Value value) {
        const ImageSize size = input.depth.size();
        const GBuffer gbuffer(gl(), size, {Channel::eye_depth, Channel::normal}, {});
        gl::write_texture(gl(), gbuffer.texture(Channel::eye_depth), input.depth);
        gl::write_texture(gl(), gbuffer.texture(Channel::normal), input.normal);
        BilateralUpsample upsample(gl());
        upsample.resize(size);
        FrameView view;
        view.camera = input.camera;
        view.size = size;
        const MethodInputs inputs{view, gbuffer};
        PassRecorder passes(PassTiming::none);
        context().reset_state();
        upsample.select(inputs, "test", passes);
        const Image selection = gl::read_texture(gl(), upsample.selection(), 2);
        const ImageSize half_size = upsample.half_size();
        Image half(half_size, 1);
        for (int y = 0; y < half_size.height; ++y) {
            for (int x = 0; x < half_size.width; ++x) {
                const int row = half_size.height - 1 - y; // texture rows count from the bottom
                const int place = static_cast<int>(selection.at(x, y, 1));
                half.at(x, y) = value(2 * x + place % 2, 2 * row + place / 2);
            }
        }
        const gl::Texture half_texture(gl(), GL_R32F, half_size);
        gl::write_texture(gl(), half_texture, half);
        const gl::Texture full(gl(), GL_R32F, size);
        const gl::FramebufferHandle framebuffer = gl::create_framebuffer(gl(), {&full});
        upsample.render(inputs, {width, 0.05}, half_texture, framebuffer.get(), "test", passes);
        context().check_errors();
        return {selection, gl::read_texture(gl(), full, 1), passes.names()};
    }
};

/// Depths that differ everywhere and follow no plane.
DepthImage make_rough_image(ImageSize size) {
    DepthImage image = make_wall_image(size, 4.0f);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            image.depth.at(x, y) += 0.01f * static_cast<float>((37 * x + 101 * y) % 83);
        }
    }
    return image;
}

TEST_F(BilateralUpsampleTest, TexelsStandForTheNearestAndTheFarthestOfRealPixelsInTurns) {
    for (const ImageSize size : {ImageSize{8, 6}, ImageSize{7, 5}, ImageSize{1, 1}}) {
        const DepthImage image = make_rough_image(size);
        const Image selection = run(image, 2, [](int, int) { return 1.0f; }).selection;
        ASSERT_EQ(selection.size(), (ImageSize{(size.width + 1) / 2, (size.height + 1) / 2}));
        for (int row = 0; row < selection.height(); ++row) {
            for (int x = 0; x < selection.width(); ++x) {
                float nearest = INFINITY;
                float farthest = 0.0f;
                for (int place = 0; place < 4; ++place) {
                    const int px = 2 * x + place % 2;
                    const int py = size.height - 1 - (2 * row + place / 2);
                    if (px < size.width && py >= 0) {
                        nearest = std::min(nearest, image.depth.at(px, py));
                        farthest = std::max(farthest, image.depth.at(px, py));
                    }
                }
                const float selected = selection.at(x, selection.height() - 1 - row, 0);
                EXPECT_EQ(selected, (x + row) % 2 == 0 ? nearest : farthest) << x << " " << row;
                const int place =
                    static_cast<int>(selection.at(x, selection.height() - 1 - row, 1));
                EXPECT_EQ(selected, image.depth.at(2 * x + place % 2,
                                                   size.height - 1 - (2 * row + place / 2)));
            }
        }
    }
}

TEST_F(BilateralUpsampleTest, AConstantStaysItselfAtAnySizeAndWidth) {
    for (const ImageSize size : {ImageSize{32, 24}, ImageSize{33, 25}, ImageSize{31, 2}}) {
        for (const int width : {2, 7, 8, 32}) {
            const Result result =
                run(make_rough_image(size), width, [](int, int) { return 0.625f; });
            for (const float value : result.visibility.values()) {
                ASSERT_NEAR(value, 0.625f, 4e-6f) << width;
            }
        }
    }
}

TEST_F(BilateralUpsampleTest, ARampOnAWallIsInterpolatedWithoutAShift) {
    const ImageSize size{49, 33};
    for (const int width : {2, 7, 8}) {
        const Result result = run(make_wall_image(size, 5.0f), width, [](int x, int y) {
            return 0.01f * static_cast<float>(x) + 0.005f * static_cast<float>(y);
        });
        EXPECT_EQ(result.passes, (std::vector<std::string>{"test/downsample", "test/upsample"}));
        for (int y = 6; y < size.height - 6; ++y) {
            for (int x = 6; x < size.width - 6; ++x) {
                const float expected = 0.01f * static_cast<float>(x) +
                                       0.005f * static_cast<float>(size.height - 1 - y);
                // A box of 7 holds 3 or 4 of the taps, and is off by what the ramp rises between.
                ASSERT_NEAR(result.visibility.at(x, y), expected, width == 7 ? 3e-3f : 1e-5f)
                    << width << " " << x << " " << y;
            }
        }
    }
}

TEST_F(BilateralUpsampleTest, AWindowOfEightTakesOutATileOfFourByFour) {
    const auto tile = [](int x, int y) {
        return static_cast<float>((x / 2 % 4 + 4 * (y / 2 % 4)) * 7 % 16) / 15.0f;
    };
    const auto measure_range = [&](int width) {
        const Image visibility = run(make_wall_image({64, 48}, 5.0f), width, tile).visibility;
        float least = 1.0f;
        float most = 0.0f;
        for (int y = 8; y < 40; ++y) {
            for (int x = 8; x < 56; ++x) {
                least = std::min(least, visibility.at(x, y));
                most = std::max(most, visibility.at(x, y));
            }
        }
        return most - least;
    };
    EXPECT_GT(measure_range(2), 0.9f);
    EXPECT_GT(measure_range(7), 1e-2f);
    // What kWindowRest of the shader adds: one tap in 25 with 1e-4 of the weight of the others.
    EXPECT_LT(measure_range(8), 1e-4f);
}

TEST_F(BilateralUpsampleTest, ValuesDoNotCrossADepthEdgeAndAThinPoleKeepsItsOwn) {
    const ImageSize size{48, 32};
    for (const int column : {20, 21}) {
        DepthImage image = make_wall_image(size, 5.0f);
        for (int y = 0; y < size.height; ++y) {
            image.depth.at(column, y) = 4.0f;
        }
        for (const int width : {2, 8}) {
            const Image visibility = run(image, width, [&](int x, int) {
                                         return x == column ? 0.75f : 0.25f;
                                     }).visibility;
            for (int y = 0; y < size.height; ++y) {
                for (int x = 0; x < size.width; ++x) {
                    // The shader leaves 1e-6 (kSurfaceRest) to the other side, against 1e-4
                    // (kWindowRest) at worst: 1 %.
                    ASSERT_NEAR(visibility.at(x, y), x == column ? 0.75f : 0.25f, 0.01f)
                        << x << " " << y << " width " << width;
                }
            }
        }
    }
}

TEST_F(BilateralUpsampleTest, TheBackgroundIsOneAndLendsNothing) {
    const ImageSize size{33, 21};
    DepthImage image = make_wall_image(size, 5.0f);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            if (x >= 17) {
                image.depth.at(x, y) = INFINITY;
            }
        }
    }
    const Image visibility =
        run(image, 8, [](int x, int) { return x >= 17 ? 1.0f : 0.25f; }).visibility;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            if (x >= 17) {
                ASSERT_EQ(visibility.at(x, y), 1.0f);
            } else {
                ASSERT_NEAR(visibility.at(x, y), 0.25f, 1e-5f);
            }
        }
    }
}

} // namespace
} // namespace alcove
