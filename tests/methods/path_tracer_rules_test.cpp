// What the path tracer promises beside its accuracy: equal bits, honest noise, whose albedo.
#include "methods/common/path_tracer.hpp"

#include "core/base/domain.hpp"
#include "tests/methods/traced_light_rig.hpp"
#include "tests/test_scenes.hpp"

#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace alcove {
namespace {

/// All kinds of light at once.
Lights make_all_lights(const glm::dvec3& origin = glm::dvec3(0.0)) {
    Lights lights;
    lights.directional.push_back(
        {glm::normalize(glm::dvec3(0.3, 1.0, 0.4)), glm::vec3(1.5f), true});
    lights.points.push_back(
        {origin + glm::dvec3(0.5, 1.5, -2.0), glm::vec3(0.5f, 0.2f, 0.1f), {}, true});
    // Made once: its prefiltered map takes 60 ms.
    static const auto kEnvironment = std::make_shared<const Environment>(
        [](const glm::dvec3& d) {
            return d.y > 0.0 ? glm::vec3(0.3f, 0.5f, 1.0f) : glm::vec3(0.4f, 0.2f, 0.1f);
        },
        "test");
    lights.environment = kEnvironment;
    return lights;
}

PathSettings make_settings() {
    PathSettings settings;
    settings.radius_m = 0.5;
    settings.rays_per_half = 16;
    settings.seed = 7;
    return settings;
}

TracedRadiance trace_boxes(const PathSettings& settings,
                           const glm::dvec3& origin = glm::dvec3(0.0)) {
    const TestScene scene = make_box_scene(origin);
    return trace_light(scene, scene.get_walkthrough().cameras[0], make_all_lights(origin),
                       settings);
}

double compute_rms(const Image& image) {
    double sum = 0.0;
    for (const float value : image.values()) {
        sum += static_cast<double>(value) * static_cast<double>(value);
    }
    return std::sqrt(sum / static_cast<double>(image.values().size()));
}

TEST(PathTracerRules, TheImageDoesNotDependOnTheNumberOfThreads) {
    PathSettings settings = make_settings();
    settings.threads = 1;
    settings.wants_parts = true;
    const TracedRadiance one = trace_boxes(settings);
    for (const int threads : {2, 5, 0}) {
        settings.threads = threads;
        const TracedRadiance many = trace_boxes(settings);
        EXPECT_EQ(hash_image(one.direct), hash_image(many.direct)) << threads;
        EXPECT_EQ(hash_image(one.indirect.a), hash_image(many.indirect.a)) << threads;
        EXPECT_EQ(hash_image(one.indirect.b), hash_image(many.indirect.b)) << threads;
        EXPECT_EQ(hash_image(one.environment), hash_image(many.environment)) << threads;
        EXPECT_EQ(hash_image(one.bounce), hash_image(many.bounce)) << threads;
        EXPECT_EQ(hash_image(one.visibility), hash_image(many.visibility)) << threads;
        EXPECT_EQ(one.indirect.ray_count, many.indirect.ray_count) << threads;
    }
}

TEST(PathTracerRules, PartsAreAddedUpInTheHalvesAndChangeNothing) {
    PathSettings settings = make_settings();
    const TracedRadiance without = trace_boxes(settings);
    EXPECT_TRUE(without.environment.empty() && without.bounce.empty());
    settings.wants_parts = true;
    const TracedRadiance with = trace_boxes(settings);
    EXPECT_EQ(hash_image(with.indirect.a), hash_image(without.indirect.a));
    Image sum = with.environment;
    for (std::size_t i = 0; i < sum.values().size(); ++i) {
        sum.values()[i] += with.bounce.values()[i];
    }
    EXPECT_LT(find_largest_difference(sum, compute_mean(with.indirect)), 1e-6f);
}

TEST(PathTracerRules, RaysPerHalfNeedNotFillABundle) {
    // The environment of one ray is all or nothing where nothing weighs by distance.
    Lights lights = make_surroundings(glm::vec3(1.0f));
    const TestScene scene = make_box_scene();
    for (const int rays : {1, 5}) {
        PathSettings settings = make_settings();
        settings.falloff = Falloff::none;
        settings.bounces = 0;
        settings.rays_per_half = rays;
        const TracedRadiance traced =
            trace_light(scene, scene.get_walkthrough().cameras[0], lights, settings);
        bool any_blocked = false;
        for (const float value : traced.visibility.values()) {
            const float scaled = value * static_cast<float>(2 * rays);
            ASSERT_NEAR(scaled, std::round(scaled), 1e-5f);
            any_blocked = any_blocked || value < 1.0f;
        }
        EXPECT_TRUE(any_blocked) << rays;
    }
}

TEST(PathTracerRules, EveryRayIsCountedOnce) {
    // A floor below a ceiling, so that every ray hits: a camera ray a pixel, its shadow ray for the
    // light below the ceiling, five rays in each half, and from each of what those hit one ray for
    // the surroundings and one shadow ray.
    const LitScene scene({make_floor(2000.0f, 0.0f), make_ceiling(2000.0f, 1.0f)});
    Lights lights = make_surroundings(glm::vec3(1.0f));
    lights.points.push_back({{0.0, 0.5, 0.0}, glm::vec3(1.0f), {}, true});
    PathSettings settings = make_settings();
    settings.reach = PathReach::full;
    settings.rays_per_half = 5;
    const auto count = [&] {
        return trace_light(scene, make_camera_above_zero(0.4), lights, settings).indirect.ray_count;
    };
    EXPECT_EQ(count(), kTracedSize.pixel_count() * (1 + 1 + 10 + 10 * 2));
    settings.bounces = 0;
    EXPECT_EQ(count(), kTracedSize.pixel_count() * (1 + 1 + 10));
    lights.points.front().casts_shadow = false;
    EXPECT_EQ(count(), kTracedSize.pixel_count() * (1 + 10));
}

TEST(PathTracerRules, TheHalvesTellTheNoiseOfTheirMean) {
    // The spread over seeds of the mean is what RMS(a - b) / 2 says, and halves of one seed are as
    // far apart as those of two: they are independent. It falls with the rays.
    PathSettings settings = make_settings();
    constexpr int kSeeds = 16;
    double last_noise = 0.0;
    for (const int rays : {16, 64}) {
        settings.rays_per_half = rays;
        std::vector<Image> means;
        double told = 0.0;
        double same_seed = 0.0;
        double other_seed = 0.0;
        Image last_b;
        for (int i = 0; i < kSeeds; ++i) {
            settings.seed = static_cast<std::uint32_t>(100 + i);
            const TracedRadiance traced = trace_boxes(settings);
            told += std::pow(compute_noise(traced.indirect), 2.0) / kSeeds;
            same_seed += std::pow(2.0 * compute_noise(traced.indirect), 2.0) / kSeeds;
            if (!last_b.empty()) {
                const double apart = 2.0 * compute_noise({traced.indirect.a, last_b, 0});
                other_seed += apart * apart / (kSeeds - 1);
            }
            last_b = traced.indirect.b;
            means.push_back(compute_mean(traced.indirect));
        }
        Image variance(kTracedSize, 3);
        for (std::size_t p = 0; p < variance.values().size(); ++p) {
            double sum = 0.0;
            double squares = 0.0;
            for (const Image& mean : means) {
                const auto value = static_cast<double>(mean.values()[p]);
                sum += value / kSeeds;
                squares += value * value;
            }
            variance.values()[p] = static_cast<float>(
                std::sqrt(std::max(0.0, (squares - kSeeds * sum * sum) / (kSeeds - 1))));
        }
        const double spread = compute_rms(variance);
        EXPECT_NEAR(std::sqrt(told) / spread, 1.0, 0.05) << rays;
        EXPECT_NEAR(std::sqrt(same_seed / other_seed), 1.0, 0.05) << rays;
        // Four times the rays: half the noise of plain random rays, or less.
        if (last_noise > 0.0) {
            EXPECT_LT(std::sqrt(told), 0.51 * last_noise);
        }
        last_noise = std::sqrt(told);
    }
}

TEST(PathTracerRules, AWorldFarFromZeroGivesTheSameImage) {
    const PathSettings settings = make_settings();
    const TracedRadiance here = trace_boxes(settings);
    const TracedRadiance far = trace_boxes(settings, glm::dvec3(1e7, -1e7, 1e7));
    EXPECT_GT(compute_average(here.direct).x, 0.05);
    EXPECT_LE(find_largest_difference(here.direct, far.direct), 1.0f / 255.0f);
    EXPECT_LE(find_largest_difference(compute_mean(here.indirect), compute_mean(far.indirect)),
              1.0f / 255.0f);
}

// ---- whose albedo

/// Sun on the wall head on, so that direct light is the albedo.
Lights make_head_light() {
    Lights lights = make_surroundings(glm::vec3(0.0f));
    lights.directional.push_back({{0.0, 0.0, 1.0}, glm::vec3(std::numbers::pi_v<float>), false});
    return lights;
}

/// Texture coordinates of a wall from -half to half: 0 to `repeats`, v down.
Mesh make_textured_wall(float half, float z, float repeats) {
    Mesh wall = make_wall(half, z);
    wall.albedo = glm::vec3(1.0f);
    wall.texture = 0;
    for (const glm::vec3& p : wall.positions) {
        wall.texture_coordinates.emplace_back(repeats * (0.5f + 0.5f * p.x / half),
                                              repeats * (0.5f - 0.5f * p.y / half));
    }
    return wall;
}

TEST(PathTracerRules, AlbedoIsInterpolatedBetweenVertexColours) {
    Mesh wall = paint(make_wall(4.0f, -4.0f), {0.5f, 1.0f, 0.8f});
    for (const glm::vec3& p : wall.positions) {
        wall.colors.emplace_back(0.5f + 0.125f * p.x, 0.5f + 0.125f * p.y, 1.0f);
    }
    const Camera camera = make_forward_camera();
    const Image direct =
        trace_light(LitScene({wall}), camera, make_head_light(), make_settings()).direct;
    for (int y = 0; y < kTracedSize.height; y += 3) {
        for (int x = 0; x < kTracedSize.width; x += 3) {
            const glm::dvec3 way =
                4.0 * compute_pixel_direction(camera, kTracedSize, {x + 0.5, y + 0.5});
            const glm::vec3 albedo = get_pixel(direct, x, y);
            ASSERT_NEAR(albedo.x, 0.5 * (0.5 + 0.125 * way.x), 1e-5);
            ASSERT_NEAR(albedo.y, 0.5 + 0.125 * way.y, 1e-5);
            ASSERT_NEAR(albedo.z, 0.8, 1e-5);
        }
    }
}

TEST(PathTracerRules, TexturesAreDecodedThenFilteredAndRepeated) {
    // 2 x 2 texels; row 0 lies at v = 0, which is the wall's top.
    const Texture texture{"texels", {2, 2}, {255, 0, 188, 0, 255, 188, 128, 128, 188, 0, 0, 188}};
    const auto decode = [](int code) { return double(decode_srgb(float(code) / 255.0f)); };
    const Camera camera = make_forward_camera();
    const float repeats = 1.5f;
    const Image direct =
        trace_light(LitScene({make_textured_wall(4.0f, -4.0f, repeats)}, {texture}), camera,
                    make_head_light(), make_settings())
            .direct;
    for (int y = 0; y < kTracedSize.height; ++y) {
        for (int x = 0; x < kTracedSize.width; ++x) {
            const glm::dvec3 way =
                4.0 * compute_pixel_direction(camera, kTracedSize, {x + 0.5, y + 0.5});
            const double u = repeats * (0.5 + 0.125 * way.x);
            const double v = repeats * (0.5 - 0.125 * way.y);
            // Between two repeated texels the share of the second is a triangle wave: 0 at u =
            // 1/4, 1 at u = 3/4.
            const auto share = [](double t) {
                return std::abs(2.0 * (t - 0.25 - std::floor(t - 0.25 + 0.5)));
            };
            const double right = share(u);
            const double low = share(v);
            const double grey = decode(128);
            const glm::vec3 albedo = get_pixel(direct, x, y);
            ASSERT_NEAR(albedo.x, (1 - low) * (1 - right) + low * (1 - right) * grey, 1e-5);
            ASSERT_NEAR(albedo.y, (1 - low) * right + low * (1 - right) * grey, 1e-5);
            ASSERT_NEAR(albedo.z, decode(188), 1e-5);
        }
    }
}

TEST(PathTracerRules, BouncesHaveTheSendersColour) {
    // A square that faces the floor, once with an albedo, once with vertex colours, once textured.
    const glm::vec3 red(0.7f, 0.1f, 0.1f);
    const auto measure = [&](const Mesh& sender, std::vector<Texture> textures) {
        Lights lights = make_surroundings(glm::vec3(0.0f));
        lights.directional.push_back({{0.0, -1.0, 0.0}, glm::vec3(3.0f), false});
        return compute_mean(
            trace_light(LitScene({make_floor(20.0f, 0.0f), sender}, std::move(textures)),
                        make_camera_above_zero(0.2), lights, make_settings())
                .indirect);
    };
    const Mesh square = paint(make_ceiling(0.5f, 0.4f), glm::vec3(1.0f));
    Mesh coloured = square;
    coloured.colors.assign(4, red);
    const Image by_albedo = measure(paint(square, red), {});
    const Image by_colour = measure(coloured, {});
    EXPECT_GT(compute_average(by_albedo).x, 0.02);
    EXPECT_NEAR(compute_average(by_albedo).y / compute_average(by_albedo).x, 1.0 / 7.0, 1e-5);
    EXPECT_LT(find_largest_difference(by_albedo, by_colour), 1e-6f);

    Mesh textured = square;
    textured.texture = 0;
    textured.texture_coordinates.assign(4, glm::vec2(0.5f));
    const Image by_texture = measure(textured, {{"red", {1, 1}, {200, 60, 60}}});
    const Image by_its_value =
        measure(paint(square, {decode_srgb(200.0f / 255.0f), decode_srgb(60.0f / 255.0f),
                               decode_srgb(60.0f / 255.0f)}),
                {});
    EXPECT_LT(find_largest_difference(by_texture, by_its_value), 1e-6f);
}

TEST(PathTracerRules, AnotherSceneGetsItsOwnTreeAndTextures) {
    const Camera camera = make_forward_camera();
    const LitScene white({make_textured_wall(4.0f, -4.0f, 1.0f)},
                         {{"white", {1, 1}, {255, 255, 255}}});
    const LitScene black({make_textured_wall(4.0f, -4.0f, 1.0f)}, {{"black", {1, 1}, {0, 0, 0}}});
    PathTracer tracer;
    for (const int turn : {0, 1, 0}) {
        tracer.update(pose_geometry(turn == 0 ? white : black, 0.0));
        const TracedRadiance traced =
            tracer.trace(camera, kTracedSize, make_head_light(), make_settings());
        EXPECT_NEAR(traced.direct.at(20, 20), turn == 0 ? 1.0f : 0.0f, 1e-5f);
    }
}

} // namespace
} // namespace alcove
