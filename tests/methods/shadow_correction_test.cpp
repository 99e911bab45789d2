#include "methods/shadow_correction/shadow_correction.hpp"

#include "methods/common/energy_runs.hpp"
#include "methods/shadow_correction/environment_lights.hpp"
#include "tests/methods/light_shots.hpp"
#include "tests/methods/shadow_rates.hpp"
#include "tests/methods/traced_light_rig.hpp"
#include "tests/test_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

constexpr ImageSize kSize{160, 120};

class ShadowCorrectionTest : public LightShotTest {
  protected:
    /// Of the only light of a scene with black surroundings.
    static ShadowRates measure(const Scene& scene, const std::string& settings,
                               ImageSize size = kSize) {
        return compare_shadows(shoot(shadow_correction_unit(), settings, scene, size).visibility,
                               trace_shadows(scene, size));
    }
};

Lights make_sun(const glm::dvec3& to_light) {
    Lights lights = make_surroundings(glm::vec3(0.0f));
    lights.directional = {{glm::normalize(to_light), glm::vec3(1.0f), true}};
    return lights;
}

Camera look_at(const glm::dvec3& position, const glm::dvec3& target) {
    return make_look_at_camera(position, target, {0.0, 1.0, 0.0}, std::numbers::pi / 3.0, 0.01,
                               1000.0);
}

// Ritschel et al. 2009, figure 8: with b = p / 2 tan alpha a texel's patch lies just below the
// plane it was drawn from; with less, a part of it stands out and shadows the plane.
TEST_F(ShadowCorrectionTest, BiasPutsATexelsPatchJustBelowAPlaneAtAnySlope) {
    for (const double degrees : {5.0, 30.0, 55.0, 75.0, 85.0}) {
        const double alpha = degrees * std::numbers::pi / 180.0;
        LitScene scene({make_floor(50.0f, 0.0f)});
        // In the plane of the map's up axis: the slope runs along its columns.
        scene.set_lights(make_sun({std::sin(alpha), std::cos(alpha), 0.0}));
        scene.set_camera(look_at({0.3, 8.0, 6.1}, {0.0, 0.0, 0.0}));
        const auto count = [&](const std::string& bias) {
            return measure(scene, "correction=false,bias=" + bias).false_share;
        };
        EXPECT_EQ(count("slope,bias_scale=1.001"), 0.0) << degrees;
        EXPECT_GT(count("slope,bias_scale=0.9"), 0.01) << degrees;
        EXPECT_NEAR(count("none"), 0.5, 0.1) << degrees;
    }
}

TEST_F(ShadowCorrectionTest, BiasHoldsOffTheAxisOfAPointsMap) {
    LitScene scene({make_floor(20.0f, 0.0f), make_wall(20.0f, -5.0f)});
    Lights lights = make_surroundings(glm::vec3(0.0f));
    lights.points = {{{0.7, 2.1, 0.4}, glm::vec3(1.0f), std::nullopt, true}};
    scene.set_lights(lights);
    scene.set_camera(look_at({0.0, 4.0, 6.0}, {0.0, 0.0, -3.0}));
    EXPECT_EQ(measure(scene, "correction=false,bias=slope").false_share, 0.0);
    EXPECT_GT(measure(scene, "correction=false,bias=none").false_share, 0.2);
}

// Ritschel et al. 2009, figure 9.
TEST_F(ShadowCorrectionTest, CorrectionBringsShadowsOfPebblesBackAndBiasTakesFalseOnesAway) {
    const auto scene = open_lit_scene("pebbles", "", "environment=uniform,shadows=true");
    const LitLike lit(*scene, make_sun({0.9, 0.35, 0.3}), 90);
    // Texels of 1 cm: a third of a pebble's height.
    const std::string map = "map_size=400,";
    const ShadowRates none = measure(lit, map + "bias=none,correction=false");
    const ShadowRates bias = measure(lit, map + "bias=slope,correction=false");
    const ShadowRates one = measure(lit, map + "bias=slope,correction_samples=16");
    const ShadowRates two = measure(lit, map + "bias=slope,correction_samples=8,layers=2");
    EXPECT_LT(one.missing_share, 0.7 * bias.missing_share);
    EXPECT_LT(two.missing_share, 0.7 * bias.missing_share);
    EXPECT_LT(one.false_share, 0.25 * none.false_share);
    EXPECT_LT(two.false_share, one.false_share);
    EXPECT_LT(one.missing_share + one.false_share, bias.missing_share + bias.false_share);
    EXPECT_LT(one.missing_share + one.false_share, none.missing_share + none.false_share);
}

