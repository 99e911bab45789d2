#include "core/base/environment.hpp"

#include "core/base/error.hpp"

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
