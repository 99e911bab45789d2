// sao against its formula in double precision, with and without the depth pyramid.
#include "methods/sao/sao.hpp"
#include "tests/methods/depth_scenes.hpp"
#include "tests/methods/estimator_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace alcove {
namespace {

/// The pixel of the depth buffer that stands for a place at a level of the pyramid, by the rotated
/// grid, one level after the other.
glm::ivec2 find_level_pixel(glm::ivec2 place, int level, glm::ivec2 size) {
    glm::ivec2 texel(place.x >> level, place.y >> level);
    texel = glm::min(texel, glm::max(glm::ivec2(size.x >> level, size.y >> level), 1) - 1);
    for (int k = 0; k < level; ++k) {
        texel = {2 * texel.x + (texel.y % 2 == 0 ? 1 : 0),
                 2 * texel.y + (texel.x % 2 == 0 ? 1 : 0)};
    }
    return glm::min(texel, size - 1);
}

OracleAnswer evaluate(const OracleImage& image, const OracleImage::Receiver& receiver,
                      const SaoParams& params) {
    OracleAnswer answer;
    const double radius_px =
        0.5 * image.size().y * params.radius / (receiver.depth * image.tangents().y);
    double sum = 0.0;
    for (int i = 0; i < params.samples; ++i) {
        const double share = (i + 0.5) / params.samples;
        const double angle = share * params.turns * 2.0 * std::numbers::pi;
        const double reach = share * radius_px;
        const glm::dvec2 offset(reach * std::cos(angle), reach * std::sin(angle));
        const OracleImage::Place place =
            image.find_place(glm::dvec2(receiver.pixel) + 0.5 + offset);
        const double level_value = std::log2(std::max(reach, 1.0)) - params.first_level_log;
        answer.is_doubtful =
            answer.is_doubtful || place.is_near_edge ||
            (reach > 1.0 && std::abs(level_value - std::round(level_value)) < 1e-4);
        if (!place.is_inside) {
            continue;
        }
        const int level = std::clamp(static_cast<int>(std::floor(level_value)), 0, params.levels);
        const glm::ivec2 pixel = find_level_pixel(place.pixel, level, image.size());
        const double depth = image.get_depth(pixel);
        if (std::isinf(depth)) {
            continue;
        }
        const glm::dvec3 v = (depth * image.get_ray(pixel) - receiver.position) / params.radius;
        const double vv = glm::dot(v, v);
        if (vv < 1.0) {
            sum += std::pow(1.0 - vv, 3.0) *
                   std::max(glm::dot(v, receiver.normal) - params.bias, 0.0) /
                   (vv + params.epsilon);
        }
    }
    answer.visibility = std::clamp(1.0 - params.intensity * 5.0 / params.samples * sum, 0.0, 1.0);
    return answer;
}

class SaoTest : public DepthImageTest {};

TEST_F(SaoTest, EqualsItsFormulaInDoubleAtEveryLevel) {
    const MethodUnit unit = sao_unit();
    for (const char* first_level : {"8", "1", "0"}) {
        for (const DepthImage& input :
             {make_step_image(), make_corner_with_spheres_image(), make_random_blocks_image()}) {
            SCOPED_TRACE(first_level);
            const ResolvedParameters resolved = resolve(unit, "unfiltered",
                                                        {{"radius", "2.5"},
                                                         {"rotation", "off"},
                                                         {"samples", "13"},
                                                         {"intensity", "0.5"},
                                                         {"first_level_log", first_level}});
            const auto params = unit.parameters.bind<SaoParams>(resolved);
            expect_oracle(
                input, run(unit, resolved, input),
                [&params](const OracleImage& image, const OracleImage::Receiver& receiver) {
                    return evaluate(image, receiver, params);
                },
                1e-4);
        }
    }
}

} // namespace
} // namespace alcove