// Ritschel et al. 2009, section 5: what no pixel shows casts no shadow.
TEST_F(ShadowCorrectionTest, OccludersBelowAPixelCastNoShadowOnScreen) {
    LitScene scene({make_floor(50.0f, 0.0f), make_box({0.0f, 0.0f, 0.0f}, {0.004f, 0.1f, 0.004f})});
    scene.set_lights(make_sun({0.9, 0.35, 0.3}));
    const auto shoot_from = [&](double distance, const std::string& settings) {
        scene.set_camera(look_at({0.0, 0.6 * distance, 0.8 * distance}, {0.0, 0.0, 0.0}));
        return shoot(shadow_correction_unit(), settings, scene, kSize).visibility;
    };
    const std::string corrected = "maps=false,segment=radius,radius=0.2,correction_samples=64";
    EXPECT_GT(find_largest_difference(shoot_from(0.5, corrected),
                                      shoot_from(0.5, "maps=false,correction=false")),
              0.5f);
    EXPECT_EQ(find_largest_difference(shoot_from(60.0, corrected),
                                      shoot_from(60.0, "maps=false,correction=false")),
              0.0f);
}

TEST_F(ShadowCorrectionTest, WithoutBlockersItIsTheDirectLightOfTheGBuffer) {
    LitScene scene({make_floor(20.0f, 0.0f), make_sphere({0.0f, 0.0f, -2.0f}, 1.0f, 24)});
    Lights lights = make_surroundings(glm::vec3(0.0f));
    lights.directional = {
        {glm::normalize(glm::dvec3(0.3, 1.0, 0.2)), glm::vec3(0.5f, 0.4f, 0.3f), false},
        {glm::normalize(glm::dvec3(-1.0, 0.4, 0.2)), glm::vec3(0.1f, 0.2f, 0.3f), false}};
    lights.points = {
        {{1.0, 2.0, 0.0}, glm::vec3(1.0f, 2.0f, 0.5f), std::nullopt, false},
        {{-1.0, 2.5, 0.0}, glm::vec3(3.0f), SpotCone{{0.0, -1.0, 0.0}, 0.3, 0.7}, false}};
    scene.set_lights(lights);
    scene.set_camera(look_at({0.0, 2.0, 4.0}, {0.0, 0.0, -1.0}));
    const LightShot shot = shoot(shadow_correction_unit(), "", scene, kSize);
    // RGBA16F in [0.5, 1): half a unit in the last place is 2^-12, twice.
    EXPECT_LE(find_largest_difference(shot.radiance, shot.direct), 0.001f);
    EXPECT_GT(compute_average(shot.direct).x, 0.05);
    EXPECT_EQ(std::count(shot.passes.begin(), shot.passes.end(), "shadow_correction/shadow_map"),
              0);
}

TEST_F(ShadowCorrectionTest, PointAndSpotMapsAgreeWithShadowRays) {
    LitScene scene({make_floor(20.0f, 0.0f), make_box({-0.8f, 0.0f, -2.5f}, {-0.2f, 0.9f, -1.9f}),
                    make_box({0.5f, 0.3f, -1.5f}, {0.9f, 0.5f, -1.1f})});
    scene.set_camera(look_at({0.0, 2.5, 3.0}, {0.0, 0.0, -1.5}));
    for (const bool is_spot : {false, true}) {
        Lights lights = make_surroundings(glm::vec3(0.0f));
        lights.points = {{{0.3, 1.6, -1.9}, glm::vec3(1.0f), std::nullopt, true}};
        if (is_spot) {
            lights.points[0].cone = SpotCone{{0.0, -1.0, 0.0}, 0.9, 1.2};
        }
        scene.set_lights(lights);
        const ShadowRates rates = measure(scene, "");
        EXPECT_LT(rates.missing_share + rates.false_share, 0.02) << is_spot;
        EXPECT_GT(rates.shadowed, 250) << is_spot;
    }
}

// Ritschel et al. 2009, figure 6.
TEST_F(ShadowCorrectionTest, ShadowOnScreenFollowsTheRadiusWithOneLayerAndTheBlockerWithTwo) {
    LitScene scene({make_floor(20.0f, 0.0f), make_box({-0.5f, 0.5f, -3.0f}, {0.5f, 0.55f, -2.7f})});
    Lights lights = make_surroundings(glm::vec3(0.0f));
    lights.points = {{{0.4, 2.5, -3.2}, glm::vec3(1.0f), std::nullopt, true}};
    scene.set_lights(lights);
    scene.set_camera(look_at({0.0, 1.6, 0.5}, {0.0, 0.3, -2.8}));
    const Image truth = trace_shadows(scene, kSize);
    const auto rate = [&](const std::string& preset, const std::string& radius) {
        return compare_shadows(shoot(shadow_correction_unit(),
                                     preset + ",correction_samples=256,radius=" + radius, scene,
                                     kSize)
                                   .visibility,
                               truth);
    };
    const std::string segment = "maps=false,segment=radius";
    int last = 0;
    for (const char* radius : {"0.65", "1.1", "2"}) {
        const ShadowRates one = rate(segment, radius);
        EXPECT_GT(one.found, last + 20) << radius;
        last = one.found;
    }
    EXPECT_GT(last, 1.3 * rate(segment, "2").shadowed) << "false shadows behind the board";
    const ShadowRates near = rate(segment + ",layers=2", "1.1");
    const ShadowRates far = rate(segment + ",layers=2", "2");
    EXPECT_NEAR(near.found, far.found, 0.03 * far.shadowed);
    EXPECT_LT(far.missing_share + far.false_share, 0.01);
    EXPECT_GT(far.shadowed, 150);
}

