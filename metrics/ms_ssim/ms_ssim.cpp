// This work is based on: Wang, Simoncelli, Bovik. Multi-scale structural similarity for image
// quality assessment. 2003.
#include "metrics/ms_ssim/ms_ssim.hpp"

#include "metrics/common/structure.hpp"
#include "metrics/common/test_images.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace alcove {
namespace {

/// alpha_5, beta_j and gamma_j, fine to coarse (Wang et al. 2003, section 3.2).
constexpr std::array<double, 5> kExponents{0.0448, 0.2856, 0.3001, 0.2363, 0.1333};

/// The coarsest scale still holds one window.
constexpr int kSmallestSide = (2 * kStructureRadius + 1) << (kExponents.size() - 1);

enum class LowPass { biorthogonal_9_7, mean_2x2 };

struct MsSsimParams {
    LowPass low_pass = LowPass::biorthogonal_9_7;
};

/// The centre and the taps at distance 1..4 of the 9/7 biorthogonal wavelet's low-pass (Cohen,
/// Daubechies, Feauveau 1992), whose sum is 1.
constexpr std::array<float, 5> kNineSeven{0.602949018f, 0.266864118f, -0.078223267f, -0.016864118f,
                                          0.026748757f};

/// Mirrors a place outside of 0..size - 1 on the border between pixels.
int mirror(int place, int size) {
    return place < 0 ? -1 - place : place >= size ? 2 * size - 1 - place : place;
}

/// Low-passed with 9 x 9 taps around each even place.
Image halve_with_9_7(const Image& image) {
    const auto filter = [](auto&& at, int centre, int size) {
        float sum = kNineSeven[0] * at(centre);
        for (int k = 1; k < static_cast<int>(kNineSeven.size()); ++k) {
            sum += kNineSeven[static_cast<std::size_t>(k)] *
                   (at(mirror(centre - k, size)) + at(mirror(centre + k, size)));
        }
        return sum;
    };
    Image columns({(image.width() + 1) / 2, image.height()}, 1);
    for (int y = 0; y < columns.height(); ++y) {
        for (int x = 0; x < columns.width(); ++x) {
            columns.at(x, y) =
                filter([&](int place) { return image.at(place, y); }, 2 * x, image.width());
        }
    }
    Image half({columns.width(), (image.height() + 1) / 2}, 1);
    for (int y = 0; y < half.height(); ++y) {
        for (int x = 0; x < half.width(); ++x) {
            half.at(x, y) =
                filter([&](int place) { return columns.at(x, place); }, 2 * y, image.height());
        }
    }
    return half;
}

/// Means of 2 x 2 pixels; the last row and column of an odd size are doubled.
Image halve_with_mean(const Image& image) {
    Image half({(image.width() + 1) / 2, (image.height() + 1) / 2}, 1);
    for (int y = 0; y < half.height(); ++y) {
        const int below = std::min(2 * y + 1, image.height() - 1);
        for (int x = 0; x < half.width(); ++x) {
            const int right = std::min(2 * x + 1, image.width() - 1);
            half.at(x, y) = 0.25f * (image.at(2 * x, 2 * y) + image.at(right, 2 * y) +
                                     image.at(2 * x, below) + image.at(right, below));
        }
    }
    return half;
}

class MsSsim final : public Metric {
  public:
    explicit MsSsim(LowPass low_pass) : m_low_pass(low_pass) {}

    MetricResult evaluate(const MetricInput& input) const override {
        check_metric_input(input, "ms_ssim", kSmallestSide);
        ALCOVE_ASSERT(input.test.channels() == 1, "luma");
        MetricResult result;
        make_structure_region(input.mask, input.test.size()).report(result);
        Image test = input.test;
        Image reference = input.reference;
        std::optional<Image> mask;
        if (input.mask != nullptr) {
            mask = *input.mask;
        }
        double product = 1.0;
        int clamped = 0;
        for (std::size_t scale = 0; scale < kExponents.size(); ++scale) {
            const bool is_last = scale + 1 == kExponents.size();
            const PooledRegion region = make_structure_region(mask ? &*mask : nullptr, test.size());
            if (region.count() == 0) {
                result.undefined_reason =
                    "the mask counts no window of scale " + std::to_string(scale + 1);
                return result;
            }
            const double term = compute_structure(
                test, reference, is_last ? StructureTerm::whole : StructureTerm::contrast_structure,
                region, nullptr);
            // A power of a negative number would be NaN.
            clamped += term < 0.0 ? 1 : 0;
            product *= std::pow(std::max(0.0, term), kExponents.at(scale));
            if (!is_last) {
                test = halve(test);
                reference = halve(reference);
                if (mask) {
                    mask = halve_mask(*mask);
                }
            }
        }
        result.value = product;
        result.extras = {{"clamped_scales", static_cast<double>(clamped)}};
        return result;
    }

