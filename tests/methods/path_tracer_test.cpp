// The path tracer against closed forms of light: surroundings, lights, and one bounce.
#include "methods/common/path_tracer.hpp"

#include "methods/common/ray_tracer.hpp"
#include "tests/methods/analytic_occlusion.hpp"
#include "tests/methods/traced_light_rig.hpp"
#include "tests/test_scenes.hpp"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

namespace alcove {
namespace {

constexpr double kPi = std::numbers::pi;
const glm::vec3 kSky(0.2f, 0.5f, 1.0f);
const glm::vec3 kAlbedo(0.8f, 0.5f, 0.3f);
const glm::vec3 kBlack(0.0f);

void expect_near(const glm::dvec3& value, const glm::dvec3& expected, double tolerance,
                 const char* what) {
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(value[i], expected[i], tolerance) << what << ", channel " << i;
    }
}

PathSettings make_settings(double radius_m, Falloff falloff, PathReach reach = PathReach::near) {
    PathSettings settings;
    settings.radius_m = radius_m;
    settings.falloff = falloff;
    settings.reach = reach;
    settings.seed = 7;
    settings.wants_parts = true;
    return settings;
}

/// A light from a direction that nothing blocks.
Lights make_sun(const glm::dvec3& to_light, const glm::vec3& irradiance, bool casts_shadow) {
    Lights lights = make_surroundings(kBlack);
    lights.directional.push_back({glm::normalize(to_light), irradiance, casts_shadow});
    return lights;
}

// ---- surroundings

TEST(PathTracer, AnOpenSurfaceShowsItsAlbedoTimesUniformSurroundings) {
    const LitScene scene({paint(make_wall(40.0f, -5.0f), kAlbedo)});
    const TracedRadiance traced = trace_light(scene, make_forward_camera(), make_surroundings(kSky),
                                              make_settings(0.5, Falloff::linear));
    for (const Image* image : {&traced.indirect.a, &traced.indirect.b, &traced.environment}) {
        for (int x = 0; x < kTracedSize.width; ++x) {
            // Of 64 equal floats a sum is right within 64 roundings.
            expect_near(get_pixel(*image, x, 20), kAlbedo * kSky, 4e-6, "wall");
        }
    }
    expect_near(compute_average(traced.bounce), glm::dvec3(0.0), 0.0, "bounce");
    expect_near(compute_average(traced.direct), glm::dvec3(0.0), 0.0, "direct");
    EXPECT_EQ(find_largest_difference(traced.visibility, Image(kTracedSize, 1, 1.0f)), 0.0f);
}

TEST(PathTracer, TheBackgroundIsTheSurroundingsAlongThePixelsRay) {
    Lights lights = make_surroundings(kBlack);
    lights.environment = std::make_shared<const Environment>(
        [](const glm::dvec3& d) { return glm::vec3(d.x > 0.0, d.y > 0.0, d.z < 0.0); }, "test");
    // A floor that the camera does not see, so that there is a tree.
    const TracedRadiance traced =
        trace_light(LitScene({make_floor(1.0f, -50.0f)}), make_forward_camera(), lights,
                    make_settings(0.5, Falloff::linear));
    for (const Image& image : {compute_mean(traced.indirect), traced.environment}) {
        expect_near(get_pixel(image, 40, 4), {1.0, 1.0, 1.0}, 0.0, "right above");
        expect_near(get_pixel(image, 4, 4), {0.0, 1.0, 1.0}, 0.0, "left above");
        expect_near(get_pixel(image, 4, 32), {0.0, 0.0, 1.0}, 0.0, "left below");
    }
    EXPECT_EQ(find_largest_difference(traced.visibility, Image(kTracedSize, 1, 1.0f)), 0.0f);
}

TEST(PathTracer, ATiltedSurfaceSeesItsShareOfATwoColouredSky) {
    // Of the cosine-weighted hemisphere around a normal at the angle t to the pole,
    // (1 + cos t) / 2 lie above the horizon.
    const glm::vec3 ground(0.6f, 0.3f, 0.1f);
    Lights lights = make_surroundings(kBlack);
    lights.environment = std::make_shared<const Environment>(
        [&](const glm::dvec3& d) { return d.y > 0.0 ? kSky : ground; }, "test");
    const Image& prefiltered = lights.environment->prefiltered();
    for (const double degrees : {0.0, 35.0, 60.0, 90.0}) {
        const double angle = glm::radians(degrees);
        const glm::dvec3 normal(0.0, std::cos(angle), std::sin(angle));
        const glm::vec3 along(0.0f, static_cast<float>(std::sin(angle)),
                              static_cast<float>(-std::cos(angle)));
        const glm::vec3 across(1.0f, 0.0f, 0.0f);
        const Mesh plane =
            paint(make_quad(-20.0f * across - 20.0f * along, 20.0f * across - 20.0f * along,
                            20.0f * across + 20.0f * along, -20.0f * across + 20.0f * along),
                  kAlbedo);
        const Camera camera = make_look_at_camera(4.0 * normal, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0},
                                                  kPi / 6, 0.1, 100.0);
        const TracedRadiance traced =
            trace_light(LitScene({plane}), camera, lights, make_settings(0.5, Falloff::none));
        const double above = 0.5 * (1.0 + std::cos(angle));
        const glm::dvec3 mean = compute_average(compute_mean(traced.indirect));
        expect_near(mean,
                    glm::dvec3(kAlbedo) *
                        (above * glm::dvec3(kSky) + (1.0 - above) * glm::dvec3(ground)),
                    0.003, "closed form");
        const glm::dvec2 place = encode_octahedral(normal) * double(Environment::kPrefilteredSide);
        // The nearest texel's direction is up to 4 degrees off: 0.03 of the light at the steepest.
        expect_near(mean,
                    kAlbedo * get_pixel(prefiltered, std::min(static_cast<int>(place.x), 31),
                                        std::min(static_cast<int>(place.y), 31)),
                    0.03, "prefiltered map");
    }
}

