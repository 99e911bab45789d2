#include "methods/ssdo/ssdo.hpp"

#include "methods/common/sample_sets.hpp"
#include "methods/ssao_environment/ssao_environment.hpp"
#include "tests/methods/light_shots.hpp"
#include "tests/methods/traced_light_rig.hpp"
#include "tests/test_scenes.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

constexpr ImageSize kSize{160, 120};

class SsdoTest : public LightShotTest {};

std::size_t count_surface(const LightShot& shot) {
    return static_cast<std::size_t>(
        std::count_if(shot.eye_depth.values().begin(), shot.eye_depth.values().end(),
                      [](float depth) { return std::isfinite(depth); }));
}

glm::vec3 get_pixel_at(const Image& image, std::size_t i) {
    return {image.values()[3 * i], image.values()[3 * i + 1], image.values()[3 * i + 2]};
}

// Ritschel et al. 2009, section 3: with constant light the sum is unoccluded light times
// cosine-weighted visibility of the same samples.
TEST_F(SsdoTest, ConstantLightMakesItCosineWeightedAmbientOcclusion) {
    const auto scene = open_lit_scene("colour_blocks", "", "environment=uniform,sun=0");
    for (const char* blur : {"blur=false", "blur=true"}) {
        const LightShot directional =
            shoot(ssdo_unit(), std::string("bounce=false,") + blur, *scene, kSize);
        const LightShot ambient =
            shoot(ssao_environment_unit(), std::string("weighting=cosine,") + blur, *scene, kSize);
        // RGBA16F: half a unit in the last place of 1 is 2^-12.
        EXPECT_LE(find_largest_difference(directional.radiance, ambient.radiance), 0.001f) << blur;
        // Not because both are white: something is darkened.
        EXPECT_LT(*std::min_element(ambient.visibility.values().begin(),
                                    ambient.visibility.values().end()),
                  0.8f);
    }
}

TEST_F(SsdoTest, AmbientOcclusionOnTopDimsShadowMappedLightToo) {
    const auto scene = open_lit_scene("colour_blocks", "", "environment=sky,shadows=true");
    const LightShot some = shoot(ssao_environment_unit(), "blur=false", *scene, kSize);
    const LightShot all = shoot(ssao_environment_unit(), "blur=false,dimmed=all", *scene, kSize);
    for (std::size_t i = 0; i < all.visibility.values().size(); ++i) {
        const glm::vec3 expected = get_pixel_at(some.radiance, i) +
                                   all.visibility.values()[i] * get_pixel_at(some.direct, i);
        if (std::isfinite(all.eye_depth.values()[i])) {
            // Radiance is kept in half floats.
            ASSERT_NEAR(get_pixel_at(all.radiance, i).y, expected.y, 0.002f + 0.002f * expected.y);
        }
    }
}

TEST_F(SsdoTest, UnoccludedPlaneGetsWhatThePrefilteredMapSays) {
    LitScene scene({make_floor(50.0f, 0.0f)});
    Lights lights;
    lights.environment = std::make_shared<const Environment>(
        [](const glm::dvec3& d) { return glm::vec3(1.2 + d.y + 0.1 * d.x, 1.0, 1.0 - 0.5 * d.x); },
        "test");
    scene.set_lights(lights);
    scene.set_camera(make_camera_above_zero(4.0));
    const LightShot shot = shoot(ssdo_unit(), "bounce=false,radius=0.1", scene, {64, 48});
    // Of a floor: red 1.2 + 2/3, green and blue 1. 0.02: 256 directions in place of the integral.
    const glm::dvec3 mean = compute_average(shot.radiance) / compute_average(shot.albedo);
    EXPECT_NEAR(mean.x, 1.2 + 2.0 / 3.0, 0.02);
    EXPECT_NEAR(mean.y, 1.0, 0.01);
    EXPECT_NEAR(mean.z, 1.0, 0.02);
}

/// Mean chroma |R - B| of incoming light over what it is without occlusion, where visibility is
/// low.
double measure_shadow_chroma(const LightShot& shot, const LightShot& open) {
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < shot.visibility.values().size(); ++i) {
        if (std::isfinite(shot.eye_depth.values()[i]) && shot.visibility.values()[i] < 0.92f) {
            const glm::vec3 ratio = get_pixel_at(shot.radiance, i) / get_pixel_at(open.radiance, i);
            sum += std::abs(ratio.x - ratio.z);
            ++count;
        }
    }
    EXPECT_GT(count, 100);
    return sum / count;
}

TEST_F(SsdoTest, ShadowsUnderTwoColoursHaveColourAndThoseOfAmbientOcclusionHaveNone) {
    const auto scene = open_lit_scene("colour_blocks", "", "environment=two_colour,sun=0");
    const LightShot directional = shoot(ssdo_unit(), "bounce=false", *scene, kSize);
    // What nothing blocks: a reach that is shorter than any gap.
    const LightShot open_directional =
        shoot(ssdo_unit(), "bounce=false,radius=0.0001", *scene, kSize);
    const LightShot ambient = shoot(ssao_environment_unit(), "", *scene, kSize);
    const LightShot open_ambient = shoot(ssao_environment_unit(), "radius=0.0001", *scene, kSize);
    EXPECT_GT(measure_shadow_chroma(directional, open_directional), 0.05);
    EXPECT_LT(measure_shadow_chroma(ambient, open_ambient), 0.01);
}

