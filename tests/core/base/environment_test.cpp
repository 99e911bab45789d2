#include "core/base/environment.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

glm::dvec3 make_direction(int i) {
    const double height = 1.0 - (2.0 * i + 1.0) / 500.0;
    const double angle = 2.399963 * i;
    const double radius = std::sqrt(1.0 - height * height);
    return {radius * std::cos(angle), height, radius * std::sin(angle)};
}

TEST(environment, octahedral_coordinates_lead_back_to_the_direction) {
    for (int i = 0; i < 500; ++i) {
        const glm::dvec3 direction = make_direction(i);
        const glm::dvec2 coordinates = encode_octahedral(3.0 * direction);
        EXPECT_GE(std::min(coordinates.x, coordinates.y), 0.0);
        EXPECT_LE(std::max(coordinates.x, coordinates.y), 1.0);
        EXPECT_LT(glm::distance(decode_octahedral(coordinates), direction), 1e-12);
    }
}

TEST(environment, the_pole_lies_in_the_middle_and_x_goes_with_u) {
    EXPECT_EQ(encode_octahedral({0.0, 1.0, 0.0}), glm::dvec2(0.5, 0.5));
    EXPECT_EQ(encode_octahedral({1.0, 0.0, 0.0}), glm::dvec2(1.0, 0.5));
    EXPECT_EQ(encode_octahedral({0.0, 0.0, 1.0}), glm::dvec2(0.5, 1.0));
}

TEST(environment, constant_light_is_constant_before_and_after_the_filter) {
    const Environment grey([](const glm::dvec3&) { return glm::vec3(0.5f, 0.25f, 2.0f); }, "test");
    for (int i = 0; i < 500; i += 7) {
        EXPECT_EQ(grey.look_up(make_direction(i)), glm::vec3(0.5f, 0.25f, 2.0f));
    }
    EXPECT_NEAR(grey.prefiltered().at(3, 17, 2), 2.0f, 1e-6f);
}

// Irradiance / pi below a sky of 1 over nothing, on a normal that leans by an angle: (1 + cos) / 2.
TEST(environment, prefiltered_half_sky_is_the_analytic_one) {
    const Environment sky([](const glm::dvec3& d) { return glm::vec3(d.y > 0.0 ? 1.0f : 0.0f); },
                          "test");
    const int side = Environment::kPrefilteredSide;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const glm::dvec3 n = decode_octahedral({(x + 0.5) / side, (y + 0.5) / side});
            // 0.002: texels of 1.4 degrees, each told by its middle.
            EXPECT_NEAR(sky.prefiltered().at(x, y), 0.5 + 0.5 * n.y, 0.002);
        }
    }
}

TEST(environment, equirectangular_columns_turn_from_minus_z_to_plus_x) {
    Image image({64, 32}, 3);
    for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 64; ++x) {
            image.at(x, y, 0) = y < 16 ? 1.0f : 0.0f;            // red above
            image.at(x, y, 1) = x >= 40 && x < 56 ? 1.0f : 0.0f; // green around +x
        }
    }
    const Environment map = Environment::from_equirectangular(image, "test");
    EXPECT_EQ(map.look_up({0.2, 1.0, 0.0}).x, 1.0f);
    EXPECT_EQ(map.look_up({0.2, -1.0, 0.0}).x, 0.0f);
    EXPECT_EQ(map.look_up({1.0, 0.1, 0.0}).y, 1.0f);
    EXPECT_EQ(map.look_up({-1.0, 0.1, 0.0}).y, 0.0f);
    EXPECT_EQ(map.look_up({0.0, 0.1, -1.0}).y, 0.0f);
}

// One bright pixel of a map 8 times as fine as the texels: its light must not fall between
// directions. Solid angle of a pixel at the equator: (2 pi / 4096)^2.
TEST(environment, a_single_bright_pixel_keeps_its_energy) {
    Image image({4096, 2048}, 3);
    for (int channel = 0; channel < 3; ++channel) {
        image.at(2048 + 1000, 900, channel) = 1e6f;
    }
    const Environment map = Environment::from_equirectangular(image, "test");
    double sum = 0.0;
    for (const float value : map.radiance().values()) {
        sum += value / 3.0;
    }
    const double angle = 2.0 * std::numbers::pi / 4096.0;
    const double latitude = (0.5 - 900.5 / 2048.0) * std::numbers::pi;
    const double expected = 1e6 * angle * angle * std::cos(latitude);
    // Texels' solid angles vary by a factor of 3 around their mean 4 pi / 128^2; 16 % is what
    // 8x8 directions leave of a light that covers a part of one texel.
    const double mean_texel = 4.0 * std::numbers::pi / (128.0 * 128.0);
    EXPECT_GT(sum * mean_texel, expected / 2.5);
    EXPECT_LT(sum * mean_texel, expected * 2.5);
}

