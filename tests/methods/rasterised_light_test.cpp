// Direct light of the G-buffer, with shadow maps, against rays through the same triangles.
#include "tests/methods/light_shots.hpp"

#include "methods/ssao_environment/ssao_environment.hpp"
#include "scenes/common/round_solids.hpp"
#include "tests/methods/traced_light_rig.hpp"
#include "tests/test_scenes.hpp"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtx/quaternion.hpp>
#include <glm/trigonometric.hpp>

namespace alcove {
namespace {

class RasterisedLightTest : public LightShotTest {
  protected:
    /// A floor with a box that stands and one that hovers, seen from above.
    static std::unique_ptr<LitScene> make_scene(const Lights& lights) {
        auto scene = std::make_unique<LitScene>(std::vector<Mesh>{
            make_floor(6.0f, 0.0f), make_box({-0.5f, 0.0f, -3.5f}, {0.1f, 0.8f, -3.0f}),
            make_box({0.5f, 0.6f, -3.4f}, {1.1f, 0.7f, -2.8f})});
        scene->set_lights(lights);
        scene->set_camera(make_look_at_camera({0.0, 2.2, 0.0}, {0.0, 0.0, -3.2}, {0.0, 1.0, 0.0},
                                              1.0, 0.1, 50.0));
        return scene;
    }

