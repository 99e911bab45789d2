// What the scenes that a builder each makes for the papers' figures have in common. What each of
// them is for: builders_facts_test.cpp.
#include "core/base/error.hpp"
#include "scenes/registry.hpp"
#include "tests/scenes/solid_check.hpp"
#include "tests/scenes/space_check.hpp"

#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace alcove {
namespace {

struct Builder {
    const char* name;
    std::vector<ParameterOverride> hardest; ///< of its parameters, for solids and shared faces
    double clearance_m = 0.1;               ///< of the camera
    std::vector<std::string> sizes;         ///< "key=value" in the order in which the scene grows
};

/// What a failed test says it was run with.
void PrintTo(const Builder& builder, std::ostream* stream) {
    *stream << builder.name;
}

const std::vector<Builder>& list_builders() {
    static const std::vector<Builder> kBuilders{
        {"pillars_in_a_row",
         {{"spacing", "0.1"}, {"diameter", "1.5"}},
         0.3,
         {"count=2", "count=12", "count=64"}},
        {"edge_on_slabs", {{"thickness", "0.2"}}, 0.3, {}},
        {"colour_blocks", {{"walkthrough", "turning"}}, 0.3, {}},
        {"molecule", {{"seed", "7"}}, 0.3, {"atoms=100", "atoms=400", "atoms=1000"}},
        {"closed_room", {{"props", "21"}}, 0.3, {"props=0", "props=1", "props=14", "props=21"}},
        {"pebbles", {{"height", "0.1"}}, 0.2, {"count=10", "count=350", "count=700"}},
        {"toes", {}, 0.05, {}},
        {"twisted_columns", {{"turns", "4"}}, 0.3, {}},
        {"factory", {{"detail", "0.5"}}, 0.3, {"detail=0.5", "detail=1", "detail=4"}},
        {"foliage_and_vehicle", {{"detail", "0.25"}}, 0.3, {"detail=0.25", "detail=1", "detail=4"}},
    };
    return kBuilders;
}

std::unique_ptr<Scene> open(const SceneUnit& unit,
                            const std::vector<ParameterOverride>& overrides) {
    return unit.open(unit.parameters.resolve(overrides, {}));
}

class BuiltScene : public testing::TestWithParam<Builder> {
  protected:
    Registry<SceneUnit> m_registry = scenes_registry();
    const SceneUnit& m_unit = m_registry.find(GetParam().name);
};

TEST_P(BuiltScene, IsReportedAndOpensSmall) {
    EXPECT_TRUE(m_unit.reported);
    const std::unique_ptr<Scene> scene = open(m_unit, {});
    EXPECT_LT(count_size(*scene).vertices, 80'000u);
    EXPECT_GT(scene->get_ao_radius_m(), 0.0);
}

TEST_P(BuiltScene, IsMadeOfClosedSolidsTurnedOutward) {
    for (const auto& overrides : {std::vector<ParameterOverride>{}, GetParam().hardest}) {
        const std::unique_ptr<Scene> scene = open(m_unit, overrides);
        check_scene(*scene, m_unit.name);
        for (const Mesh& mesh : scene->get_meshes()) {
            EXPECT_TRUE(mesh.closed) << mesh.name;
        }
    }
    const std::unique_ptr<Scene> scene = open(m_unit, GetParam().hardest);
    for (const Mesh& mesh : scene->get_meshes()) {
        const SolidCheck check = check_solid(mesh);
        EXPECT_EQ(check.open_edges, 0u) << mesh.name;
        EXPECT_GT(check.volume, 0.0) << mesh.name;
    }
}

TEST_P(BuiltScene, NoTwoObjectsShareAFace) {
    for (const auto& overrides : {std::vector<ParameterOverride>{}, GetParam().hardest}) {
        const std::unique_ptr<Scene> scene = open(m_unit, overrides);
        EXPECT_EQ(list_shared_faces(*scene, collect_triangles(*scene, scene->compute_pose(0.0))),
                  "");
    }
}

TEST_P(BuiltScene, TheCameraStaysClearOfAllSolidsOnEveryWalkthrough) {
    std::vector<std::vector<ParameterOverride>> variants{{}, GetParam().hardest};
    for (const ParameterTable::Entry& entry : m_unit.parameters.entries()) {
        for (const std::string& choice : entry.info.choices) {
            variants.push_back({{entry.info.name, choice}});
        }
    }
    const double clearance_m = GetParam().clearance_m;
    for (const auto& overrides : variants) {
        const std::unique_ptr<Scene> scene = open(m_unit, overrides);
        const Walkthrough& walkthrough = scene->get_walkthrough();
        const std::size_t last = walkthrough.cameras.size() - 1;
        constexpr std::size_t kSamples = 8;
        for (std::size_t i = 0; i <= kSamples; ++i) {
            const std::size_t frame = i * last / kSamples;
            const Pose pose = scene->compute_pose(static_cast<double>(frame) * walkthrough.step_s);
            const glm::dvec3& eye = walkthrough.cameras[frame].position;
            const Clearance clearance = measure_clearance(
                collect_triangles_near(*scene, pose, eye, 2.0 * clearance_m), eye);
            EXPECT_GT(clearance.distance_m, clearance_m) << "frame " << frame;
            EXPECT_FALSE(clearance.inside)
                << "frame " << frame << " inside "
                << scene->get_objects()[clearance.inside.value_or(0)].name;
        }
    }
}

TEST_P(BuiltScene, GrowsWithTheParametersThatSayHowMuchThereIs) {
    std::size_t before = 0;
    for (const std::string& size : GetParam().sizes) {
        const std::size_t equals = size.find('=');
        const std::unique_ptr<Scene> scene =
            open(m_unit, {{size.substr(0, equals), size.substr(equals + 1)}});
        const std::size_t triangles = count_size(*scene).triangles;
        EXPECT_GT(triangles, before) << size;
        before = triangles;
    }
}

TEST_P(BuiltScene, IsDecidedByItsParametersAlone) {
    const std::string hash = hash_geometry(*open(m_unit, {}), 0.0);
    EXPECT_EQ(hash, hash_geometry(*open(m_unit, {}), 0.0));
    for (const ParameterTable::Entry& entry : m_unit.parameters.entries()) {
        if (entry.info.name == "seed") {
            EXPECT_NE(hash, hash_geometry(*open(m_unit, {{"seed", "2"}}), 0.0));
        }
        if (entry.info.kind != ParameterKind::enumeration) {
            EXPECT_THROW(static_cast<void>(open(m_unit, {{entry.info.name, "-1"}})), InputError)
                << entry.info.name;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, BuiltScene, testing::ValuesIn(list_builders()),
                         [](const auto& tested) { return std::string(tested.param.name); });

} // namespace
} // namespace alcove
