// The contract of DESIGN 2 over every registered scene.
#include "core/base/error.hpp"
#include "core/contract/scene.hpp"
#include "scenes/registry.hpp"

#include <algorithm>
#include <iostream>
#include <string_view>
#include <vector>

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

/// True if the camera, an object or a light is not where it was on frame 0.
bool has_moved(const Scene& scene, std::size_t frame) {
    const Walkthrough& walkthrough = scene.get_walkthrough();
    const Camera& camera = walkthrough.cameras[frame];
    const Camera& first = walkthrough.cameras.front();
    return camera.position != first.position || camera.world_from_view != first.world_from_view ||
           camera.fov_y_radians != first.fov_y_radians ||
           scene.compute_pose(static_cast<double>(frame) * walkthrough.step_s).object_to_world !=
               scene.compute_pose(0.0).object_to_world ||
           hash_lights(scene, static_cast<double>(frame) * walkthrough.step_s) !=
               hash_lights(scene, 0.0);
}

/// False if the variant needs data that a set-up fetches and that are not here.
bool can_open(const SceneUnit& unit, const std::vector<ParameterOverride>& overrides) {
    try {
        static_cast<void>(unit.open(unit.parameters.resolve(overrides, {})));
    } catch (const InputError& error) {
        const std::string_view message = error.what();
        if (message.find("npm ci") == std::string_view::npos &&
            message.find("alcove scene fetch") == std::string_view::npos) {
            throw;
        }
        std::cout << unit.name << ":" << overrides[0].value << " skipped: " << error.what() << "\n";
        return false;
    }
    return true;
}

/// A scene is opened with all its choices, one at a time beside the defaults.
std::vector<std::vector<ParameterOverride>> list_variants(const SceneUnit& unit) {
    std::vector<std::vector<ParameterOverride>> variants{{}};
    for (const ParameterTable::Entry& entry : unit.parameters.entries()) {
        for (const std::string& choice : entry.info.choices) {
            if (can_open(unit, {{entry.info.name, choice}})) {
                variants.push_back({{entry.info.name, choice}});
            }
        }
    }
    return variants;
}

TEST_P(SceneContract, FrameZeroIsACutAndSomethingMoves) {
    for (const auto& overrides : list_variants(GetParam())) {
        const auto scene = GetParam().open(GetParam().parameters.resolve(overrides, {}));
        const std::string variant = overrides.empty() ? "default" : overrides[0].value;
        EXPECT_NO_THROW(check_scene(*scene, GetParam().name)) << variant;
        const Walkthrough& walkthrough = scene->get_walkthrough();
        ASSERT_FALSE(walkthrough.cuts.empty()) << variant;
        EXPECT_EQ(walkthrough.cuts.front(), 0) << variant;
        EXPECT_FALSE(walkthrough.name.empty()) << variant;
        if (GetParam().reported) {
            const std::size_t frames = walkthrough.cameras.size();
            EXPECT_GE(frames, 120u) << variant;
            bool moves = false;
            for (std::size_t frame = 1; frame < frames && !moves; ++frame) {
                moves = has_moved(*scene, frame);
            }
            EXPECT_TRUE(moves) << variant;
        }
    }
}

void expect_still_objects_to_stand(const Scene& scene, const Pose& first, const Pose& now) {
    for (std::size_t i = 0; i < now.object_to_world.size(); ++i) {
        const Object& object = scene.get_objects()[i];
        ASSERT_TRUE(object.motion != ObjectMotion::still ||
                    now.object_to_world[i] == first.object_to_world[i])
            << object.name << " moves";
    }
}

TEST_P(SceneContract, StateComesFromTheTimeAlone) {
    for (const auto& overrides : list_variants(GetParam())) {
        const auto scene = GetParam().open(GetParam().parameters.resolve(overrides, {}));
        const double step_s = scene->get_walkthrough().step_s;
        const auto frames = static_cast<int>(scene->get_walkthrough().cameras.size());
        // Every frame of a short walkthrough, some hundred of a long one: poses are large.
        const int stride = std::max(1, frames / 200);
        std::vector<Pose> forward;
        bool differs = false;
        for (int frame = 0; frame < frames; frame += stride) {
            forward.push_back(scene->compute_pose(frame * step_s));
            expect_still_objects_to_stand(*scene, forward.front(), forward.back());
            differs = differs || forward.back().object_to_world != forward[0].object_to_world;
        }
        for (auto pose = forward.rbegin(); pose != forward.rend(); ++pose) {
            const int frame = stride * static_cast<int>(forward.rend() - pose - 1);
            EXPECT_EQ(scene->compute_pose(frame * step_s).object_to_world, pose->object_to_world)
                << frame;
        }
        const std::span<const Object> objects = scene->get_objects();
        const bool deforms = std::any_of(objects.begin(), objects.end(), [](const Object& object) {
            return object.motion == ObjectMotion::deforming;
        });
        EXPECT_EQ(scene->is_static(), !differs && !deforms);
    }
}

INSTANTIATE_TEST_SUITE_P(All, SceneContract, testing::ValuesIn(list_scenes()),
                         [](const auto& unit) { return unit.param.name; });

} // namespace
} // namespace alcove