TEST(environment, interpolation_meets_the_texels_in_their_middles_and_lies_between_them_elsewhere) {
    const Environment sky(
        [](const glm::dvec3& d) { return glm::vec3(static_cast<float>(2.0 + d.x + 0.5 * d.y)); },
        "test");
    const double side = Environment::kSide;
    for (int i = 10; i < 110; i += 9) {
        const glm::dvec3 middle = decode_octahedral({(i + 0.5) / side, (70 - i / 2 + 0.5) / side});
        EXPECT_NEAR(sky.interpolate(middle).x, sky.look_up(middle).x, 1e-6f);
        const glm::dvec3 between = decode_octahedral({(i + 1.0) / side, (70 - i / 2 + 0.5) / side});
        // Linear light: half way between two texels is their mean, to second order.
        EXPECT_NEAR(sky.interpolate(between).x, 2.0 + between.x + 0.5 * between.y, 1e-3);
    }
}

TEST(environment, a_texel_beyond_the_border_is_the_neighbour_on_the_sphere) {
    const int side = Environment::kSide;
    const auto look_at = [side](const glm::ivec2& texel) {
        return decode_octahedral({(texel.x + 0.5) / side, (texel.y + 0.5) / side});
    };
    for (int i = 0; i < side; ++i) {
        for (const glm::ivec2& step :
             {glm::ivec2(-1, 0), glm::ivec2(1, 0), glm::ivec2(0, -1), glm::ivec2(0, 1)}) {
            const glm::ivec2 edge(step.x == 0 ? i : (step.x < 0 ? 0 : side - 1),
                                  step.y == 0 ? i : (step.y < 0 ? 0 : side - 1));
            // At the border's middle a step is 1 / 64 of the way between axes: 0.016 to 0.022.
            EXPECT_LT(glm::distance(look_at(edge), look_at(wrap_octahedral(edge + step, side))),
                      0.035)
                << i << " " << step.x << " " << step.y;
        }
    }
    EXPECT_EQ(wrap_octahedral({-1, -1}, side), glm::ivec2(side - 1));
    EXPECT_EQ(wrap_octahedral({side, -1}, side), glm::ivec2(0, side - 1));
    EXPECT_EQ(wrap_octahedral({5, 77}, side), glm::ivec2(5, 77));
    EXPECT_EQ(wrap_octahedral({-1, 1}, 1), glm::ivec2(0));
}

TEST(environment, interpolation_has_no_seam_where_the_map_ends) {
    // The border is the lower half of the planes x = 0 and z = 0.
    const Environment sky(
        [](const glm::dvec3& d) {
            return glm::vec3(static_cast<float>(1.0 + std::sin(60.0 * d.x) * std::cos(50.0 * d.z)));
        },
        "test");
    float steepest = 0.0f;
    for (int i = 0; i < 400; ++i) {
        const double angle = (i + 0.5) / 400.0 * std::numbers::pi;
        for (const bool in_x : {false, true}) {
            const auto look = [&](double across) {
                const double along = std::cos(angle);
                const double height = -std::sin(angle);
                return sky
                    .interpolate(in_x ? glm::dvec3(along, height, across)
                                      : glm::dvec3(across, height, along))
                    .x;
            };
            EXPECT_NEAR(look(-1e-7), look(1e-7), 1e-4f) << angle;
            // A texel further the light is another: the test would see a seam.
            steepest = std::max(steepest, std::abs(look(-0.02) - look(0.02)));
        }
    }
    EXPECT_GT(steepest, 0.5f);
}

TEST(environment, refuses_what_is_no_light_and_no_map) {
    const auto bad = [](const glm::dvec3&) {
        return glm::vec3(std::numeric_limits<float>::quiet_NaN());
    };
    EXPECT_THROW(Environment(bad, "test"), InputError);
    EXPECT_THROW(Environment([](const glm::dvec3&) { return glm::vec3(-1.0f); }, "test"),
                 InputError);
    EXPECT_THROW(static_cast<void>(Environment::from_equirectangular(Image({32, 32}, 3), "test")),
                 InputError);
    EXPECT_THROW(static_cast<void>(Environment::from_equirectangular(Image({64, 32}, 1), "test")),
                 InputError);
}

} // namespace
} // namespace alcove