TEST(PathTracer, TurnedSurroundingsTurnInTheImage) {
    // Light from +x alone, turned from z towards x: a quarter turn takes +x to -z, behind the wall,
    // and three to +z, before it.
    Lights lights = make_surroundings(kBlack);
    lights.environment = std::make_shared<const Environment>(
        [](const glm::dvec3& d) { return d.x > std::abs(d.z) ? glm::vec3(1.0f) : kBlack; }, "test");
    const LitScene scene({paint(make_wall(40.0f, -5.0f), glm::vec3(1.0f))});
    const auto measure = [&](double quarters) {
        lights.environment_turn_radians = quarters * 0.5 * kPi;
        return compute_average(compute_mean(trace_light(scene, make_forward_camera(), lights,
                                                        make_settings(0.5, Falloff::none))
                                                .indirect))
            .x;
    };
    EXPECT_NEAR(measure(1.0), 0.0, 0.003);
    // Azimuths within 45 degrees of the normal bring cos: 2 sin(45 degrees) / 2 of all light.
    EXPECT_NEAR(measure(3.0), std::sqrt(0.5), 0.01);
    EXPECT_NEAR(measure(0.0), 0.5 * (1.0 - std::sqrt(0.5)), 0.01);
}

TEST(PathTracer, NoSurroundingsReachTheInsideOfAClosedBox) {
    const LitScene scene({paint(make_box({-2.0f, -1.5f, -3.0f}, {2.0f, 1.5f, 1.0f}), kAlbedo)});
    for (const PathReach reach : {PathReach::near, PathReach::full}) {
        const TracedRadiance traced =
            trace_light(scene, make_forward_camera(), make_surroundings(kSky),
                        make_settings(10.0, Falloff::none, reach));
        EXPECT_EQ(find_largest_difference(compute_mean(traced.indirect), Image(kTracedSize, 3)),
                  0.0f);
        EXPECT_EQ(find_largest_difference(traced.visibility, Image(kTracedSize, 1)), 0.0f);
    }
}

