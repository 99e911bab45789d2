#include "methods/instant_radiosity/instant_radiosity.hpp"

#include "core/base/text.hpp"
#include "core/frame/scene_renderer.hpp"
#include "methods/instant_radiosity/virtual_lights.hpp"
#include "tests/methods/light_shots.hpp"
#include "tests/methods/shadow_rates.hpp"
#include "tests/methods/traced_light_rig.hpp"
#include "tests/test_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

constexpr ImageSize kSize{96, 72};

class InstantRadiosityTest : public LightShotTest {
  protected:
    static std::vector<VirtualLight> place_lights(const Scene& scene, int side, int count) {
        SceneRenderer renderer(gl(), scene);
        SceneRaster raster(renderer, compute_bounding_sphere(scene));
        raster.set_frame(make_frame_view(scene.get_walkthrough(), 0, kSize, true));
        context().reset_state();
        ReflectiveShadowMaps maps(gl(), side);
        for (const ShadowLight& light :
             list_shadow_lights(scene.get_lights(), raster.get_bounding_sphere())) {
            maps.add(raster, light);
        }
        return maps.choose(count, 1);
    }
};

glm::dvec3 sum_flux(const std::vector<VirtualLight>& lights) {
    glm::dvec3 flux(0.0);
    for (const VirtualLight& light : lights) {
        flux += std::numbers::pi * glm::dvec3(light.intensity);
    }
    return flux;
}

TEST_F(InstantRadiosityTest, VirtualLightsOfTheSunCarryWhatAFloorReflects) {
    LitScene scene({paint(make_floor(2.0f, 0.0f), {0.8f, 0.4f, 0.2f})});
    Lights lights = make_surroundings(glm::vec3(0.0f));
    const glm::dvec3 to_light = glm::normalize(glm::dvec3(0.4, 1.0, 0.3));
    lights.directional = {{to_light, glm::vec3(2.0f, 2.0f, 1.0f), true}};
    scene.set_lights(lights);
    const auto placed = place_lights(scene, 256, 100);
    EXPECT_EQ(placed.size(), 100u);
    const glm::dvec3 flux = sum_flux(placed);
    const double area = 16.0 * to_light.y;
    EXPECT_NEAR(flux.x, 1.6 * area, 0.02 * 1.6 * area);
    EXPECT_NEAR(flux.z, 0.2 * area, 0.02 * 0.2 * area);
    for (const VirtualLight& light : placed) {
        EXPECT_NEAR(light.position.y, 0.0, 1e-4);
        EXPECT_NEAR(light.normal.y, 1.0, 1e-3);
    }
}

TEST_F(InstantRadiosityTest, VirtualLightsOfAPointInARoomCarryAllThatItSendsTimesAlbedo) {
    Mesh room = paint(make_box({-2.0f, -1.0f, -3.0f}, {2.0f, 1.5f, 1.0f}), glm::vec3(0.5f));
    LitScene scene({room});
    Lights lights = make_surroundings(glm::vec3(0.0f));
    lights.points = {{{0.5, 0.2, -1.0}, glm::vec3(3.0f), std::nullopt, false}};
    scene.set_lights(lights);
    const auto placed = place_lights(scene, 64, 200);
    const double expected = 0.5 * 3.0 * 4.0 * std::numbers::pi;
    EXPECT_NEAR(sum_flux(placed).y, expected, 0.01 * expected);
    for (const VirtualLight& light : placed) {
        // Seen from inside: normals are turned to the light.
        EXPECT_GT(glm::dot(light.normal, lights.points[0].position - light.position), 0.0);
    }
    // Of a spot: the integral of its falloff over the sphere.
    lights.points[0].cone = SpotCone{{0.0, -1.0, 0.0}, 0.4, 0.9};
    scene.set_lights(lights);
    double solid_angle = 0.0;
    for (int i = 0; i < 10000; ++i) {
        const double angle = (i + 0.5) * 1e-4 * 0.9;
        const double inside = std::clamp(
            (std::cos(angle) - std::cos(0.9)) / (std::cos(0.4) - std::cos(0.9)), 0.0, 1.0);
        solid_angle += 2.0 * std::numbers::pi * std::sin(angle) * inside * inside * 1e-4 * 0.9;
    }
    EXPECT_NEAR(sum_flux(place_lights(scene, 128, 200)).y, 1.5 * solid_angle,
                0.01 * 1.5 * solid_angle);
}