    /// Share of pixels whose light differs by more than a tenth of the brightest, and share that
    /// truth has in shadow.
    struct Difference {
        double wrong = 0.0;
        double dark = 0.0;
    };
    static Difference compare(const Lights& lights) {
        const std::unique_ptr<LitScene> owned = make_scene(lights);
        const LitScene& scene = *owned;
        const LightShot shot = shoot(ssao_environment_unit(), "", scene, kTracedSize);
        PathSettings settings;
        settings.rays_per_half = 1;
        const Image truth =
            trace_light(scene, scene.get_walkthrough().cameras[0], lights, settings).direct;
        float brightest = 0.0f;
        for (const float value : truth.values()) {
            brightest = std::max(brightest, value);
        }
        Difference difference;
        const double count = double(truth.size().pixel_count());
        for (int y = 0; y < truth.height(); ++y) {
            for (int x = 0; x < truth.width(); ++x) {
                const float apart = std::abs(truth.at(x, y) - shot.direct.at(x, y));
                difference.wrong += apart > 0.1f * brightest ? 1.0 / count : 0.0;
                const bool is_floor = std::isfinite(shot.eye_depth.at(x, y));
                difference.dark += is_floor && truth.at(x, y) == 0.0f ? 1.0 / count : 0.0;
            }
        }
        return difference;
    }
};

// 0.02: of 48x36 pixels those at the edges of shadows, whose map has texels of its own.
constexpr double kEdges = 0.02;

TEST_F(RasterisedLightTest, DirectionalShadowsAreThoseOfRays) {
    Lights lights = make_surroundings(glm::vec3(0.0f));
    lights.directional.push_back(
        {glm::normalize(glm::dvec3(0.5, 1.0, 0.3)), glm::vec3(1.0f), true});
    const Difference difference = compare(lights);
    EXPECT_LT(difference.wrong, kEdges);
    EXPECT_GT(difference.dark, 0.01);
}

TEST_F(RasterisedLightTest, PointShadowsAreThoseOfRaysOnEveryFaceOfTheCube) {
    for (const glm::dvec3& place : {glm::dvec3(0.3, 0.5, -2.6), glm::dvec3(-1.2, 0.4, -3.3),
                                    glm::dvec3(0.3, 2.0, -3.2), glm::dvec3(0.3, 0.3, -4.2)}) {
        Lights lights = make_surroundings(glm::vec3(0.0f));
        lights.points.push_back({place, glm::vec3(0.3f), std::nullopt, true});
        const Difference difference = compare(lights);
        EXPECT_LT(difference.wrong, kEdges) << place.x;
        EXPECT_GT(difference.dark, 0.02) << place.x;
    }
}

TEST_F(RasterisedLightTest, SpotsShineIntoTheirConeAndCastShadows) {
    Lights lights = make_surroundings(glm::vec3(0.0f));
    const glm::dvec3 place(0.2, 2.0, -2.4);
    lights.points.push_back({place, glm::vec3(4.0f),
                             SpotCone{glm::normalize(glm::dvec3(0.2, 0.0, -3.3) - place), 0.3, 0.6},
                             true});
    const Difference difference = compare(lights);
    EXPECT_LT(difference.wrong, kEdges);
    EXPECT_GT(difference.dark, 0.1);
}

// A smooth ball of few facets: where the light grazes it, a facet that turns away from the light
// must not shadow itself.
TEST_F(RasterisedLightTest, FacetsOfSmoothSolidsDoNotShadowTheirLitSide) {
    constexpr ImageSize kSize{160, 120};
    Lights lights = make_surroundings(glm::vec3(0.0f));
    const glm::dvec3 to_light = glm::normalize(glm::dvec3(1.0, 0.4, 0.2));
    lights.directional.push_back({to_light, glm::vec3(3.0f), true});
    LitScene scene({make_ball_mesh("ball", glm::vec3(1.0f), 2)});
    scene.set_lights(lights);
    scene.set_camera(
        make_look_at_camera({0.0, 0.0, 3.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.8, 0.1, 50.0));
    const LightShot shot = shoot(ssao_environment_unit(), "", scene, kSize);
    int lit = 0;
    int lost = 0;
    for (std::size_t i = 0; i < shot.eye_depth.values().size(); ++i) {
        const glm::dvec3 normal(shot.normal.values()[3 * i], shot.normal.values()[3 * i + 1],
                                shot.normal.values()[3 * i + 2]);
        if (std::isfinite(shot.eye_depth.values()[i]) && glm::dot(normal, to_light) > 0.05) {
            ++lit;
            lost += shot.direct.values()[3 * i] == 0.0f ? 1 : 0;
        }
    }
    EXPECT_GT(lit, 2000);
    EXPECT_EQ(lost, 0);
}

TEST_F(RasterisedLightTest, LightsWithoutShadowShineThroughEverything) {
    Lights lights = make_surroundings(glm::vec3(0.0f));
    lights.directional.push_back({glm::normalize(glm::dvec3(0.5, 1.0, 0.3)), glm::vec3(1.0f)});
    EXPECT_LT(compare(lights).wrong, 0.001);
}

TEST_F(RasterisedLightTest, NoPlaneShadowsItselfAtAnyAngle) {
    for (const double elevation : {80.0, 30.0, 10.0, 3.0}) {
        Lights lights = make_surroundings(glm::vec3(0.0f));
        const double angle = glm::radians(elevation);
        lights.directional.push_back(
            {glm::dvec3(std::cos(angle), std::sin(angle), 0.0), glm::vec3(1.0f), true});
        LitScene scene({make_floor(6.0f, 0.0f)});
        scene.set_lights(lights);
        scene.set_camera(make_look_at_camera({0.0, 2.2, 0.0}, {0.0, 0.0, -3.2}, {0.0, 1.0, 0.0},
                                             1.0, 0.1, 50.0));
        const LightShot shot = shoot(ssao_environment_unit(), "", scene, kTracedSize);
        int dark = 0;
        for (int y = 0; y < kTracedSize.height; ++y) {
            for (int x = 0; x < kTracedSize.width; ++x) {
                dark += std::isfinite(shot.eye_depth.at(x, y)) && shot.direct.at(x, y) == 0.0f;
            }
        }
        // Below 10 degrees the bias stops growing: acne is the price of shadows that stay.
        EXPECT_EQ(elevation >= 10.0 ? dark : 0, 0) << elevation;
    }
}

// Off the axis of a cube's face, depth changes from texel to texel of a wall that faces the lamp.
TEST_F(RasterisedLightTest, NoWallThatFacesALampShadowsItself) {
    for (const glm::dvec3& way :
         {glm::dvec3(0.0, 0.0, -1.0), glm::dvec3(0.9, 0.1, -1.0), glm::dvec3(0.6, 0.95, -0.9),
          glm::dvec3(-1.0, -0.9, -0.95), glm::dvec3(0.3, -1.0, 0.8)}) {
        const glm::dvec3 to_wall = glm::normalize(way);
        Mesh wall = make_wall(1.0f, -2.0f);
        const glm::mat3 turn(glm::mat3_cast(glm::rotation(glm::dvec3(0.0, 0.0, -1.0), to_wall)));
        for (std::size_t i = 0; i < wall.positions.size(); ++i) {
            wall.positions[i] = turn * wall.positions[i];
            wall.normals[i] = turn * wall.normals[i];
        }
        Lights lights = make_surroundings(glm::vec3(0.0f));
        lights.points.push_back({glm::dvec3(0.0), glm::vec3(1.0f), std::nullopt, true});
        LitScene scene({wall});
        scene.set_lights(lights);
        scene.set_camera(
            make_look_at_camera(glm::dvec3(0.0), to_wall, {0.0, 1.0, 0.0}, 0.8, 0.1, 50.0));
        const LightShot shot = shoot(ssao_environment_unit(), "", scene, {160, 120});
        int dark = 0;
        int seen = 0;
        for (std::size_t i = 0; i < shot.eye_depth.values().size(); ++i) {
            const bool is_wall = std::isfinite(shot.eye_depth.values()[i]);
            seen += is_wall ? 1 : 0;
            dark += is_wall && shot.direct.values()[3 * i] == 0.0f ? 1 : 0;
        }
        EXPECT_GT(seen, 5000);
        EXPECT_EQ(dark, 0) << way.x << " " << way.y << " " << way.z;
    }
}

} // namespace
} // namespace alcove