/// Of colour_blocks.
constexpr glm::vec3 kSun(1.0f, 0.97f, 0.9f);

/// Red minus blue, both against the light's own, that bounces onto pixels whose own albedo is grey,
/// over all of them.
double measure_yellow(const LightShot& with, const LightShot& without) {
    double sum = 0.0;
    for (std::size_t i = 0; i < with.eye_depth.values().size(); ++i) {
        const glm::vec3 albedo = get_pixel_at(with.albedo, i);
        if (std::isfinite(with.eye_depth.values()[i]) && std::abs(albedo.x - albedo.z) < 0.01f) {
            const glm::vec3 bounced =
                get_pixel_at(with.radiance, i) - get_pixel_at(without.radiance, i);
            sum += bounced.x / kSun.x - bounced.z / kSun.z;
        }
    }
    return sum / static_cast<double>(count_surface(with));
}

TEST_F(SsdoTest, YellowLightBouncesOntoTheFloorAndFadesWithoutAJumpAsItsSenderTurnsAway) {
    const auto scene = open_lit_scene("colour_blocks", "walkthrough=turning", "shadows=true");
    std::vector<double> yellow;
    for (int frame = 10; frame <= 110; frame += 5) {
        const LightShot with = shoot(ssdo_unit(), "", *scene, kSize, frame);
        const LightShot without = shoot(ssdo_unit(), "bounce=false", *scene, kSize, frame);
        yellow.push_back(measure_yellow(with, without));
    }
    const double most = *std::max_element(yellow.begin(), yellow.end());
    EXPECT_GT(most, 1e-4);
    EXPECT_LT(std::abs(yellow.back()), 0.2 * most); // what other surfaces tint
    for (std::size_t i = 1; i < yellow.size(); ++i) {
        // 20 steps from all to nothing: a jump would be several of them at once.
        EXPECT_LT(std::abs(yellow[i] - yellow[i - 1]), 0.15 * most) << i;
    }
}

TEST_F(SsdoTest, BounceStrengthScalesTheBounceAndNothingElse) {
    const auto scene = open_lit_scene("colour_blocks", "", "environment=sky,shadows=true");
    const LightShot none = shoot(ssdo_unit(), "bounce=false,blur=false", *scene, kSize);
    const LightShot once = shoot(ssdo_unit(), "blur=false", *scene, kSize);
    const LightShot twice = shoot(ssdo_unit(), "blur=false,bounce_strength=2", *scene, kSize);
    const LightShot zero = shoot(ssdo_unit(), "blur=false,bounce_strength=0", *scene, kSize);
    EXPECT_LE(find_largest_difference(none.radiance, zero.radiance), 0.001f);
    const glm::dvec3 first = compute_average(once.radiance) - compute_average(none.radiance);
    const glm::dvec3 second = compute_average(twice.radiance) - compute_average(none.radiance);
    EXPECT_GT(first.x, 1e-3);
    EXPECT_NEAR(second.x / first.x, 2.0, 0.01);
}

/// A wall with a thin slab hovering before it: from most of the wall's neighbourhood of the slab,
/// points behind the slab are in the open.
std::unique_ptr<LitScene> make_slab_scene() {
    auto scene = std::make_unique<LitScene>(std::vector<Mesh>{
        make_wall(20.0f, -5.0f), make_box({-0.4f, -0.4f, -4.62f}, {0.4f, 0.4f, -4.6f})});
    scene->set_lights(make_surroundings(glm::vec3(1.0f)));
    scene->set_camera(make_forward_camera());
    return scene;
}

/// Root mean square error of visibility against traced visibility, over the wall.
double measure_wall_error(const LightShot& shot, const Image& truth) {
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < truth.values().size(); ++i) {
        if (std::abs(shot.eye_depth.values()[i] - 5.0f) < 0.01f) {
            const double difference = shot.visibility.values()[i] - truth.values()[i];
            sum += difference * difference;
            ++count;
        }
    }
    EXPECT_GT(count, 1000);
    return std::sqrt(sum / count);
}

// Ritschel et al. 2009, figure 5: sample A lies behind a solid and in the open; one layer cannot
// know.
TEST_F(SsdoTest, SecondLayerMendsPointsBehindASolid) {
    const std::unique_ptr<LitScene> owned = make_slab_scene();
    const LitScene& scene = *owned;
    PathSettings settings;
    settings.radius_m = 0.6;
    settings.rays_per_half = 128;
    const Image truth =
        trace_light(scene, make_forward_camera(), scene.get_lights(), settings).visibility;
    const auto measure = [&](const std::string& more) {
        return measure_wall_error(
            shoot(ssdo_unit(), "radius=0.6,bounce=false,fade=0.99," + more, scene, kTracedSize),
            truth);
    };
    const double one = measure("samples=256,blur=false");
    const double two = measure("samples=256,blur=false,layers=2");
    EXPECT_LT(two, 0.7 * one);
}