glm::dvec3 locate_pixel(const Camera& camera, const Image& eye_depth, int x, int y) {
    return camera.position +
           double(eye_depth.at(x, y)) *
               compute_pixel_direction(camera, eye_depth.size(), {x + 0.5, y + 0.5});
}

/// A floor and a wall that meet, white, under a sun that lights both.
std::unique_ptr<LitScene> make_corner() {
    auto scene = std::make_unique<LitScene>(std::vector<Mesh>{
        paint(make_quad({-2, 0, 2}, {2, 0, 2}, {2, 0, -2}, {-2, 0, -2}), glm::vec3(0.8f)),
        paint(make_quad({-2, 0, -2}, {2, 0, -2}, {2, 2, -2}, {-2, 2, -2}), glm::vec3(0.8f))});
    Lights lights = make_surroundings(glm::vec3(0.0f));
    lights.directional = {{glm::normalize(glm::dvec3(0.2, 1.0, 1.0)), glm::vec3(2.0f), true}};
    scene->set_lights(lights);
    scene->set_camera(make_look_at_camera({0.0, 1.3, 0.6}, {0.0, 0.35, -1.8}, {0.0, 1.0, 0.0},
                                          std::numbers::pi / 3.0, 0.01, 100.0));
    return scene;
}

/// Mean bounced light over the pixels near the corner: within 30 cm of both planes.
double measure_corner(const Image& bounce, const Image& eye_depth, const Camera& camera) {
    double sum = 0.0;
    int count = 0;
    for (int y = 0; y < bounce.height(); ++y) {
        for (int x = 0; x < bounce.width(); ++x) {
            const glm::dvec3 p = locate_pixel(camera, eye_depth, x, y);
            if (p.y < 0.3 && p.z < -1.7) {
                sum += bounce.at(x, y, 1);
                ++count;
            }
        }
    }
    EXPECT_GT(count, 500);
    return sum / count;
}

// Ritschel et al. 2009, figure 12: the clamp loses light in corners, and a near bounce on screen
// gives a part of it back; plainly added it may give more than there was.
TEST_F(InstantRadiosityTest, ClampLosesLightInACornerAndTheNearBounceGivesAPartBack) {
    const auto corner = make_corner();
    const LitScene& scene = *corner;
    const Camera& camera = scene.get_walkthrough().cameras.front();
    const auto measure = [&](const std::string& settings) {
        const LightShot shot =
            shoot(instant_radiosity_unit(), "map_size=64,radius=0.3," + settings, scene, kSize);
        return measure_corner(shot.radiance, shot.eye_depth, camera);
    };
    const LightShot any = shoot(instant_radiosity_unit(), "vpls=1", scene, kSize);
    PathTracer tracer;
    tracer.update(pose_geometry(scene, 0.0));
    PathSettings settings;
    settings.reach = PathReach::full;
    settings.rays_per_half = 64;
    const TracedRadiance traced = tracer.trace(camera, kSize, scene.get_lights(), settings);
    const double truth = measure_corner(compute_mean(traced.indirect), any.eye_depth, camera);
    const double open = measure("vpls=512,clamp=0.001,near_bounce=off");
    const double clamped = measure("vpls=512,clamp=0.5,near_bounce=off");
    // The near bounce is added to whatever the virtual lights give.
    const double few = measure("vpls=4,clamp=0.5,near_bounce=off");
    const std::string near = "vpls=4,clamp=0.5,radius=0.5,near_bounce=";
    const double part = clamped + measure(near + "clamped_part") - few;
    const double added = clamped + measure(near + "added") - few;
    for (const auto& [name, value] :
         {std::pair{"truth", truth}, std::pair{"no_clamp", open}, std::pair{"clamp", clamped},
          std::pair{"clamped_part", part}, std::pair{"added", added}}) {
        RecordProperty(name, std::to_string(value)); // the README's table
    }
    // 512 lights without a clamp: single ones that lie close to a pixel are its noise.
    EXPECT_NEAR(open / truth, 1.0, 0.12);
    EXPECT_LT(clamped, 0.7 * truth);
    EXPECT_GT(part, clamped + 0.2 * (truth - clamped));
    EXPECT_LT(part, truth);
    EXPECT_GT(added, part);
}

