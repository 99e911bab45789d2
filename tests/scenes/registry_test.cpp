// Properties of every registered scene.
#include "scenes/registry.hpp"

#include <iostream>

#include <gtest/gtest.h>

namespace alcove {
namespace {

std::unique_ptr<Scene> open_default(const SceneUnit& unit) {
    return unit.open(unit.parameters.resolve({}, {}));
}

TEST(ScenesRegistry, NamesEveryUnitAndItsFolder) {
    const Registry<SceneUnit> registry = scenes_registry();
    EXPECT_GE(registry.units().size(), 3u);
    for (const SceneUnit& unit : registry.units()) {
        EXPECT_EQ(unit.name, unit.folder);
        EXPECT_EQ(unit.parameters.owner(), unit.name);
        EXPECT_FALSE(unit.title.empty()) << unit.name;
        EXPECT_FALSE(unit.stresses.empty()) << unit.name;
        EXPECT_FALSE(unit.license.empty()) << unit.name;
        EXPECT_EQ(unit.content_hash.size(), 64u) << unit.name;
    }
    EXPECT_FALSE(registry.find("template_scene").reported);
}

TEST(ScenesRegistry, EveryScenePassesTheContractsCheck) {
    const Registry<SceneUnit> registry = scenes_registry(); // outlives the loop over its units
    for (const SceneUnit& unit : registry.units()) {
        if (const auto obstacle = unit.find_obstacle()) {
            std::cout << unit.name << " skipped: " << *obstacle << "\n";
            continue;
        }
        const std::unique_ptr<Scene> scene = open_default(unit);
        EXPECT_NO_THROW(check_scene(*scene, unit.name));
        EXPECT_FALSE(scene->get_walkthrough().cuts.empty()) << unit.name;
        EXPECT_GE(scene->get_walkthrough().cameras.size(), 30u) << unit.name;
        EXPECT_FALSE(scene->get_lights().directional.empty()) << unit.name;
    }
}

TEST(ScenesRegistry, EverySceneOpensTwiceWithTheSameBits) {
    const Registry<SceneUnit> registry = scenes_registry(); // outlives the loop over its units
    for (const SceneUnit& unit : registry.units()) {
        if (!unit.find_obstacle()) {
            EXPECT_EQ(hash_geometry(*open_default(unit), 0.0),
                      hash_geometry(*open_default(unit), 0.0))
                << unit.name;
        }
    }
}

} // namespace
} // namespace alcove
