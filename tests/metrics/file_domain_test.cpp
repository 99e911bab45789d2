// DESIGN 3.10: EXR and PNG of the same visibility images give the same numbers up to the PNG's
// quantisation.
#include "core/base/image_file.hpp"
#include "metrics/flip/flip.hpp"
#include "metrics/registry.hpp"
#include "metrics/ssim/ssim.hpp"
#include "tests/harness/temporary_folder.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

namespace alcove {
namespace {

class FileDomainTest : public testing::Test {
  protected:
    /// A metric over two visibility images, or two pictures, that went through files: EXR as linear
    /// values, PNG as sRGB codes of them.
    double evaluate(const std::string& name, const Image& test, const Image& reference, bool as_png,
                    std::optional<MetricDomain> wanted = std::nullopt) {
        const Domain linear = test.channels() == 1 ? Domain::visibility : Domain::linear;
        const auto store = [&](const Image& image, const char* file) {
            const std::filesystem::path path =
                m_folder.path() / (std::string(file) + (as_png ? ".png" : ".exr"));
            if (as_png) {
                write_png(path, encode_view(image), Domain::view);
            } else {
                write_exr(path, image, linear);
            }
            return read_image_file(path);
        };
        const ImageFile first = store(test, "test");
        const ImageFile second = store(reference, "reference");
        EXPECT_EQ(first.domain, as_png ? Domain::view : linear);
        EXPECT_EQ(first.domain, second.domain);
        const Registry<MetricUnit> registry = metrics_registry();
        const MetricUnit& unit = registry.find(name);
        const auto metric = unit.create(unit.parameters.resolve({}, {}));
        std::optional<Image> depth;
        if (unit.needs_depth) {
            depth = unit.canary->make_depth(test.size());
        }
        return evaluate_in_domain(unit, *metric,
                                  {first.image, second.image, nullptr, nullptr, nullptr,
                                   depth ? &*depth : nullptr},
                                  first.domain, wanted.value_or(unit.domain))
            .value.value();
    }

  private:
    TemporaryFolder m_folder;
};

Image make_visibility(float phase, float depth, ImageSize size = {64, 48}) {
    Image image(size, 1);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const float wave = std::sin(0.21f * static_cast<float>(x) + phase) *
                               std::cos(0.17f * static_cast<float>(y));
            image.at(x, y) = 1.0f - depth * (0.5f + 0.5f * wave);
        }
    }
    return image;
}

/// Largest error of linear visibility stored as an 8-bit sRGB code: half a step times the steepest
/// slope of the decoding curve, 2.4 / 1.055 at white.
const double kQuantisation = 0.5 / 255.0 * 2.4 / 1.055;

TEST_F(FileDomainTest, NumericMetricsAgreeWithinQuantisation) {
    const Image test = make_visibility(0.0f, 0.8f);
    const Image reference = make_visibility(0.4f, 0.7f);
    const double exr_rmse = evaluate("rmse", test, reference, false);
    const double png_rmse = evaluate("rmse", test, reference, true);
    // Each image is off by at most the quantisation a pixel, so rmse, a norm, by twice that; mse =
    // rmse^2 and psnr = -20 log10(rmse) follow.
    const double bound = 2.0 * kQuantisation;
    ASSERT_GT(exr_rmse, 5.0 * bound);
    EXPECT_NEAR(png_rmse, exr_rmse, bound);
    EXPECT_NEAR(evaluate("mse", test, reference, true), evaluate("mse", test, reference, false),
                bound * (2.0 * exr_rmse + bound));
    EXPECT_NEAR(evaluate("psnr", test, reference, true), evaluate("psnr", test, reference, false),
                -20.0 * std::log10(1.0 - bound / exr_rmse));
    // Rounding errors are independent of the images: what is seen is ten times less than the bound.
    EXPECT_NEAR(png_rmse, exr_rmse, 0.1 * bound);
    // Codes taken for visibility would be off by far more.
    EXPECT_GT(
        std::abs(evaluate("rmse", encode_view(test), encode_view(reference), false) - exr_rmse),
        bound);
}