/// What the method's visibility is by shadow rays to the same virtual lights, for the scene's first
/// camera; `shot` tells its surfaces.
Image trace_visibility(const Scene& scene, const std::vector<VirtualLight>& lights,
                       const LightShot& shot, double clamp_m) {
    const Camera& camera = scene.get_walkthrough().cameras.front();
    const ImageSize size = shot.eye_depth.size();
    Image arriving(size, 1);
    Image open(size, 1);
    for (const VirtualLight& light : lights) {
        // A tenth of a millimetre off the surface that it lies on, and bright enough for rays at
        // any distance.
        const glm::dvec3 place = light.position + 1e-4 * light.normal;
        Lights one = make_surroundings(glm::vec3(0.0f));
        one.points = {{place, glm::vec3(1e3f), std::nullopt, true}};
        const Image seen = trace_shadows(LitLike(scene, one, 0), size);
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                const glm::dvec3 p = locate_pixel(camera, shot.eye_depth, x, y);
                const glm::dvec3 n =
                    camera.world_from_view * glm::dvec3(get_pixel(shot.normal, x, y));
                const double distance = glm::distance(place, p);
                const glm::dvec3 direction = (place - p) / distance;
                const double cosine = glm::dot(n, direction);
                const double sent = -glm::dot(light.normal, direction);
                if (!std::isfinite(distance) || std::min(cosine, sent) <= 1e-3) {
                    continue;
                }
                const double least = std::max(distance, clamp_m);
                const auto amount = static_cast<float>(
                    glm::dot(glm::dvec3(0.2126, 0.7152, 0.0722), glm::dvec3(light.intensity)) *
                    cosine * sent / (least * least));
                open.at(x, y) += amount;
                arriving.at(x, y) += seen.at(x, y) == 1.0f ? amount : 0.0f;
            }
        }
    }
    for (std::size_t i = 0; i < open.values().size(); ++i) {
        float& value = open.values()[i];
        value = value > 0.0f ? arriving.values()[i] / value : 1.0f;
    }
    return open;
}

/// Means over all pixels of what an image has too much and too little.
struct Deviation {
    double too_light = 0.0;
    double too_dark = 0.0;
};

Deviation compare(const Image& image, const Image& truth) {
    Deviation deviation;
    const auto count = static_cast<double>(truth.values().size());
    for (std::size_t i = 0; i < truth.values().size(); ++i) {
        const auto difference = static_cast<double>(image.values()[i] - truth.values()[i]);
        deviation.too_light += std::max(difference, 0.0) / count;
        deviation.too_dark += std::max(-difference, 0.0) / count;
    }
    return deviation;
}

class CorrectionTest : public InstantRadiosityTest {
  protected:
    struct Deviations {
        Deviation bias;
        Deviation corrected;
    };
    /// Of 32 virtual lights, from shadow rays to them.
    static Deviations measure_correction(const Scene& scene, double radius_m,
                                         const std::string& settings, ImageSize size) {
        const auto show = [&](const char* correction) {
            return shoot(instant_radiosity_unit(),
                         "near_bounce=off,vpls=32,radius=" + format_number(radius_m) + "," +
                             settings + ",correction=" + correction,
                         scene, size);
        };
        const LightShot bias = show("false");
        const Image truth = trace_visibility(scene, place_lights(scene, 256, 32), bias, radius_m);
        const Deviations deviations{compare(bias.visibility, truth),
                                    compare(show("true").visibility, truth)};
        RecordProperty("bias_too_light", std::to_string(deviations.bias.too_light));
        RecordProperty("bias_too_dark", std::to_string(deviations.bias.too_dark));
        RecordProperty("corrected_too_light", std::to_string(deviations.corrected.too_light));
        RecordProperty("corrected_too_dark", std::to_string(deviations.corrected.too_dark));
        return deviations;
    }
};

