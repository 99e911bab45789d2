// constant: the mean that ray tracing finds on the surfaces of the frame.
#include "methods/constant/constant.hpp"
#include "methods/reference_ray_traced/reference_ray_traced.hpp"
#include "tests/contract/method_shot.hpp"
#include "tests/core/gl/test_context.hpp"
#include "tests/test_scenes.hpp"

#include <algorithm>

namespace alcove {
namespace {

using ConstantTest = GlTest;

TEST_F(ConstantTest, IsTheReferencesMeanOverSurfaces) {
    const TestScene scene = make_box_scene();
    const ShotSettings settings{{128, 96}, {1}, nullptr};
    const auto shoot_unit = [&](const MethodUnit& unit) {
        const auto method =
            unit.create(context(), unit.parameters.resolve({}, {{"scene_radius", 0.5}}));
        return shoot(context(), *method, scene, settings).visibility;
    };
    const Image constant = shoot_unit(constant_unit());
    const Image reference = shoot_unit(reference_ray_traced_unit());
    const float value = *std::min_element(constant.values().begin(), constant.values().end());
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < constant.values().size(); ++i) {
        if (constant.values()[i] == value) {
            sum += static_cast<double>(reference.values()[i]);
            ++count;
        } else {
            EXPECT_EQ(constant.values()[i], 1.0f);
            EXPECT_EQ(reference.values()[i], 1.0f);
        }
    }
    ASSERT_GT(count, 1000);
    // A grid of 64 x 48 pixels against 128 x 96, 32 rays against 128.
    EXPECT_NEAR(value, sum / count, 0.004);
    EXPECT_LT(value, 0.99f);
}

} // namespace
} // namespace alcove