TEST(PathTracer, VisibilityIsTheRayTracers) {
    // The same rays, weighed alike. Sums over halves are rounded in another order.
    const TestScene scene = make_box_scene();
    const Camera& camera = scene.get_walkthrough().cameras[0];
    RayTracer visible;
    visible.update(pose_geometry(scene, 0.0));
    for (const Falloff falloff : {Falloff::none, Falloff::linear, Falloff::quadratic}) {
        TraceSettings of_rays;
        of_rays.target = {0.5, falloff, Weighting::cosine, Normals::shading};
        of_rays.rays_per_half = 24;
        of_rays.seed = 3;
        const Image expected = compute_mean(visible.trace(camera, kTracedSize, of_rays));
        for (const int bounces : {0, 1}) {
            PathSettings settings = make_settings(0.5, falloff);
            settings.rays_per_half = 24;
            settings.seed = 3;
            settings.bounces = bounces;
            const TracedRadiance traced = trace_light(scene, camera, scene.get_lights(), settings);
            EXPECT_LT(find_largest_difference(traced.visibility, expected), 1e-6f);
        }
    }
}

TEST(PathTracer, SurfacesNeverShineBrighterThanUniformSurroundings) {
    // Each ray brings the surroundings or a sender whose albedo is at most 1: no pixel may exceed
    // albedo x L, and none of a white scene may fall below what is not blocked.
    const TestScene boxes = make_box_scene();
    std::vector<Mesh> white(boxes.get_meshes().begin(), boxes.get_meshes().end());
    for (const glm::vec3& albedo : {glm::vec3(1.0f), kAlbedo}) {
        for (Mesh& mesh : white) {
            mesh = paint(mesh, albedo);
        }
        const TestScene scene(white, boxes.compute_pose(0.0).object_to_world,
                              boxes.get_walkthrough().cameras, 0.5);
        for (const PathReach reach : {PathReach::near, PathReach::full}) {
            const TracedRadiance traced =
                trace_light(scene, scene.get_walkthrough().cameras[0], make_surroundings(kSky),
                            make_settings(0.5, Falloff::linear, reach));
            const glm::dvec3 bounce = compute_average(traced.bounce);
            EXPECT_GT(bounce.z, 5e-4);
            for (int y = 0; y < kTracedSize.height; ++y) {
                for (int x = 0; x < kTracedSize.width; ++x) {
                    const float visible = traced.visibility.at(x, y);
                    const glm::vec3 environment = get_pixel(traced.environment, x, y);
                    const glm::vec3 all = environment + get_pixel(traced.bounce, x, y);
                    const bool is_background = traced.direct.at(x, y, 0) == 0.0f && visible == 1.0f;
                    if (is_background) {
                        continue;
                    }
                    for (int i = 0; i < 3; ++i) {
                        ASSERT_NEAR(environment[i], albedo[i] * kSky[i] * visible, 1e-5f);
                        ASSERT_LE(all[i], albedo[i] * kSky[i] * (1.0f + 1e-5f));
                        ASSERT_LE(all[i],
                                  albedo[i] * kSky[i] * (visible + albedo[i] * (1.0f - visible)) +
                                      1e-5f);
                    }
                }
            }
        }
    }
}

// ---- lights straight on