TEST_F(ShadowCorrectionTest, LightsOfTheSurroundingsGiveAnOpenPlaneWhatThePrefilteredMapSays) {
    LitScene scene({make_floor(50.0f, 0.0f)});
    Lights lights;
    lights.environment = std::make_shared<const Environment>(
        [](const glm::dvec3& d) { return glm::vec3(1.2 + d.y + 0.1 * d.x, 1.0, 1.0 - 0.5 * d.x); },
        "test");
    lights.environment_turn_radians = 1.0;
    scene.set_lights(lights);
    scene.set_camera(make_camera_above_zero(4.0));
    const LightShot around = shoot(shadow_correction_unit(), "", scene, {64, 48});
    const glm::dvec3 expected = compute_average(around.radiance);
    // 256 lights: those that stand for texels on both sides of the horizon lose a part.
    for (const auto& [count, error] : {std::pair{"32", 0.05}, {"256", 0.02}, {"1024", 0.01}}) {
        const LightShot shot =
            shoot(shadow_correction_unit(),
                  std::string("bias=slope,environment_map_size=64,environment_lights=") + count,
                  scene, {64, 48});
        const glm::dvec3 mean = compute_average(shot.radiance);
        for (int channel = 0; channel < 3; ++channel) {
            EXPECT_NEAR(mean[channel] / expected[channel], 1.0, error) << count << " " << channel;
        }
    }
}

TEST(EnvironmentLights, KeepTheLightAndShareItOut) {
    Lights lights;
    lights.environment = std::make_shared<const Environment>(
        [](const glm::dvec3& d) { return glm::vec3(d.y > 0.9 ? 5.0 : 0.2, 1.0, 0.5); }, "test");
    const auto around = gather_environment_lights(lights, 64);
    ASSERT_EQ(around.size(), 64u);
    double blue = 0.0;
    double least = 1e9;
    double most = 0.0;
    for (const DirectionalLight& light : around) {
        blue += light.irradiance.z;
        const double luminance = glm::dot(light.irradiance, glm::vec3(0.2126f, 0.7152f, 0.0722f));
        least = std::min(least, luminance);
        most = std::max(most, luminance);
        EXPECT_NEAR(glm::length(light.to_light), 1.0, 1e-12);
    }
    // All around there are 4 pi times a half; 1e-3: solid angles at the texels' centres.
    EXPECT_NEAR(blue, 2.0 * std::numbers::pi, 1e-3 * 2.0 * std::numbers::pi);
    EXPECT_LT(most, 1.3 * least);
}

TEST(EnergyRuns, AreEqualWhereTheyCanBeAndLeaveOutWhatHoldsNothing) {
    const std::vector<double> energies{1.0, 1.0, 0.0, 2.0, 0.0, 4.0};
    EXPECT_EQ(cut_into_runs(energies, 2), (std::vector<std::size_t>{5, 6}));
    EXPECT_EQ(cut_into_runs(energies, 4), (std::vector<std::size_t>{3, 5, 6}));
    EXPECT_TRUE(cut_into_runs(std::vector<double>{0.0, 0.0}, 3).empty());
}

TEST(EnergyRuns, TheCurveVisitsEveryCellOnceInSteps) {
    for (const int side : {1, 4, 16, 12}) {
        std::vector<std::size_t> order = order_along_curve(side);
        int jumps = 0;
        for (std::size_t i = 1; i < order.size(); ++i) {
            const auto x = [side](std::size_t at) { return static_cast<int>(at) % side; };
            const auto y = [side](std::size_t at) { return static_cast<int>(at) / side; };
            const int step =
                std::abs(x(order[i]) - x(order[i - 1])) + std::abs(y(order[i]) - y(order[i - 1]));
            jumps += step > 1 ? 1 : 0;
        }
        EXPECT_LE(jumps, side == 12 ? 4 : 0) << side;
        std::sort(order.begin(), order.end());
        std::vector<std::size_t> all(static_cast<std::size_t>(side) *
                                     static_cast<std::size_t>(side));
        std::iota(all.begin(), all.end(), std::size_t{0});
        EXPECT_EQ(order, all);
    }
}

} // namespace
} // namespace alcove
