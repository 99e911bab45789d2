#include "scenes/common/lighting.hpp"

#include "core/base/error.hpp"
#include "core/base/image_file.hpp"
#include "tests/harness/temporary_folder.hpp"
#include "tests/test_scenes.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace alcove {
namespace {

std::unique_ptr<Scene> light_boxes(const Lighting& lighting) {
    return relight(std::unique_ptr<Scene>(new TestScene(make_box_scene())), lighting);
}

TEST(Lighting, WithoutAnyWishTheLightIsTheScenesOwn) {
    const TestScene scene = make_box_scene();
    const auto relit = light_boxes({});
    EXPECT_EQ(hash_lights(*relit, 0.5), hash_lights(scene, 0.5));
    EXPECT_EQ(hash_geometry(*relit, 0.5), hash_geometry(scene, 0.5));
    EXPECT_EQ(relit->get_walkthrough().cameras.size(), scene.get_walkthrough().cameras.size());
}

TEST(Lighting, SurroundingsTurnFromZTowardsX) {
    Lighting lighting;
    lighting.params.environment = SurroundingLight::two_colour; // red from +x
    lighting.params.environment_speed = 90.0;
    const auto scene = light_boxes(lighting);
    const auto is_red = [&](double time_s, const glm::dvec3& direction) {
        const glm::vec3 light =
            compute_surrounding_radiance(scene->compute_lights(time_s), direction);
        return light.x > 2.0f * light.z;
    };
    EXPECT_TRUE(is_red(0.0, {1.0, 0.0, 0.0}));
    EXPECT_TRUE(is_red(1.0, {0.0, 0.0, -1.0}));
    EXPECT_TRUE(is_red(2.0, {-1.0, 0.0, 0.0}));
    EXPECT_FALSE(is_red(2.0, {1.0, 0.0, 0.0}));
}

TEST(Lighting, LampShinesWithItsLevelOnTheMiddleAndGoesAround) {
    Lighting lighting;
    lighting.params.lamp = LampKind::spot;
    lighting.params.lamp_level = 3.0;
    lighting.params.lamp_speed = 180.0;
    lighting.params.shadows = true;
    const auto scene = light_boxes(lighting);
    const PointLight before = scene->get_lights().points.at(0);
    const PointLight after = scene->compute_lights(1.0).points.at(0);
    EXPECT_TRUE(before.casts_shadow);
    EXPECT_TRUE(scene->get_lights().directional.at(0).casts_shadow);
    // Half a turn on, at the same height: the middle lies below the midpoint of both places.
    EXPECT_NEAR(before.position.y, after.position.y, 1e-9);
    ASSERT_TRUE(before.cone.has_value());
    const glm::dvec3 midpoint = 0.5 * (before.position + after.position);
    const double elevation = glm::radians(lighting.params.lamp_elevation);
    const double distance =
        0.5 * glm::distance(before.position, after.position) / std::cos(elevation);
    const glm::dvec3 centre = midpoint - glm::dvec3(0.0, distance * std::sin(elevation), 0.0);
    const glm::dvec3 to_lamp = glm::normalize(before.position - centre);
    EXPECT_NEAR(compute_irradiance(before, centre, to_lamp).x, 3.0f, 1e-4f);
    EXPECT_LT(glm::distance(before.cone->direction, -to_lamp), 1e-9);
}

TEST(Lighting, BuiltSurroundingsScaleWithTheirLevel) {
    for (const SurroundingLight kind :
         {SurroundingLight::uniform, SurroundingLight::sky, SurroundingLight::two_colour,
          SurroundingLight::high_frequency}) {
        const Environment once = make_environment(kind, 1.0);
        const Environment twice = make_environment(kind, 2.0);
        EXPECT_GT(once.prefiltered().at(16, 16, 1), 0.1f);
        EXPECT_NEAR(twice.prefiltered().at(16, 16, 1) / once.prefiltered().at(16, 16, 1), 2.0f,
                    1e-4f);
        EXPECT_NE(once.content_hash(), twice.content_hash());
    }
}

TEST(Lighting, FilesAreReadAndWhatIsNoMapIsRefused) {
    const TemporaryFolder folder;
    Lighting lighting;
    lighting.environment_file = folder.path() / "studio.exr";
    write_exr(*lighting.environment_file, Image({64, 32}, 3, 0.75f), Domain::linear);
    const auto scene = light_boxes(lighting);
    EXPECT_NEAR(compute_surrounding_radiance(scene->get_lights(), {0.3, 0.2, -0.4}).y, 0.75f,
                1e-6f);
    write_exr(*lighting.environment_file, Image({32, 32}, 3, 0.75f), Domain::linear);
    EXPECT_THROW(static_cast<void>(light_boxes(lighting)), InputError);
    write_exr(*lighting.environment_file, Image({64, 32}, 3, -1.0f), Domain::linear);
    EXPECT_THROW(static_cast<void>(light_boxes(lighting)), InputError);
}

} // namespace
} // namespace alcove
