#include "scenes/common/skinning.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace alcove {
namespace {

SkinInfluences make_influences(std::size_t vertices, std::vector<std::uint16_t> joints,
                               std::vector<float> weights) {
    SkinInfluences influences{joints.size(), {}, {}};
    for (std::size_t i = 0; i < vertices; ++i) {
        influences.joints.insert(influences.joints.end(), joints.begin(), joints.end());
        influences.weights.insert(influences.weights.end(), weights.begin(), weights.end());
    }
    return influences;
}

TEST(Skinning, BlendsMatricesAndTakesTheInverseTransposeForNormals) {
    const glm::dmat4 a = glm::translate(glm::dmat4(1.0), {1.0, 2.0, 3.0});
    const glm::dmat4 b = glm::rotate(glm::scale(glm::dmat4(1.0), {2.0, 1.0, 0.5}), 0.7,
                                     glm::normalize(glm::dvec3(1.0, 2.0, -1.0)));
    const std::vector<glm::vec3> points{{0.5f, -1.0f, 2.0f}, {3.0f, 0.0f, 0.25f}};
    const std::vector<glm::vec3> normals{glm::normalize(glm::vec3(1.0f, 1.0f, 0.0f)),
                                         glm::normalize(glm::vec3(0.0f, -1.0f, 2.0f))};
    const Deformation result =
        skin_vertices(points, normals, make_influences(2, {0, 1, 0, 0}, {0.25f, 0.75f, 0, 0}),
                      std::vector<glm::dmat4>{a, b});
    const glm::dmat4 blend = 0.25 * a + 0.75 * b;
    for (std::size_t i = 0; i < 2; ++i) {
        const glm::dvec3 point(blend * glm::dvec4(points[i], 1.0));
        const glm::dvec3 normal =
            glm::normalize(glm::inverseTranspose(glm::dmat3(blend)) * glm::dvec3(normals[i]));
        EXPECT_LT(glm::distance(glm::dvec3(result.positions[i]), point), 1e-6);
        EXPECT_LT(glm::distance(glm::dvec3(result.normals[i]), normal), 1e-6);
    }
}

TEST(Skinning, MirrorsAndFlatteningKeepNormalsUnit) {
    const std::vector<glm::vec3> one{{1.0f, 0.0f, 0.0f}};
    const SkinInfluences whole = make_influences(1, {0}, {1.0f});
    const glm::dmat4 mirror = glm::scale(glm::dmat4(1.0), {-1.0, 1.0, 1.0});
    EXPECT_EQ(skin_vertices(one, one, whole, std::vector{mirror}).normals[0],
              glm::vec3(-1.0f, 0.0f, 0.0f));
    const Deformation flat = skin_vertices(one, one, whole, std::vector{glm::dmat4(0.0)});
    EXPECT_EQ(flat.normals[0], one[0]);
    EXPECT_EQ(flat.positions[0], glm::vec3(0.0f));
}

TEST(Skinning, TakesMoreThanFourInfluences) {
    std::vector<glm::dmat4> joints;
    for (int i = 0; i < 6; ++i) {
        joints.push_back(glm::translate(glm::dmat4(1.0), {double(i), 0.0, 0.0}));
    }
    SkinInfluences influences = make_influences(1, {0, 1, 2, 3, 4, 5}, {1, 1, 1, 1, 1, 1});
    ASSERT_TRUE(normalise_weights(influences));
    const std::vector<glm::vec3> origin{glm::vec3(0.0f)};
    const std::vector<glm::vec3> up{{0.0f, 1.0f, 0.0f}};
    EXPECT_NEAR(skin_vertices(origin, up, influences, joints).positions[0].x, 2.5f, 1e-6f);
}

TEST(Skinning, RefusesWeightsThatCannotBeNormalised) {
    for (const float bad : {0.0f, -1.0f, std::numeric_limits<float>::quiet_NaN(),
                            std::numeric_limits<float>::infinity()}) {
        SkinInfluences influences = make_influences(1, {0}, {bad});
        EXPECT_FALSE(normalise_weights(influences)) << bad;
    }
}

} // namespace
} // namespace alcove