TEST(PathTracer, APointLightFallsOffAndIsBlocked) {
    // A light 2 m before the wall, a square between them that the camera, nearer to the wall than
    // it, does not see.
    const glm::dvec3 light(0.4, 0.3, -2.5);
    const float half = 0.35f;
    const LitScene scene({paint(make_wall(40.0f, -4.5f), kAlbedo), make_wall(half, -3.0f)});
    const Camera camera = make_look_at_camera({0.0, 0.0, -3.2}, {0.0, 0.0, -4.5}, {0.0, 1.0, 0.0},
                                              kPi / 2.0, 0.1, 1000.0);
    const glm::vec3 intensity(3.0f, 2.0f, 1.0f);
    int shadowed = 0;
    int lit = 0;
    for (const bool casts : {false, true}) {
        Lights lights = make_surroundings(kBlack);
        lights.points.push_back({light, intensity, {}, casts});
        const TracedRadiance traced =
            trace_light(scene, camera, lights, make_settings(0.5, Falloff::none));
        for (int y = 0; y < kTracedSize.height; ++y) {
            for (int x = 0; x < kTracedSize.width; ++x) {
                const glm::dvec3 way =
                    compute_pixel_direction(camera, kTracedSize, {x + 0.5, y + 0.5});
                const glm::dvec3 point = camera.position + 1.3 * way;
                const glm::dvec3 to_light = light - point;
                const glm::dvec3 crossing = point + to_light * (1.5 / to_light.z);
                const double inside = half - std::max(std::abs(crossing.x), std::abs(crossing.y));
                if (casts && std::abs(inside) < 1e-4) {
                    continue;
                }
                const bool is_blocked = casts && inside > 0.0;
                const double distance = glm::length(to_light);
                const double factor =
                    is_blocked ? 0.0 : to_light.z / (distance * distance * distance) / kPi;
                expect_near(get_pixel(traced.direct, x, y),
                            factor * glm::dvec3(kAlbedo * intensity), 1e-5, "wall");
                shadowed += is_blocked ? 1 : 0;
                lit += is_blocked ? 0 : 1;
            }
        }
    }
    EXPECT_GT(shadowed, 100);
    EXPECT_GT(lit, 1000);
}

TEST(PathTracer, ASpotFadesBetweenItsCones) {
    const LitScene scene({paint(make_wall(40.0f, -4.0f), glm::vec3(1.0f))});
    Lights lights = make_surroundings(kBlack);
    const double inner = 0.2;
    const double outer = 0.4;
    lights.points.push_back(
        {{0.0, 0.0, -1.0}, glm::vec3(9.0f), SpotCone{{0.0, 0.0, -1.0}, inner, outer}, true});
    const Camera camera = make_forward_camera();
    const TracedRadiance traced =
        trace_light(scene, camera, lights, make_settings(0.5, Falloff::none));
    std::array<int, 3> regions{};
    for (int y = 0; y < kTracedSize.height; ++y) {
        for (int x = 0; x < kTracedSize.width; ++x) {
            const glm::dvec3 way = compute_pixel_direction(camera, kTracedSize, {x + 0.5, y + 0.5});
            const double off = 4.0 * glm::length(glm::dvec2(way));
            const double distance = std::hypot(off, 3.0);
            const double cosine = 3.0 / distance;
            const double open =
                std::min(1.0, std::max(0.0, (cosine - std::cos(outer)) /
                                                (std::cos(inner) - std::cos(outer))));
            EXPECT_NEAR(traced.direct.at(x, y),
                        9.0 * open * open * cosine / (distance * distance) / kPi, 1e-5);
            ++regions[open == 0.0 ? 0 : open < 1.0 ? 1 : 2];
        }
    }
    for (const int count : regions) {
        EXPECT_GT(count, 20);
    }
}

TEST(PathTracer, ACoarseSphereCastsNoShadowOnItsOwnLitSide) {
    const LitScene scene({make_sphere({0.0f, 0.0f, -4.0f}, 1.5f, 6)});
    const glm::dvec3 to_light(0.7, 0.4, 0.6);
    const PathSettings settings = make_settings(0.5, Falloff::none);
    const Image open = trace_light(scene, make_forward_camera(),
                                   make_sun(to_light, glm::vec3(3.0f), false), settings)
                           .direct;
    const Image cast = trace_light(scene, make_forward_camera(),
                                   make_sun(to_light, glm::vec3(3.0f), true), settings)
                           .direct;
    EXPECT_GT(compute_average(open).x, 0.1);
    // 0.24 pi x cos: the last 5 degrees before the terminator may go.
    for (int y = 0; y < kTracedSize.height; ++y) {
        for (int x = 0; x < kTracedSize.width; ++x) {
            if (open.at(x, y) > 0.07f) {
                ASSERT_EQ(cast.at(x, y), open.at(x, y)) << x << " " << y;
            }
        }
    }
}

