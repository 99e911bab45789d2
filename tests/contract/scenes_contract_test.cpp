// The contract of DESIGN 2 over every registered scene.
#include "core/contract/scene.hpp"
#include "scenes/registry.hpp"

#include <gtest/gtest.h>

namespace alcove {
namespace {

std::vector<SceneUnit> list_scenes() {
    const Registry<SceneUnit> registry = scenes_registry();
    return {registry.units().begin(), registry.units().end()};
}

class SceneContract : public testing::TestWithParam<SceneUnit> {
  protected:
    void SetUp() override {
        if (const auto obstacle = GetParam().find_obstacle()) {
            GTEST_SKIP() << *obstacle;
        }
        m_scene = GetParam().open(GetParam().parameters.resolve({}, {}));
    }
    std::unique_ptr<Scene> m_scene;
};

TEST_P(SceneContract, DescriptionIsComplete) {
    const SceneUnit& unit = GetParam();
    EXPECT_EQ(unit.name, unit.folder);
    EXPECT_FALSE(unit.title.empty());
    EXPECT_FALSE(unit.stresses.empty());
    EXPECT_FALSE(unit.license.empty());
    EXPECT_EQ(unit.content_hash.size(), 64u);
}

TEST_P(SceneContract, IsWholeAndFinite) {
    EXPECT_NO_THROW(check_scene(*m_scene, GetParam().name));
    EXPECT_EQ(m_scene->compute_pose(0.0).object_to_world.size(), m_scene->get_objects().size());
}

TEST_P(SceneContract, OpenedTwiceItIsTheSameBitForBit) {
    const std::unique_ptr<Scene> again = GetParam().open(GetParam().parameters.resolve({}, {}));
    EXPECT_EQ(hash_geometry(*m_scene, 0.0), hash_geometry(*again, 0.0));
    EXPECT_EQ(m_scene->get_walkthrough().cameras.size(), again->get_walkthrough().cameras.size());
}

TEST_P(SceneContract, FrameZeroIsACutAndTheWalkthroughMoves) {
    const Walkthrough& walkthrough = m_scene->get_walkthrough();
    ASSERT_FALSE(walkthrough.cuts.empty());
    EXPECT_EQ(walkthrough.cuts.front(), 0);
    EXPECT_FALSE(walkthrough.name.empty());
    if (GetParam().reported) {
        EXPECT_GE(walkthrough.cameras.size(), 120u);
        EXPECT_NE(walkthrough.cameras.front().position, walkthrough.cameras[60].position);
    }
}

INSTANTIATE_TEST_SUITE_P(All, SceneContract, testing::ValuesIn(list_scenes()),
                         [](const auto& unit) { return unit.param.name; });

} // namespace
} // namespace alcove
