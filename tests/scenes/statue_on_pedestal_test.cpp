#include "scenes/statue_on_pedestal/statue_on_pedestal.hpp"

#include "scenes/common/bounds.hpp"
#include "tests/scenes/deforming_check.hpp"
#include "tests/scenes/solid_check.hpp"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

namespace alcove {
namespace {

std::unique_ptr<Scene> open(const std::string& piece, const std::string& detail = "0.2") {
    const SceneUnit unit = statue_on_pedestal_unit();
    const std::vector<ParameterOverride> overrides{{"piece", piece}, {"detail", detail}};
    return unit.open(unit.parameters.resolve(overrides, {}));
}

class StatueOnPedestal : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Pieces, StatueOnPedestal, testing::Values("knight", "knot"),
                         [](const auto& tested) { return std::string(tested.param); });

TEST_P(StatueOnPedestal, IsMadeOfClosedSolidsAndRests) {
    const std::unique_ptr<Scene> scene = open(GetParam());
    EXPECT_TRUE(scene->is_static());
    for (const Mesh& mesh : scene->get_meshes()) {
        const SolidCheck check = check_solid(mesh);
        EXPECT_EQ(check.open_edges, 0u) << mesh.name;
        EXPECT_GT(check.volume, 0.01) << mesh.name;
        EXPECT_TRUE(mesh.closed) << mesh.name;
        EXPECT_LE(count_inverted_corners(mesh), mesh.indices.size() / 500) << mesh.name;
    }
}

/// README.md: ray lengths of 160, 40, 10 and 2 units of 25 mm; the longest spans the model.
TEST_P(StatueOnPedestal, Has160UnitsAtMostFromCornerToCorner) {
    const std::unique_ptr<Scene> scene = open(GetParam());
    Bounds model;
    for (std::size_t object = 1; object < scene->get_objects().size(); ++object) { // no floor
        for (const glm::vec3& position : pose_mesh(*scene, object, 0.0).positions) {
            model.add(glm::dvec3(position));
        }
    }
    constexpr double kUnit_m = 0.025;
    EXPECT_LE(model.diagonal(), 160.0 * kUnit_m);
    EXPECT_GT(model.diagonal(), 0.6 * 160.0 * kUnit_m);
    EXPECT_EQ(scene->get_ao_radius_m(), 10.0 * kUnit_m);
}

TEST_P(StatueOnPedestal, StandsOnItsBaseAndTheCameraStaysClear) {
    const std::unique_ptr<Scene> scene = open(GetParam(), "0.1");
    double lowest = 1e30;
    for (const glm::vec3& position : pose_mesh(*scene, 3, 0.0).positions) {
        lowest = std::min(lowest, static_cast<double>(position.y));
    }
    EXPECT_NEAR(lowest, 1.19, 0.02);
    EXPECT_LT(lowest, 1.19);
    EXPECT_GT(measure_camera_clearance(*scene, 10), 0.25);
}

} // namespace
} // namespace alcove
