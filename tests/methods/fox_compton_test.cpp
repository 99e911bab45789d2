// fox_compton against its formula in double precision, and against the method it is shared with.
#include "methods/fox_compton/fox_compton.hpp"
#include "methods/tssao/tssao.hpp"
#include "tests/methods/depth_scenes.hpp"
#include "tests/methods/estimator_oracle.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

OracleAnswer evaluate(const OracleImage& image, const OracleImage::Receiver& receiver,
                      const FoxComptonParams& params) {
    OracleAnswer answer;
    double sum = 0.0;
    for (const glm::vec4& point : make_disc_kernel(params.samples)) {
        const glm::dvec3 q = receiver.position + params.radius * glm::dvec3(point.x, point.y, 0.0);
        const OracleImage::Place place = image.find_place(q);
        answer.is_doubtful = answer.is_doubtful || place.is_near_edge;
        if (!place.is_inside || std::isinf(image.get_depth(place.pixel))) {
            continue;
        }
        const glm::dvec3 hit = image.get_depth(place.pixel) * image.get_ray(place.pixel);
        const glm::dvec3 v = hit - receiver.position;
        const double distance = glm::length(v);
        if (distance == 0.0) {
            continue;
        }
        const double cosine = glm::dot(v, receiver.normal) / distance;
        const double falloff = 1.0 - distance / (params.cut * params.radius);
        answer.is_doubtful = answer.is_doubtful || std::abs(cosine - params.grazing_cosine) < 1e-4;
        if (cosine >= params.grazing_cosine && falloff > 0.0) {
            sum += 2.0 * cosine * falloff;
        }
    }
    answer.visibility = std::clamp(1.0 - sum / params.samples, 0.0, 1.0);
    return answer;
}

class FoxComptonTest : public DepthImageTest {};

TEST_F(FoxComptonTest, EqualsItsFormulaInDouble) {
    const MethodUnit unit = fox_compton_unit();
    for (const DepthImage& input :
         {make_step_image(), make_corner_with_spheres_image(), make_random_blocks_image()}) {
        const ResolvedParameters resolved = resolve(
            unit, "unfiltered", {{"radius", "1.5"}, {"rotation", "off"}, {"samples", "24"}});
        const auto params = unit.parameters.bind<FoxComptonParams>(resolved);
        // Sums of 24 floats of order 1 and reconstructed positions: a few 1e-6.
        expect_oracle(
            input, run(unit, resolved, input),
            [&params](const OracleImage& image, const OracleImage::Receiver& receiver) {
                return evaluate(image, receiver, params);
            },
            2e-5);
    }
}

TEST_F(FoxComptonTest, IsTheSecondEstimatorOfTemporalSsao) {
    const DepthImage input = make_corner_with_spheres_image();
    const MethodUnit alone = fox_compton_unit();
    const MethodUnit temporal = tssao_unit();
    const RigResult a =
        run(alone, resolve(alone, "unfiltered", {{"samples", "480"}, {"rotation", "off"}}), input);
    const RigResult b = run(temporal,
                            resolve(temporal, "reference_480",
                                    {{"estimator", "fox_compton"}, {"rotation_off_conv", "0"}}),
                            input);
    ASSERT_EQ(a.visibility.values().size(), b.visibility.values().size());
    double occlusion = 0.0;
    for (std::size_t i = 0; i < a.visibility.values().size(); ++i) {
        // The same 480 points, summed in another order.
        EXPECT_NEAR(a.visibility.values()[i], b.visibility.values()[i], 1e-5f) << i;
        occlusion = std::max(occlusion, 1.0 - static_cast<double>(a.visibility.values()[i]));
    }
    EXPECT_GT(occlusion, 0.2);
}

} // namespace
} // namespace alcove