// ---- one bounce

/// Form factor of a square of side 2 `half` that lies parallel at the height h over the middle of
/// the point (Howell, catalogue of configuration factors, B-3, times four).
double compute_form_factor(double half, double height) {
    const double x = half / height;
    const double root = std::sqrt(1.0 + x * x);
    return 4.0 / (2.0 * kPi) * 2.0 * x / root * std::atan(x / root);
}

/// The same with each direction weighed by the falloff over `radius`.
double integrate_form_factor(double half, double height, Falloff falloff, double radius) {
    const auto weigh = [&](const glm::dvec3& d) {
        const double distance = height / d.z;
        const bool hits = std::max(std::abs(d.x), std::abs(d.y)) * distance < half;
        return hits && distance <= radius ? compute_falloff(falloff, distance / radius) : 0.0;
    };
    return integrate_hemisphere(weigh, Weighting::cosine, 1000);
}

/// A floor that the camera below the sender looks down at; what shines up at it lights the sender.
struct SenderScene {
    static constexpr float kHalf = 0.5f;
    static constexpr float kHeight = 1.0f;
    glm::vec3 sender_albedo{0.9f, 0.4f, 0.2f};
    bool faces_floor = true;

    [[nodiscard]] LitScene make() const {
        const Mesh sender = faces_floor ? make_ceiling(kHalf, kHeight) : make_floor(kHalf, kHeight);
        return LitScene({paint(make_floor(20.0f, 0.0f), kAlbedo), paint(sender, sender_albedo)});
    }
    [[nodiscard]] TracedRadiance trace(const Lights& lights, const PathSettings& settings) const {
        return trace_light(make(), make_camera_above_zero(0.5 * kHeight), lights, settings);
    }
};

const glm::vec3 kIrradiance(2.0f, 3.0f, 1.0f);
/// Through the floor, which is nothing to a light that casts no shadows.
const glm::dvec3 kFromBelow(0.0, -1.0, 0.0);

TEST(PathTracer, ASquareSendsByItsFormFactor) {
    for (const bool faces_floor : {true, false}) {
        const SenderScene scene{{0.9f, 0.4f, 0.2f}, faces_floor};
        const Lights lights = make_sun(kFromBelow, kIrradiance, false);
        const glm::dvec3 full = glm::dvec3(kAlbedo * scene.sender_albedo * kIrradiance) / kPi;
        const double factor = compute_form_factor(SenderScene::kHalf, SenderScene::kHeight);
        struct Case {
            PathSettings settings;
            double factor;
        };
        const double far = 1.5;  // beyond the corners, at 1.23 m
        const double near = 1.1; // cuts them off
        const std::vector<Case> cases{
            {make_settings(0.1, Falloff::none, PathReach::full), factor},
            {make_settings(far, Falloff::none), factor},
            {make_settings(far, Falloff::linear),
             integrate_form_factor(SenderScene::kHalf, SenderScene::kHeight, Falloff::linear, far)},
            {make_settings(far, Falloff::quadratic),
             integrate_form_factor(SenderScene::kHalf, SenderScene::kHeight, Falloff::quadratic,
                                   far)},
            {make_settings(near, Falloff::none),
             integrate_form_factor(SenderScene::kHalf, SenderScene::kHeight, Falloff::none, near)},
            {make_settings(0.9, Falloff::none), 0.0}};
        for (const Case& c : cases) {
            const TracedRadiance traced = scene.trace(lights, c.settings);
            // 1728 pixels of 128 rays; the middle half percent of the height shifts the square.
            expect_near(compute_average(traced.bounce), c.factor * full, 2e-3 * full.y, "bounce");
            expect_near(compute_average(compute_mean(traced.indirect)),
                        compute_average(traced.bounce), 1e-6, "nothing else shines");
        }
    }
}