// Ritschel et al. 2009, figure 11: small shadows of virtual lights come back.
TEST_F(CorrectionTest, BringsContactShadowsOfVirtualLightsBack) {
    std::vector<Mesh> meshes{make_floor(1.0f, 0.0f)};
    meshes.push_back(make_quad({-1, 0, -1}, {1, 0, -1}, {1, 1, -1}, {-1, 1, -1}));
    for (int i = 0; i < 25; ++i) {
        const float x = -0.4f + 0.2f * static_cast<float>(i % 5);
        const float z = -0.4f + 0.2f * static_cast<float>(i / 5);
        meshes.push_back(make_box({x, 0.0f, z}, {x + 0.05f, 0.025f, z + 0.05f}));
    }
    LitScene scene(std::move(meshes));
    Lights lights = make_surroundings(glm::vec3(0.0f));
    lights.directional = {{glm::normalize(glm::dvec3(0.0, 0.05, 1.0)), glm::vec3(2.0f), true}};
    scene.set_lights(lights);
    scene.set_camera(make_look_at_camera({0.0, 0.6, 0.75}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0},
                                         std::numbers::pi / 3.0, 0.01, 100.0));
    const auto [bias, corrected] = measure_correction(scene, 0.2, "map_size=64", {128, 96});
    EXPECT_LT(corrected.too_light, 0.6 * bias.too_light);
    EXPECT_LT(corrected.too_light + corrected.too_dark, bias.too_light + bias.too_dark);
}

// Round shapes that low light reaches: most of it from beyond the maps' angle of view.
TEST_F(CorrectionTest, IsNearerToShadowRaysAtToesAndDarkensNothingElse) {
    const auto toes =
        open_lit_scene("toes", "", "environment=uniform,environment_level=0,shadows=true");
    const LitLike scene(*toes, toes->get_lights(), 60);
    const auto [bias, corrected] = measure_correction(scene, 0.05, "map_size=256", kSize);
    EXPECT_LT(corrected.too_light, 0.5 * bias.too_light);
    EXPECT_LT(corrected.too_dark, 0.1 * bias.too_light);
}

// Virtual lights on a floor lie in the plane of its points, above or below by rounding: no
// correction may turn what they do not send into a shadow.
TEST_F(InstantRadiosityTest, AFloorThatNothingLightsButItselfIsOpen) {
    LitScene scene({make_floor(1.0f, 0.0f),
                    paint(make_box({-0.1f, 0.0f, -0.1f}, {0.1f, 0.1f, 0.1f}), glm::vec3(0.0f))});
    Lights lights = make_surroundings(glm::vec3(0.0f));
    lights.directional = {{glm::normalize(glm::dvec3(0.6, 1.0, 0.5)), glm::vec3(1.0f), true}};
    scene.set_lights(lights);
    const Camera camera = make_look_at_camera({0.1, 0.25, 0.6}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0},
                                              std::numbers::pi / 4.0, 0.01, 100.0);
    scene.set_camera(camera);
    const LightShot shot = shoot(instant_radiosity_unit(),
                                 "near_bounce=off,radius=0.1,vpls=16,map_size=64", scene, kSize);
    int floor_pixels = 0;
    int dark = 0;
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            const glm::dvec3 p =
                camera.position + double(shot.eye_depth.at(x, y)) *
                                      compute_pixel_direction(camera, kSize, {x + 0.5, y + 0.5});
            if (std::abs(p.y) < 1e-5) {
                ++floor_pixels;
                dark += shot.visibility.at(x, y) < 1.0f ? 1 : 0;
            }
        }
    }
    EXPECT_GT(floor_pixels, 3000);
    EXPECT_EQ(dark, 0);
    EXPECT_EQ(std::count(shot.passes.begin(), shot.passes.end(), "instant_radiosity/light"), 16);
}

TEST_F(InstantRadiosityTest, ASceneWithoutLightsGetsTheSurroundingsAlone) {
    LitScene scene({make_floor(5.0f, -1.0f)});
    scene.set_lights(make_surroundings(glm::vec3(0.5f)));
    scene.set_camera(make_forward_camera());
    const LightShot shot = shoot(instant_radiosity_unit(), "", scene, kSize);
    EXPECT_NEAR(shot.radiance.at(48, 60, 1), 0.5f * shot.albedo.at(48, 60, 1), 0.001f);
    EXPECT_EQ(std::count(shot.passes.begin(), shot.passes.end(), "instant_radiosity/light"), 0);
    EXPECT_EQ(*std::min_element(shot.visibility.values().begin(), shot.visibility.values().end()),
              1.0f);
}

} // namespace
} // namespace alcove