  private:
    [[nodiscard]] Image halve(const Image& image) const {
        return m_low_pass == LowPass::mean_2x2 ? halve_with_mean(image) : halve_with_9_7(image);
    }

    LowPass m_low_pass;
};

std::vector<MetricCheck> list_checks() {
    // Its kernel is rounded to six digits and its variances are clamped.
    const char* const source = "VMAF's MS-SSIM (9/7 low-pass); another tool: 1e-3";
    constexpr double kAcrossTools = 1e-3;
    const auto wide = [](int code) {
        return [code] { return make_changed_ramp([code](int, int, int) { return code; }); };
    };
    return {
        {"ramp against noise", make_noisy_ramp, make_ramp, 0.955998, kAcrossTools, source},
        {"ramp against ramp + 10",
         [] { return make_changed_ramp([](int code, int, int) { return code + 10; }); }, make_ramp,
         0.999538, kAcrossTools, source},
        {"ramp against half contrast",
         [] { return make_changed_ramp([](int code, int, int) { return 64 + code / 2; }); },
         make_ramp, 0.924173, kAcrossTools, source},
        {"constants 128 and 136", wide(128), wide(136), 0.999755, kAcrossTools, source},
        {"constants 0 and 1", wide(0), wide(1), 0.981111, kAcrossTools, source},
        {"constants 0 and 8", wide(0), wide(8), 0.727806, kAcrossTools, source},
        {"constants 0 and 8, luminance alone", wide(0), wide(8),
         std::pow(1e-4 / (64.0 / (255.0 * 255.0) + 1e-4), 0.1333), 1e-6,
         "by hand: (C1 / (8^2 / 255^2 + C1))^0.1333"},
    };
}

} // namespace

MetricUnit ms_ssim_unit() {
    MetricUnit unit;
    unit.name = "ms_ssim";
    unit.title = "Multi-scale structural similarity";
    unit.unit = "1";
    unit.definition =
        "Wang et al. 2003 on the view (sRGB codes in [0,1]; Rec. 709 luma of colour): five scales, "
        "each low-passed and halved from the one before, ssim's window and constants; product of "
        "the means of c s of scales 1 to 4 and of l c s of scale 5 to the powers 0.0448, 0.2856, "
        "0.3001, 0.2363, 0.1333. A negative mean is set to 0 and counted in the extra "
        "clamped_scales. Low-pass: 9/7 biorthogonal or 2 x 2 mean (low_pass). Sides of 176 or "
        "more.";
    unit.blind_to = "absolute level but for the coarsest scale; where an error lies; thin lines "
                    "that the finest scale's small exponent leaves unheard.";
    unit.direction = Direction::higher_is_better;
    unit.domain = MetricDomain::view;
    unit.luma = true;
    unit.on_demand = true;
    unit.smallest_side = kSmallestSide;
    unit.minimum = 0.0;
    unit.maximum = 1.0;
    unit.best = 1.0;
    unit.parameters = describe_parameters(
        "ms_ssim", {choice(&MsSsimParams::low_pass, "low_pass", {"biorthogonal", "mean"})
                        .meaning("Filter before halving: 9/7 biorthogonal, or means of 2 x 2.")
                        .source("VMAF; Wang et al.'s script")});
    unit.checks = list_checks();
    unit.create = [table = unit.parameters](const ResolvedParameters& resolved) {
        return std::make_unique<MsSsim>(table.bind<MsSsimParams>(resolved).low_pass);
    };
    return unit;
}

} // namespace alcove
