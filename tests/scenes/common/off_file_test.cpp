#include "scenes/common/off_file.hpp"

#include "core/base/error.hpp"

#include <cmath>
#include <string>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace alcove {
namespace {

constexpr const char* kCube = R"(OFF
# a cube of 2 units: six squares, one of them with a color
8 6 12
-1 -1 -1
1 -1 -1
1 1 -1
-1 1 -1

-1 -1 1
1 -1 1 # its corner
1 1 1
-1 1 1
4 3 2 1 0
4 4 5 6 7 255 0 0
4 0 1 5 4
4 2 3 7 6
4 1 2 6 5
4 0 4 7 3
)";

std::string find_error(const std::string& text) {
    try {
        static_cast<void>(parse_off(text, "model.off"));
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

TEST(OffFileTest, PolygonsBecomeFansWithSmoothOutwardNormals) {
    const Mesh mesh = parse_off(kCube, "cube.off");
    EXPECT_EQ(mesh.positions.size(), 8u);
    EXPECT_EQ(mesh.indices.size(), 36u);
    EXPECT_FALSE(mesh.closed);
    double volume = 0.0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto corner = [&](std::size_t k) {
            return glm::dvec3(mesh.positions[mesh.indices[i + k]]);
        };
        volume += glm::dot(corner(0), glm::cross(corner(1), corner(2))) / 6.0;
    }
    EXPECT_NEAR(volume, 8.0, 1e-12);
    for (std::size_t i = 0; i < 8; ++i) {
        // By angle, a corner of a cube looks along its diagonal.
        EXPECT_NEAR(glm::dot(mesh.normals[i], mesh.positions[i]), std::sqrt(3.0f), 1e-6f);
    }
}

TEST(OffFileTest, WhatIsWrongIsNamedWithItsLine) {
    EXPECT_NE(find_error("PLY\n").find("model.off:1: not an OFF file"), std::string::npos);
    EXPECT_NE(find_error("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 nan\n3 0 1 2\n").find("model.off:5"),
              std::string::npos);
    EXPECT_NE(find_error("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n")
                  .find("model.off:6: index out of range: found `3`, expected less than 3"),
              std::string::npos);
    EXPECT_NE(find_error("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n").find("corners"),
              std::string::npos);
    EXPECT_NE(find_error("OFF\n3 1 0\n0 0 0\n1 0 0\n").find("ends too early"), std::string::npos);
    EXPECT_NE(find_error("OFF\n4000000000 1 0\n0 0 0\n").find("promises more lines"),
              std::string::npos);
    EXPECT_NE(find_error("OFF\n1 0 0\n0 0 0\n").find("no triangles"), std::string::npos);
}

} // namespace
} // namespace alcove
