// What hemisphere_ssao promises, on depth images whose occlusion is known.
#include "methods/hemisphere_ssao/hemisphere_ssao.hpp"
#include "tests/methods/analytic_occlusion.hpp"
#include "tests/methods/depth_image_rig.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

using Overrides = std::vector<std::pair<std::string, std::string>>;

class HemisphereSsaoTest : public DepthImageTest {
  protected:
    RigResult run_preset(const DepthImage& input, const std::string& preset,
                         const Overrides& overrides = {}) {
        return run(m_unit, resolve(m_unit, preset, overrides), input);
    }
    const MethodUnit m_unit = hemisphere_ssao_unit();
};

double average_columns(const Image& image, int first, int last) {
    double sum = 0.0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = first; x < last; ++x) {
            sum += static_cast<double>(image.at(x, y));
        }
    }
    return sum / (static_cast<double>(last - first) * image.height());
}

double average_rows(const Image& image, int first, int last) {
    double sum = 0.0;
    for (int y = first; y < last; ++y) {
        for (int x = 0; x < image.width(); ++x) {
            sum += static_cast<double>(image.at(x, y));
        }
    }
    return sum / (static_cast<double>(last - first) * image.width());
}

/// A plane through (0, 0, -depth) with this normal, in front of a camera of 60 degrees.
DepthImage make_plane_image(ImageSize size, double depth, const glm::dvec3& normal) {
    DepthImage image = make_wall_image(size, 1.0f);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const glm::dvec3 d = compute_pixel_direction(image.camera, size, {x + 0.5, y + 0.5});
            image.depth.at(x, y) = static_cast<float>(-depth * normal.z / glm::dot(d, normal));
            for (int c = 0; c < 3; ++c) {
                image.normal.at(x, y, c) = static_cast<float>(normal[c]);
            }
        }
    }
    return image;
}

/// A wall at 4 m whose left half is a block that stands out by the reach of 0.8 m and a little: its
/// side wall contains the eye, so that a sample is hidden exactly if it crosses that wall.
constexpr double kStepReach = 0.8;
DepthImage make_side_wall_image(ImageSize size) {
    DepthImage image = make_wall_image(size, 4.0f);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width / 2; ++x) {
            image.depth.at(x, y) = static_cast<float>(4.0 - 1.01 * kStepReach);
        }
    }
    return image;
}

TEST_F(HemisphereSsaoTest, AReceiverAtTheBottomOfAPitIsBlockedInBothForms) {
    // One pixel at 5 m, all others at 1.5 m, farther before it than any sample reaches and within
    // the cut of 6 m. What stays open are samples over the pixel itself: about twice its half width
    // of 0.015 m over the reach of 3 m, 1 %.
    const ImageSize size{384, 288};
    DepthImage image = make_wall_image(size, 1.5f);
    image.camera.fov_y_radians = 80.0 * std::numbers::pi / 180.0;
    image.depth.at(192, 144) = 5.0f;
    for (const char* directions : {"uniform", "cosine"}) {
        const RigResult result =
            run_preset(image, "converged", {{"radius", "3"}, {"directions", directions}});
        EXPECT_LT(result.visibility.at(192, 144), 0.02f) << directions;
        // Its neighbours see nothing before them.
        EXPECT_EQ(result.visibility.at(250, 100), 1.0f) << directions;
    }
}

TEST_F(HemisphereSsaoTest, AnOpenPlaneIsOpenInBothFormsAtAnyTilt) {
    for (const double degrees : {0.0, 40.0, 70.0}) {
        const double tilt = degrees * std::numbers::pi / 180.0;
        // A normal that half floats hold to 2^-11 tilts the plane by that much: less than a sample
        // in 512.
        const DepthImage image = make_plane_image(
            {96, 72}, 5.0, {0.6 * std::sin(tilt), 0.8 * std::sin(tilt), std::cos(tilt)});
        for (const char* directions : {"uniform", "cosine"}) {
            const RigResult result = run_preset(image, "converged", {{"directions", directions}});
            EXPECT_NEAR(average_rows(result.visibility, 0, 72), 1.0, 1.0 / 255.0)
                << degrees << directions;
        }
    }
}

