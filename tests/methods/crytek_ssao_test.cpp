// What crytek_ssao promises, on depth images whose occlusion is known.
#include "methods/crytek_ssao/crytek_ssao.hpp"
#include "tests/methods/analytic_occlusion.hpp"
#include "tests/methods/depth_image_rig.hpp"

#include <algorithm>
#include <cmath>

namespace alcove {
namespace {

using Overrides = std::vector<std::pair<std::string, std::string>>;
constexpr double kReach = 0.8;
const char* const kKernels[] = {"sphere", "sphere_reflected", "hemisphere_gram_schmidt",
                                "hemisphere_frame"};

class CrytekSsaoTest : public DepthImageTest {
  protected:
    RigResult run_preset(const DepthImage& input, const std::string& preset,
                         const Overrides& overrides = {}) {
        return run(m_unit, resolve(m_unit, preset, overrides), input);
    }
    const MethodUnit m_unit = crytek_ssao_unit();
};

double average(const Image& image, int first_column, int last_column, int first_row, int last_row) {
    double sum = 0.0;
    for (int y = first_row; y < last_row; ++y) {
        for (int x = first_column; x < last_column; ++x) {
            sum += static_cast<double>(image.at(x, y));
        }
    }
    return sum / (static_cast<double>(last_column - first_column) * (last_row - first_row));
}

/// A wall at 4 m whose left half is a block that stands out by `height_m`: its side contains the
/// eye, so that a sample is hidden exactly if it crosses that side.
DepthImage make_block_image(ImageSize size, double height_m = 1.01 * kReach) {
    DepthImage image = make_wall_image(size, 4.0f);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width / 2; ++x) {
            image.depth.at(x, y) = static_cast<float>(4.0 - height_m);
        }
    }
    return image;
}

TEST_F(CrytekSsaoTest, EveryKernelConvergesToTheCornerWithLinearFalloff) {
    const ImageSize size{192, 144};
    const DepthImage image = make_block_image(size);
    const double pixel_m = 2.0 * compute_tangents(image.camera, size).x * 4.0 / size.width;
    for (const char* kernel : kKernels) {
        const RigResult result = run_preset(image, "converged",
                                            {{"radius", "0.8"},
                                             {"kernel", kernel},
                                             {"min_cosine", "0"},
                                             {"range", "4"},
                                             {"bias", "0"}});
        double largest = 0.0;
        int receivers = 0;
        for (int x = size.width / 2; (x + 0.5 - size.width / 2) * pixel_m < kReach; ++x) {
            const double k = (x + 0.5 - size.width / 2) * pixel_m / kReach;
            const double expected =
                1.0 - integrate_wall_occlusion(k, Falloff::linear, Weighting::cosine);
            largest = std::max(largest,
                               std::abs(average(result.visibility, x, x + 1, 48, 96) - expected));
            ++receivers;
        }
        EXPECT_GE(receivers, 20);
        RecordProperty(std::string("largest_deviation_") + kernel, std::to_string(largest));
        // 512 points, 48 rows; quadratic falloff would be off by 0.08 at a quarter of the reach.
        EXPECT_LT(largest, 0.015) << kernel;
    }
}

TEST_F(CrytekSsaoTest, TheWholeSphereIsHalfHiddenByAPlaneUnlessItIsNormalised) {
    const DepthImage image = make_wall_image({64, 48}, 4.0f);
    const auto measure = [&](const char* normalise) {
        return average(run_preset(image, "mittring", {{"normalise", normalise}}).visibility, 8, 56,
                       8, 40);
    };
    EXPECT_NEAR(measure("false"), 0.5, 1.0 / 255.0);
    EXPECT_NEAR(measure("true"), 1.0, 1.0 / 255.0);
}

TEST_F(CrytekSsaoTest, OccludersFarBeforeASampleBlockOnlyWithoutTheRangeCheck) {
    // A block 3 m before the wall: six radii of 0.5 m.
    const DepthImage image = make_block_image({96, 72}, 3.0);
    const auto measure = [&](const char* range) {
        return average(run_preset(image, "unfiltered", {{"range", range}}).visibility, 48, 50, 8,
                       64);
    };
    EXPECT_EQ(measure("1"), 1.0);
    EXPECT_LT(measure("10"), 0.9);
    EXPECT_EQ(measure("10"), measure("inf"));
}

