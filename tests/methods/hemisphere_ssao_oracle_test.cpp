// The shader at 512 samples against the same estimator in double precision.
#include "tests/methods/depth_scenes.hpp"
#include "tests/methods/hemisphere_ssao_oracle.hpp"

#include <cmath>

namespace alcove {
namespace {

constexpr std::uint32_t kNoiseSeed = 12345;
// Reach and distances of a few metres alike: the more of the image a sample may cross, the fewer of
// 512 samples lie within 1e-5 of a surface. At 0.5 m and 5 m every tenth pixel has one.
constexpr const char* kRadius = "2.5";

struct Comparison {
    int pixels = 0;
    int unflagged = 0;
    int occluded = 0; ///< visibility below 0.95
    double largest_unflagged = 0.0;
    double largest_excess = -1.0; ///< over all: deviation less the weight of flagged samples
};

class HemisphereSsaoOracleTest : public DepthImageTest {
  protected:
    Comparison compare(const DepthImage& input,
                       const std::vector<std::pair<std::string, std::string>>& forms) {
        const MethodUnit unit = hemisphere_ssao_unit();
        std::vector<std::pair<std::string, std::string>> overrides = forms;
        overrides.insert(overrides.end(),
                         {{"samples", "512"}, {"blur_radius", "0"}, {"radius", kRadius}});
        const ResolvedParameters resolved = resolve(unit, "default", overrides);
        const RigResult result = run(unit, resolved, input, kNoiseSeed);
        const std::vector<OraclePixel> oracle =
            evaluate_oracle(input.depth, result.normal, input.camera,
                            unit.parameters.bind<HemisphereSsaoParams>(resolved), kNoiseSeed);
        Comparison comparison;
        for (std::size_t i = 0; i < oracle.size(); ++i) {
            const OraclePixel& pixel = oracle[i];
            const double deviation =
                std::abs(static_cast<double>(result.visibility.values()[i]) - pixel.visibility);
            ++comparison.pixels;
            comparison.occluded += pixel.visibility < 0.95 ? 1 : 0;
            if (pixel.flagged_weight == 0.0) {
                ++comparison.unflagged;
                comparison.largest_unflagged = std::max(comparison.largest_unflagged, deviation);
            }
            comparison.largest_excess =
                std::max(comparison.largest_excess, deviation - pixel.flagged_weight);
        }
        return comparison;
    }

    void expect_equal_in_all_forms(const std::string& name, const std::string& cut,
                                   const DepthImage& input) {
        double smallest_share = 1.0;
        double largest = 0.0;
        for (const char* directions : {"uniform", "cosine"}) {
            for (const char* border : {"open", "clamp"}) {
                for (const char* rotation : {"off", "tile", "pixel"}) {
                    for (const char* bias : {"0", "1"}) {
                        SCOPED_TRACE(std::string(directions) + " " + border + " " + rotation + " " +
                                     bias);
                        const Comparison comparison = compare(input, {{"directions", directions},
                                                                      {"border", border},
                                                                      {"rotation", rotation},
                                                                      {"bias", bias},
                                                                      {"cut", cut}});
                        const double pixels = comparison.pixels;
                        EXPECT_GE(comparison.unflagged / pixels, 0.9);
                        // Far above the rounding of a sum of 512 floats, half of one sample's 1 /
                        // 512.
                        EXPECT_LE(comparison.largest_unflagged, 1e-4);
                        EXPECT_LE(comparison.largest_excess, 1e-4);
                        // There is something to compare.
                        EXPECT_GE(comparison.occluded / pixels, 0.05);
                        smallest_share = std::min(smallest_share, comparison.unflagged / pixels);
                        largest = std::max(largest, comparison.largest_unflagged);
                    }
                }
            }
        }
        RecordProperty(name + "_smallest_unflagged_share", std::to_string(smallest_share));
        RecordProperty(name + "_largest_unflagged_deviation", std::to_string(largest));
    }
};

TEST_F(HemisphereSsaoOracleTest, AStepMatchesTheDoubleEvaluation) {
    expect_equal_in_all_forms("step", "1", make_step_image());
}

TEST_F(HemisphereSsaoOracleTest, ACornerWithSpheresMatchesTheDoubleEvaluation) {
    expect_equal_in_all_forms("corner", "2", make_corner_with_spheres_image());
}

TEST_F(HemisphereSsaoOracleTest, RandomBlocksWithBackgroundMatchTheDoubleEvaluation) {
    expect_equal_in_all_forms("blocks", "1.2", make_random_blocks_image());
}

} // namespace
} // namespace alcove