TEST_F(HemisphereSsaoTest, StepLengthsGiveLinearFalloff) {
    // Before the side wall occlusion is that of a corner with linear falloff. 512 Halton points
    // estimate it within about 0.01 at worst; quadratic falloff would be off by 0.08 at a quarter
    // of the reach.
    const ImageSize size{192, 144};
    const DepthImage image = make_side_wall_image(size);
    const double pixel_m = 2.0 * compute_tangents(image.camera, size).x * 4.0 / size.width;
    for (const char* directions : {"uniform", "cosine"}) {
        const RigResult result = run_preset(
            image, "converged", {{"radius", "0.8"}, {"directions", directions}, {"bias", "0"}});
        double largest = 0.0;
        int receivers = 0;
        for (int x = size.width / 2; (x + 0.5 - size.width / 2) * pixel_m < kStepReach; ++x) {
            const double k = (x + 0.5 - size.width / 2) * pixel_m / kStepReach;
            const double expected =
                1.0 - integrate_wall_occlusion(k, Falloff::linear, Weighting::cosine);
            // Mean over rows that see no border: each row turns the kernel by its own noise.
            double sum = 0.0;
            for (int y = 48; y < 96; ++y) {
                sum += static_cast<double>(result.visibility.at(x, y)) / 48.0;
            }
            largest = std::max(largest, std::abs(sum - expected));
            ++receivers;
        }
        EXPECT_GE(receivers, 20);
        RecordProperty(std::string("linear_falloff_largest_deviation_") + directions,
                       std::to_string(largest));
        EXPECT_LT(largest, 0.01) << directions;
    }
}

TEST_F(HemisphereSsaoTest, TheCutLetsFarSurfacesGo) {
    // The block's front is 0.81 m before the receiver: within 2 r, beyond 1 r.
    const DepthImage image = make_side_wall_image({96, 72});
    const Overrides base{{"radius", "0.8"}};
    Overrides tight = base;
    tight.push_back({"cut", "1"});
    EXPECT_LT(run_preset(image, "converged", base).visibility.at(48, 36), 0.75f);
    EXPECT_EQ(run_preset(image, "converged", tight).visibility.at(48, 36), 1.0f);
}

TEST_F(HemisphereSsaoTest, ZeroNormalsAndBackgroundNeverGiveNan) {
    DepthImage image = make_side_wall_image({48, 36});
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
    for (const char* border : {"open", "clamp"}) {
        for (const char* preset : {"default", "strong_blur", "paper_weak_blur", "converged"}) {
            const RigResult result = run_preset(image, preset, {{"border", border}});
            for (int y = 0; y < 36; ++y) {
                for (int x = 0; x < 48; ++x) {
                    const float value = result.visibility.at(x, y);
                    ASSERT_TRUE(value >= 0.0f && value <= 1.0f) << preset << " " << x << " " << y;
                    if (std::isinf(image.depth.at(x, y))) {
                        ASSERT_EQ(value, 1.0f);
                    }
                }
            }
        }
    }
}

TEST_F(HemisphereSsaoTest, SamplesOutsideTheImageNeverBlockWithAnOpenBorder) {
    // A floor that leaves the image at the top: farther away, so that the clamped texel lies before
    // it.
    const double tilt = 45.0 * std::numbers::pi / 180.0;
    const DepthImage image = make_plane_image({96, 72}, 3.0, {0.0, std::sin(tilt), std::cos(tilt)});
    const auto measure_seam = [&](const char* border) {
        const Image visibility =
            run_preset(image, "converged", {{"border", border}, {"radius", "2"}}).visibility;
        return average_rows(visibility, 30, 42) - average_rows(visibility, 0, 2);
    };
    EXPECT_NEAR(measure_seam("open"), 0.0, 1.0 / 255.0);
    EXPECT_GT(measure_seam("clamp"), 0.02);
}