// Sample B of the same figure misses a blocker that more samples find.
TEST_F(SsdoTest, MoreSamplesFindBlockersThatFewMiss) {
    // A fin of 12 cm, three pixels, that stands on the wall.
    LitScene scene(
        {make_wall(20.0f, -5.0f), make_box({-0.06f, -0.6f, -5.1f}, {0.06f, 0.6f, -4.7f})});
    scene.set_lights(make_surroundings(glm::vec3(1.0f)));
    scene.set_camera(make_forward_camera());
    const auto shoot_with = [&](const std::string& samples) {
        return shoot(ssdo_unit(), "radius=0.6,bounce=false,blur=false," + samples, scene, kSize);
    };
    const Image limit = shoot_with("samples=256").visibility;
    EXPECT_LT(*std::min_element(limit.values().begin(), limit.values().end()), 0.97f);
    const double few = measure_wall_error(shoot_with("samples=4,tile=1"), limit);
    const double many = measure_wall_error(shoot_with("samples=64,tile=1"), limit);
    EXPECT_LT(many, 0.5 * few);
}

/// A pink box close before a wall, hidden behind a white one; the sun shines on its right side.
std::unique_ptr<LitScene> make_hidden_box() {
    auto scene = std::make_unique<LitScene>(std::vector<Mesh>{
        paint(make_wall(2.0f, -6.0f), glm::vec3(0.7f)),
        paint(make_box({-0.5f, -1.0f, -3.5f}, {0.5f, 0.8f, -3.0f}), glm::vec3(0.7f)),
        paint(make_box({-0.85f, -1.0f, -5.95f}, {0.85f, 1.0f, -5.3f}), {0.9f, 0.2f, 0.4f})});
    Lights lights = make_surroundings(glm::vec3(0.2f));
    lights.directional.push_back(
        {glm::normalize(glm::dvec3(1.0, 0.3, 0.4)), glm::vec3(2.0f), true});
    scene->set_lights(lights);
    scene->set_camera(make_forward_camera());
    return scene;
}

/// Of the visible wall on the right of both boxes, within reach of the hidden one.
struct WallSide {
    double visibility = 0.0; ///< mean
    double pink = 0.0;       ///< mean of red minus green of a radiance
};

WallSide measure_wall_side(const Image& visibility, const Image& radiance, const Image& depth) {
    WallSide side;
    int count = 0;
    for (int y = kSize.height / 3; y < 2 * kSize.height / 3; ++y) {
        for (int x = kSize.width / 2; x < kSize.width; ++x) {
            // The pixel's place on the wall: tan 30 degrees up, four thirds of that aside.
            const double aside =
                6.0 * 0.57735 * 4.0 / 3.0 * ((x + 0.5) / (0.5 * kSize.width) - 1.0);
            if (std::abs(depth.at(x, y) - 6.0f) < 0.01f && aside < 1.3) {
                side.visibility += visibility.at(x, y);
                side.pink += radiance.at(x, y, 0) - radiance.at(x, y, 1);
                ++count;
            }
        }
    }
    EXPECT_GT(count, 100);
    return {side.visibility / count, side.pink / count};
}

// Ritschel et al. 2009, figure 7: one view misses the shadow and the light of what it does not see.
TEST_F(SsdoTest, FurtherCamerasBringAHiddenBoxsShadowAndItsPinkLight) {
    const std::unique_ptr<LitScene> scene = make_hidden_box();
    PathSettings settings;
    settings.radius_m = 0.8;
    PathTracer tracer;
    tracer.update(pose_geometry(*scene, 0.0));
    const TracedRadiance traced =
        tracer.trace(make_forward_camera(), kSize, scene->get_lights(), settings);
    const LightShot one = shoot(ssdo_unit(), "radius=0.8", *scene, kSize);
    const LightShot four = shoot(ssdo_unit(), "radius=0.8,views=4", *scene, kSize);
    const WallSide truth =
        measure_wall_side(traced.visibility, compute_mean(traced.indirect), one.eye_depth);
    const WallSide before = measure_wall_side(one.visibility, one.radiance, one.eye_depth);
    const WallSide after = measure_wall_side(four.visibility, four.radiance, one.eye_depth);
    EXPECT_GT(before.visibility, 0.99);
    // Cameras at half the resolution of 160x120 find a part of both.
    EXPECT_LT(after.visibility, before.visibility - 0.2 * (before.visibility - truth.visibility));
    EXPECT_LT(std::abs(before.pink), 0.1 * truth.pink);
    EXPECT_GT(after.pink, 0.2 * truth.pink);
}

} // namespace
} // namespace alcove
