#include "metrics/false_occlusion/false_occlusion.hpp"

#include "metrics/common/pooled_region.hpp"
#include "metrics/common/test_images.hpp"

namespace alcove {
namespace {

struct FalseOcclusionParams {
    double least = 0.01;
};

ParameterTable describe() {
    return describe_parameters("false_occlusion",
                               {real(&FalseOcclusionParams::least, "least")
                                    .range(0.0, 1.0)
                                    .unit("value")
                                    .meaning("How much darker than the reference a pixel is that "
                                             "counts; above quantisation to 8 bits.")
                                    .source("ours")});
}

class FalseOcclusion final : public Metric {
  public:
    explicit FalseOcclusion(const FalseOcclusionParams& params) : m_params(params) {}

    MetricResult evaluate(const MetricInput& input) const override {
        check_metric_input(input, "false_occlusion");
        ALCOVE_ASSERT(input.test.channels() == 1, "luma");
        const PooledRegion region(input.mask, input.test.size());
        MetricResult result;
        region.report(result);
        result.map = Image(input.test.size(), 1);
        std::vector<double> dark(static_cast<std::size_t>(input.test.height()), 0.0);
        std::vector<double> depth = dark;
        for (int y = 0; y < input.test.height(); ++y) {
            for (int x = 0; x < input.test.width(); ++x) {
                const double lack = static_cast<double>(input.reference.at(x, y)) -
                                    static_cast<double>(input.test.at(x, y));
                const bool counts = lack > m_params.least;
                result.map->at(x, y) = counts ? static_cast<float>(lack) : 0.0f;
                if (counts && region.is_counted(x, y)) {
                    dark[static_cast<std::size_t>(y)] += 1.0;
                    depth[static_cast<std::size_t>(y)] += lack;
                }
            }
        }
        if (region.count() > 0) {
            result.value = region.compute_mean(dark);
            result.extras = {{"mean_depth", region.compute_mean(depth)}};
        }
        return result;
    }

  private:
    FalseOcclusionParams m_params;
};

Image make_open(ImageSize size) {
    return {size, 1, 0.9f};
}

/// Darker by up to `amount`, spread evenly.
Image darken(const Image& reference, float amount) {
    Image image = reference;
    for (std::size_t i = 0; i < image.values().size(); ++i) {
        image.values()[i] -= amount * static_cast<float>((i * 37) % 101) / 101.0f;
    }
    return image;
}

} // namespace

MetricUnit false_occlusion_unit() {
    MetricUnit unit;
    unit.name = "false_occlusion";
    unit.title = "False occlusion";
    unit.unit = "share";
    unit.definition = "Ours, on linear values (Rec. 709 luma of colour): the share of pixels with "
                      "reference - test > least. mean_depth: the mean over all pixels of that "
                      "difference, 0 where it does not count.";
    unit.blind_to = "pixels that are too light, and how much too dark the dark ones are.";
    unit.luma = true;
    unit.on_demand = true;
    unit.maximum = 1.0;
    unit.best = 0.0;
    unit.parameters = describe();
    unit.canary = MetricCanary{make_open, darken};
    unit.checks = {
        {"a checkerboard against white", make_checkerboard, [] { return make_constant(255); }, 0.5,
         1e-12, "by hand: every second pixel is black"},
        {"white against a checkerboard", [] { return make_constant(255); }, make_checkerboard, 0.0,
         1e-12, "by hand: nothing is darker"},
        {"one code", [] { return make_constant(127); }, [] { return make_constant(128); }, 0.0,
         1e-12, "by hand: 1 / 255 is less than least"},
    };
    unit.create = [table = unit.parameters](const ResolvedParameters& parameters) {
        return std::make_unique<FalseOcclusion>(table.bind<FalseOcclusionParams>(parameters));
    };
    return unit;
}

} // namespace alcove
