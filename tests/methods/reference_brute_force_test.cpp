// The march against closed forms where the depth buffer holds all there is, and against its own
// limits where it does not.
#include "methods/reference_brute_force/reference_brute_force.hpp"
#include "tests/methods/analytic_occlusion.hpp"
#include "tests/methods/depth_image_rig.hpp"

#include <cmath>

namespace alcove {
namespace {

constexpr ImageSize kSize{128, 96};

class ReferenceBruteForceTest : public DepthImageTest {
  protected:
    Image march(const DepthImage& input,
                const std::vector<std::pair<std::string, std::string>>& overrides,
                std::uint32_t seed = 1) {
        return run(m_unit, resolve(m_unit, "default", overrides), input, seed).visibility;
    }
    const MethodUnit m_unit = reference_brute_force_unit();
};

/// A wall at 4 m that faces the viewer, and over its left half a block that stands out of it by 2
/// m. The block's side lies in the plane of the view axis: seen in no pixel, and where the image
/// knows it, at x = 0.
DepthImage make_block_image() {
    DepthImage image = make_wall_image(kSize, 4.0f);
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width / 2; ++x) {
            image.depth.at(x, y) = 2.0f;
        }
    }
    return image;
}

/// Metres from the block's side, on the wall.
double measure_distance(const DepthImage& image, int column) {
    return 4.0 * compute_pixel_direction(image.camera, kSize, {column + 0.5, kSize.height / 2.0}).x;
}

TEST_F(ReferenceBruteForceTest, ASolidBlockOccludesLikeTheAnalyticWall) {
    const DepthImage image = make_block_image();
    for (const Falloff falloff : {Falloff::none, Falloff::linear, Falloff::quadratic}) {
        for (const Weighting weighting : {Weighting::cosine, Weighting::uniform}) {
            const Image visibility = march(image, {{"radius", "1"},
                                                   {"rays", "512"},
                                                   {"falloff", std::string(to_text(falloff))},
                                                   {"weighting", std::string(to_text(weighting))}});
            // The block is higher than the radius, and rays of the middle rows stay in the image.
            for (const int column : {71, 75, 80}) {
                const double k = measure_distance(image, column);
                ASSERT_GT(k, 0.3);
                ASSERT_LT(k, 0.95);
                double sum = 0.0;
                int rows = 0;
                for (int y = 40; y < 56; ++y, ++rows) {
                    sum += visibility.at(column, y);
                }
                const double expected = 1.0 - integrate_wall_occlusion(k, falloff, weighting);
                // A step is a pixel, 48 mm of the wall: a hit is known to half of that, and
                // occlusion falls by at most 0.6 a radius.
                EXPECT_NEAR(sum / rows, expected, 0.015)
                    << to_text(falloff) << " " << to_text(weighting) << " at " << k;
            }
        }
    }
}

TEST_F(ReferenceBruteForceTest, AThinSheetBlocksOnlyAsMuchAsItsThickness) {
    // The same picture, taken for a sheet of 2 cm in front of the wall: rays pass behind it.
    const DepthImage image = make_block_image();
    const Image solid = march(image, {{"radius", "1"}, {"falloff", "none"}});
    const Image thin = march(image, {{"radius", "1"}, {"falloff", "none"}, {"thickness", "0.02"}});
    EXPECT_LT(solid.at(76, 48), 0.9f);
    EXPECT_GT(thin.at(76, 48), 0.995f);
}

TEST_F(ReferenceBruteForceTest, AFlatWallIsOpenWithAnyFalloffAndThickness) {
    const DepthImage wall = make_wall_image(kSize, 4.0f);
    for (const char* thickness : {"0.001", "inf"}) {
        const Image visibility = march(wall, {{"thickness", thickness}, {"falloff", "none"}});
        for (const float value : visibility.values()) {
            ASSERT_EQ(value, 1.0f);
        }
    }
}

TEST_F(ReferenceBruteForceTest, MoreRaysThanADrawTakesAreOneEstimate) {
    // 96 rays are three draws, 97 four: the estimates agree as neighbours do, not as parts.
    const DepthImage image = make_block_image();
    const Image some = march(image, {{"rays", "96"}});
    const Image more = march(image, {{"rays", "97"}});
    double largest = 0.0;
    for (std::size_t i = 0; i < some.values().size(); ++i) {
        largest = std::max(largest, std::abs(static_cast<double>(some.values()[i]) -
                                             static_cast<double>(more.values()[i])));
    }
    EXPECT_GT(largest, 0.0);
    EXPECT_LT(largest, 0.12);
}

TEST_F(ReferenceBruteForceTest, SeedsAreIndependentRandomisationsOfOneMean) {
    const DepthImage image = make_block_image();
    const Image a = march(image, {{"radius", "1"}, {"rays", "64"}}, 1);
    const Image b = march(image, {{"radius", "1"}, {"rays", "64"}}, 2);
    double difference = 0.0;
    double squares = 0.0;
    int count = 0;
    for (int y = 30; y < 66; ++y) {
        for (int x = 68; x < 84; ++x, ++count) {
            const double d = static_cast<double>(a.at(x, y)) - static_cast<double>(b.at(x, y));
            difference += d;
            squares += d * d;
        }
    }
    const double rms = std::sqrt(squares / count);
    EXPECT_GT(rms, 0.002);
    EXPECT_LT(rms, 0.05);
    // Four standard errors of the mean of as many independent differences.
    EXPECT_LT(std::abs(difference / count), 4.0 * rms / std::sqrt(count));
}

} // namespace
} // namespace alcove