TEST_F(CrytekSsaoTest, FiveSamplesSweepFiveConesAndFiveBands) {
    // A sample of cosine z and length s reaches s sqrt(1 - z^2) towards the block's side; there its
    // share of angles begins to rise, with an infinite slope. These five reaches lie 0.04 r apart
    // at least.
    const ImageSize size{256, 768};
    const DepthImage image = make_block_image(size);
    const Overrides cones{{"radius", "0.8"}, {"weighting", "cosine"}, {"min_cosine", "0"},
                          {"range", "4"},    {"samples", "5"},        {"bias", "0"}};
    Overrides decoupled = cones;
    decoupled.push_back({"indexing", "decoupled"});
    const int first = size.width / 2;
    constexpr int kSeeds = 24; // with 768 rows: a deviation of about 0.0015 a column
    const auto measure_profile = [&](const Overrides& settings) {
        std::vector<double> profile(120, 0.0);
        for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
            const Image visibility =
                run(m_unit, resolve(m_unit, "blog_cones", settings), image, seed).visibility;
            for (int x = 0; x < 120; ++x) {
                profile.at(static_cast<std::size_t>(x)) +=
                    average(visibility, first + x, first + x + 1, 0, size.height) / kSeeds;
            }
        }
        return profile;
    };
    // All samples' reaches in pixels, by the kernel itself.
    const auto params =
        m_unit.parameters.bind<CrytekSsaoParams>(resolve(m_unit, "blog_cones", cones));
    const double pixel_m = 2.0 * compute_tangents(image.camera, size).x * 4.0 / size.width;
    std::vector<double> reaches;
    for (const glm::vec4& point : make_crytek_kernel(params)) {
        const auto z = static_cast<double>(point.z);
        reaches.push_back(static_cast<double>(point.w) * std::sqrt(1.0 - z * z) * kReach / pixel_m);
    }
    ASSERT_EQ(reaches.size(), 5u);
    // How much more visibility rises over the two columns inside a reach than outside.
    const auto measure_steps = [&](const std::vector<double>& profile) {
        std::vector<double> steps;
        for (const double reach : reaches) {
            const auto at = static_cast<std::size_t>(std::round(reach)); // the first outside
            steps.push_back((profile.at(at) - profile.at(at - 2)) -
                            (profile.at(at + 2) - profile.at(at)));
        }
        return steps;
    };
    const std::vector<double> with_cones = measure_steps(measure_profile(cones));
    const std::vector<double> without = measure_steps(measure_profile(decoupled));
    double sum = 0.0;
    double sum_without = 0.0;
    for (std::size_t i = 0; i < reaches.size(); ++i) {
        RecordProperty("step_at_" + std::to_string(reaches[i]),
                       std::to_string(with_cones[i]) + " decoupled " + std::to_string(without[i]));
        EXPECT_GT(with_cones[i], 0.006) << "the reach of " << reaches[i] << " pixels";
        sum += with_cones[i];
        sum_without += std::abs(without[i]);
    }
    EXPECT_LT(sum_without, 0.5 * sum);
}

TEST_F(CrytekSsaoTest, HalfResolutionIsTheFullOneAwayFromEdges) {
    for (const ImageSize size : {ImageSize{97, 73}, ImageSize{96, 72}}) {
        const DepthImage image = make_block_image(size);
        const Overrides base{{"radius", "0.8"}, {"samples", "64"}};
        Overrides half = base;
        half.push_back({"resolution", "half"});
        const RigResult full_result = run_preset(image, "default", base);
        const RigResult half_result = run_preset(image, "default", half);
        EXPECT_EQ(half_result.passes,
                  (std::vector<std::string>{"crytek_ssao/downsample", "crytek_ssao/occlusion",
                                            "crytek_ssao/upsample"}));
        // A window of 8 pixels is cut off at the crease.
        for (int x = size.width / 2 + 8; x < size.width - 8; x += 4) {
            EXPECT_NEAR(average(half_result.visibility, x, x + 4, 16, 56),
                        average(full_result.visibility, x, x + 4, 16, 56), 0.015)
                << x;
        }
        // The block's top is open up to its edge.
        EXPECT_NEAR(average(half_result.visibility, size.width / 2 - 2, size.width / 2, 8, 64), 1.0,
                    0.005);
    }
}