TEST_F(HemisphereSsaoTest, AWeakBlurKeepsAStepThatAStrongOneBlursOver) {
    const DepthImage image = make_side_wall_image({96, 72});
    // Open block on the left, dark wall on the right: the difference of the two columns at the
    // edge.
    const auto measure_step = [&](const char* preset, const Overrides& more) {
        Overrides overrides{{"radius", "1.6"}, {"samples", "64"}};
        overrides.insert(overrides.end(), more.begin(), more.end());
        const Image visibility = run_preset(image, preset, overrides).visibility;
        return average_columns(visibility, 47, 48) - average_columns(visibility, 48, 49);
    };
    const double raw = measure_step("default", {{"blur_radius", "0"}});
    const double weak = measure_step("default", {});
    const double strong = measure_step("strong_blur", {});
    RecordProperty("step_raw", std::to_string(raw));
    RecordProperty("step_weak", std::to_string(weak));
    RecordProperty("step_strong", std::to_string(strong));
    EXPECT_GT(raw, 0.2);
    // Blurred along the wall the edge column meets lighter ones, but nothing of the block.
    EXPECT_GT(weak, 0.8 * raw);
    EXPECT_LT(strong, 0.6 * raw);
    const double paper_weak = measure_step("paper_weak_blur", {});
    const double paper_strong = measure_step("paper_strong_blur", {});
    EXPECT_GT(paper_weak, paper_strong + 0.05);
}

TEST_F(HemisphereSsaoTest, TheBlurSmoothsNoiseAndIsOffAtRadiusZero) {
    const DepthImage image = make_side_wall_image({96, 72});
    const RigResult raw = run_preset(image, "default", {{"radius", "0.8"}, {"blur_radius", "0"}});
    const RigResult blurred = run_preset(image, "default", {{"radius", "0.8"}});
    EXPECT_EQ(raw.passes, std::vector<std::string>{"hemisphere_ssao/occlusion"});
    EXPECT_EQ(blurred.passes,
              (std::vector<std::string>{"hemisphere_ssao/occlusion", "hemisphere_ssao/blur_x",
                                        "hemisphere_ssao/blur_y"}));
    // Raw occlusion of 16 equal samples is a multiple of 1/16; blurred it is not.
    const auto count_sixteenths = [](const Image& visibility) {
        return std::count_if(
            visibility.values().begin(), visibility.values().end(),
            [](float value) { return value * 16.0f == std::round(value * 16.0f); });
    };
    EXPECT_EQ(count_sixteenths(raw.visibility), 96 * 72);
    // Scatter down the column beside the edge, where truth is constant.
    const auto measure_scatter = [](const Image& visibility) {
        double sum = 0.0;
        double squares = 0.0;
        for (int y = 20; y < 52; ++y) {
            const auto value = static_cast<double>(visibility.at(50, y));
            sum += value / 32.0;
            squares += value * value / 32.0;
        }
        return std::sqrt(squares - sum * sum);
    };
    EXPECT_GT(measure_scatter(raw.visibility), 0.02);
    EXPECT_LT(measure_scatter(blurred.visibility), 0.5 * measure_scatter(raw.visibility));
}