TEST_F(FileDomainTest, SsimAgreesWithinQuantisation) {
    const Image test = make_visibility(0.0f, 0.8f);
    const Image reference = make_visibility(0.4f, 0.7f);
    const double exr = evaluate("ssim", test, reference, false);
    const double png = evaluate("ssim", test, reference, true);
    ASSERT_LT(exr, 0.95);
    // What is compared is the view: the same as on images that are sRGB-encoded beforehand.
    const MetricUnit unit = ssim_unit();
    const auto metric = unit.create(unit.parameters.resolve({}, {}));
    EXPECT_EQ(exr, metric->evaluate({encode_view(test), encode_view(reference)}).value.value());
    // Rounding to codes adds a variance of (1/255)^2 / 12 = 1.3e-6 to each image. In the second
    // factor that stands beside C2 = 9e-4 or more: 2 x 1.3e-6 / 9e-4 = 0.003 at most; means move by
    // less.
    EXPECT_NEAR(png, exr, 0.003);
}

/// What both files can hold.
Image clamp_values(Image image) {
    for (float& value : image.values()) {
        value = std::clamp(value, 0.0f, 1.0f);
    }
    return image;
}

/// Wide enough for every metric; a metric that has no value on waves looks at its canary. What 8
/// bits may change: the largest error and its 95th percentile by both images' quantisation; the
/// others by what was seen (in brackets) with some room.
TEST_F(FileDomainTest, EveryOtherImageMetricAgreesWithinQuantisation) {
    constexpr ImageSize kWide{192, 180};
    const std::map<std::string, double> bounds{
        {"mae", 2.0 * kQuantisation},
        {"p95_error", 2.0 * kQuantisation},
        {"max_error", 2.0 * kQuantisation},
        {"ms_ssim", 0.003},
        {"gmsd", 0.003},
        {"flip", 0.003},
        {"hdr_flip", 0.01},
        {"gradient_error", 0.001},
        {"flat_noise", 0.001},
        {"banding_energy", 0.001},
        {"halo_width", 0.1},       // pixels (0.05)
        {"false_occlusion", 0.04}, // a share of pixels: those within a code of `least` (0.03)
        {"band_profile", 0.0002},  // (0.00007)
        {"chroma_error", 0.5},     // CIELAB: half a step of a code
        {"energy_ratio", 0.001},   // stops
    };
    const Registry<MetricUnit> registry = metrics_registry();
    for (const MetricUnit& unit : registry.units()) {
        const bool is_elsewhere =
            unit.name == "mse" || unit.name == "rmse" || unit.name == "psnr" || unit.name == "ssim";
        if (unit.is_temporal() || !unit.reported || is_elsewhere) {
            continue;
        }
        ASSERT_TRUE(bounds.contains(unit.name)) << unit.name << " needs a bound";
        const Image reference = unit.canary ? clamp_values(unit.canary->make_reference(kWide))
                                            : make_visibility(0.4f, 0.7f, kWide);
        const Image test = unit.canary ? clamp_values(unit.canary->damage(reference, 0.2f))
                                       : make_visibility(0.0f, 0.8f, kWide);
        const double exr = evaluate(unit.name, test, reference, false);
        const double png = evaluate(unit.name, test, reference, true);
        EXPECT_NEAR(png, exr, bounds.at(unit.name)) << unit.name;
        // Far from the best value, so that the bound says something.
        EXPECT_GT(std::abs(exr - *unit.best), 3.0 * bounds.at(unit.name)) << unit.name;
    }
}

TEST_F(FileDomainTest, CodesAreTakenAsTheyAreStored) {
    const Image test = make_visibility(0.0f, 0.8f);
    const Image reference = make_visibility(0.4f, 0.7f);
    const MetricUnit unit = flip_unit();
    const auto metric = unit.create(unit.parameters.resolve({}, {}));
    // An EXR holds visibility itself, a PNG its view.
    EXPECT_EQ(evaluate("flip", test, reference, false, MetricDomain::codes),
              metric->evaluate({test, reference}).value.value());
    EXPECT_EQ(evaluate("flip", test, reference, true, MetricDomain::codes),
              evaluate("flip", test, reference, true));
    EXPECT_GT(std::abs(evaluate("flip", test, reference, false, MetricDomain::codes) -
                       evaluate("flip", test, reference, false)),
              0.01);
}

} // namespace
} // namespace alcove