TEST_F(CrytekSsaoTest, ZeroNormalsAndBackgroundNeverGiveNan) {
    DepthImage image = make_block_image({48, 36});
    for (int y = 0; y < 36; ++y) {
        for (int x = 0; x < 48; ++x) {
            if ((x + y) % 3 == 0) {
                image.normal.at(x, y, 2) = 0.0f;
            }
            if ((x + y) % 7 == 0) {
                image.depth.at(x, y) = INFINITY;
            }
        }
    }
    for (const Preset& preset : m_unit.presets) {
        for (const char* kernel :
             preset.name == "converged" ? std::span(kKernels, 1) : std::span(kKernels)) {
            const RigResult result = run_preset(image, preset.name, {{"kernel", kernel}});
            for (int y = 0; y < 36; ++y) {
                for (int x = 0; x < 48; ++x) {
                    const float value = result.visibility.at(x, y);
                    ASSERT_TRUE(value >= 0.0f && value <= 1.0f)
                        << preset.name << " " << kernel << " " << x << " " << y;
                    if (std::isinf(image.depth.at(x, y))) {
                        ASSERT_EQ(value, 1.0f);
                    }
                }
            }
        }
    }
}

TEST_F(CrytekSsaoTest, TheBlurTakesOutATileOfRandomVectors) {
    const DepthImage image = make_block_image({96, 72});
    // Scatter down the column beside the edge, where truth is constant.
    const auto measure_scatter = [&](const char* preset, const Overrides& more) {
        Overrides overrides{{"radius", "0.8"}};
        overrides.insert(overrides.end(), more.begin(), more.end());
        const Image visibility = run_preset(image, preset, overrides).visibility;
        double sum = 0.0;
        double squares = 0.0;
        for (int y = 20; y < 52; ++y) {
            const auto value = static_cast<double>(visibility.at(50, y));
            sum += value / 32.0;
            squares += value * value / 32.0;
        }
        return std::sqrt(std::max(0.0, squares - sum * sum));
    };
    const double raw = measure_scatter("unfiltered", {});
    RecordProperty("scatter_unfiltered", std::to_string(raw));
    RecordProperty("scatter_default", std::to_string(measure_scatter("default", {})));
    RecordProperty("scatter_fig14", std::to_string(measure_scatter("paper_fig14", {})));
    EXPECT_GT(raw, 0.02);
    EXPECT_LT(measure_scatter("default", {}), 0.15 * raw);
    EXPECT_LT(measure_scatter("paper_fig14", {}), 0.15 * raw);
}

TEST_F(CrytekSsaoTest, MapsRadiusAndWeightingAndSaysWhatItCannotDo) {
    for (const Weighting weighting : {Weighting::uniform, Weighting::cosine}) {
        const TargetMapping mapping =
            m_unit.map_target({0.7, Falloff::linear, weighting, Normals::shading});
        EXPECT_TRUE(mapping.reason.empty()) << mapping.reason;
        const ResolvedParameters resolved =
            m_unit.parameters.resolve(mapping.overrides, {{"scene_radius", 0.5}});
        EXPECT_EQ(std::get<double>(resolved.get("radius")), 0.7);
        EXPECT_EQ(std::get<std::string>(resolved.get("weighting")), to_text(weighting));
    }
    const TargetMapping none =
        m_unit.map_target({0.7, Falloff::none, Weighting::uniform, Normals::geometric});
    EXPECT_NE(none.reason.find("falloff none"), std::string::npos);
    EXPECT_NE(none.reason.find("geometric"), std::string::npos);
    EXPECT_EQ(none.reason.find("uniform asked for"), std::string::npos);
}

} // namespace
} // namespace alcove