TEST_F(HemisphereSsaoTest, MapsTheRadiusAndSaysWhatItCannotDo) {
    const auto map = [&](const Target& target) { return m_unit.map_target(target); };
    const Target whole{0.7, Falloff::linear, Weighting::cosine, Normals::shading};
    const TargetMapping mapped = map(whole);
    EXPECT_TRUE(mapped.reason.empty()) << mapped.reason;
    const ResolvedParameters resolved =
        m_unit.parameters.resolve(mapped.overrides, {{"scene_radius", 0.5}});
    EXPECT_EQ(std::get<double>(resolved.get("radius")), 0.7);
    const auto expect_reason = [&](Target target, const std::string& word) {
        const TargetMapping mapping = map(target);
        EXPECT_NE(mapping.reason.find(word), std::string::npos) << mapping.reason;
        // The radius is mapped all the same.
        EXPECT_EQ(mapping.overrides.size(), 1u);
    };
    expect_reason({0.7, Falloff::none, Weighting::cosine, Normals::shading}, "falloff none");
    expect_reason({0.7, Falloff::quadratic, Weighting::cosine, Normals::shading},
                  "falloff quadratic");
    expect_reason({0.7, Falloff::linear, Weighting::uniform, Normals::shading}, "uniform");
    expect_reason({0.7, Falloff::linear, Weighting::cosine, Normals::geometric}, "geometric");
    const Target none_of_it{0.7, Falloff::none, Weighting::uniform, Normals::geometric};
    for (const char* word : {"falloff none", "uniform", "geometric"}) {
        expect_reason(none_of_it, word);
    }
}

TEST(HemisphereKernel, DirectionsAreUnitAndDistributedAsTheyAreCalled) {
    // Moments of 512 Halton points: their discrepancy allows about 0.005.
    constexpr double kTolerance = 0.006;
    for (const KernelDirections directions :
         {KernelDirections::uniform, KernelDirections::cosine}) {
        const bool is_cosine = directions == KernelDirections::cosine;
        const std::vector<glm::vec4> kernel = make_hemisphere_kernel(512, directions);
        ASSERT_EQ(kernel.size(), 512u);
        glm::dvec3 mean(0.0);
        glm::dvec3 squares(0.0);
        double weight = 0.0;
        for (const glm::vec4& sample : kernel) {
            const glm::dvec3 d(sample);
            EXPECT_NEAR(glm::length(d), 1.0, 1e-6);
            EXPECT_GT(d.z, 0.0);
            mean += d / 512.0;
            squares += d * d / 512.0;
            weight += (is_cosine ? 1.0 : 2.0 * d.z) / 512.0;
        }
        EXPECT_NEAR(mean.x, 0.0, kTolerance);
        EXPECT_NEAR(mean.y, 0.0, kTolerance);
        EXPECT_NEAR(mean.z, is_cosine ? 2.0 / 3.0 : 0.5, kTolerance);
        EXPECT_NEAR(squares.x, is_cosine ? 0.25 : 1.0 / 3.0, kTolerance);
        EXPECT_NEAR(squares.y, is_cosine ? 0.25 : 1.0 / 3.0, kTolerance);
        EXPECT_NEAR(squares.z, is_cosine ? 0.5 : 1.0 / 3.0, kTolerance);
        // Both forms block a closed hemisphere wholly.
        EXPECT_NEAR(weight, 1.0, kTolerance);
    }
}

TEST(HemisphereKernel, StepLengthsAreUniformAndIndependentOfElevation) {
    const std::vector<glm::vec4> kernel = make_hemisphere_kernel(500, KernelDirections::cosine);
    // 500 points of base 5 are four whole periods of 125: every fifth of [0,1) holds a hundred, but
    // for the point at 0 that indices from 1 leave out and one at the end bring in.
    std::vector<int> counts(5, 0);
    double covariance = 0.0;
    for (const glm::vec4& sample : kernel) {
        ASSERT_TRUE(sample.w > 0.0f && sample.w < 1.0f);
        ++counts.at(static_cast<std::size_t>(sample.w * 5.0f));
        const double elevation = static_cast<double>(sample.z * sample.z) - 0.5;
        covariance += elevation * (static_cast<double>(sample.w) - 0.5) / 500.0;
    }
    for (const int count : counts) {
        EXPECT_NEAR(count, 100, 1);
    }
    // Independent uniforms give 0; 500 random ones would scatter by 1/12/sqrt(500) = 0.004.
    EXPECT_NEAR(covariance, 0.0, 0.004);
}

} // namespace
} // namespace alcove