TEST(PathTracer, SendersLieInTheShadowOfLightsThatCastThem) {
    const SenderScene scene;
    const PathSettings settings = make_settings(1.5, Falloff::none);
    EXPECT_EQ(
        compute_average(scene.trace(make_sun(kFromBelow, kIrradiance, true), settings).bounce).y,
        0.0);
    // A point light between floor and sender lights both.
    Lights lamp = make_surroundings(kBlack);
    lamp.points.push_back({{0.0, 0.6, 0.0}, kIrradiance, {}, true});
    const double with_shadows = compute_average(scene.trace(lamp, settings).bounce).y;
    lamp.points.front().casts_shadow = false;
    EXPECT_GT(with_shadows, 0.01);
    EXPECT_NEAR(compute_average(scene.trace(lamp, settings).bounce).y, with_shadows, 1e-6);
    // Through the sender from above it goes only without shadows, and to its upper side alone.
    lamp.points.front().position.y = 1.5;
    EXPECT_EQ(compute_average(scene.trace(lamp, settings).bounce).y, 0.0);
}

TEST(PathTracer, WithoutBouncesSendersAreBlackAndTheEnvironmentIsTheSame) {
    const SenderScene scene;
    Lights lights = make_sun(kFromBelow, kIrradiance, false);
    lights.ambient = kSky;
    PathSettings settings = make_settings(1.5, Falloff::linear);
    const TracedRadiance lit = scene.trace(lights, settings);
    settings.bounces = 0;
    const TracedRadiance black = scene.trace(lights, settings);
    EXPECT_GT(compute_average(lit.bounce).y, 0.01);
    EXPECT_EQ(compute_average(black.bounce).y, 0.0);
    EXPECT_EQ(hash_image(black.environment), hash_image(lit.environment));
    EXPECT_EQ(hash_image(black.direct), hash_image(lit.direct));
    EXPECT_LT(black.indirect.ray_count, lit.indirect.ray_count);
}

TEST(PathTracer, ASenderGathersItsSurroundingsWithinTheSameReach) {
    // Between two infinite planes h apart every ray meets the other one; what it sends is what it
    // sees of the surroundings: all of them but for the weight of the floor. Weights of both rays
    // are independent, so bounce = albedos x L x m (1 - m) with the mean weight m.
    const double height = 1.0;
    const float wide = 2000.0f;
    const LitScene scene({paint(make_floor(wide, 0.0f), kAlbedo),
                          paint(make_ceiling(wide, float(height)), glm::vec3(0.6f))});
    const double radius = 2.0;
    for (const Falloff falloff : {Falloff::none, Falloff::linear, Falloff::quadratic}) {
        const double mean_weight = integrate_hemisphere(
            [&](const glm::dvec3& d) {
                const double distance = height / d.z;
                return distance <= radius ? compute_falloff(falloff, distance / radius) : 0.0;
            },
            Weighting::cosine, 1000);
        const TracedRadiance traced =
            trace_light(scene, make_camera_above_zero(0.5), make_surroundings(kSky),
                        make_settings(radius, falloff));
        const glm::dvec3 albedos = glm::dvec3(kAlbedo) * 0.6 * glm::dvec3(kSky);
        expect_near(compute_average(traced.bounce), albedos * (mean_weight * (1.0 - mean_weight)),
                    1.5e-3 * albedos.z, "bounce");
        expect_near(compute_average(traced.environment),
                    glm::dvec3(kAlbedo * kSky) * (1.0 - mean_weight), 1e-3, "environment");
    }
}

} // namespace
} // namespace alcove
