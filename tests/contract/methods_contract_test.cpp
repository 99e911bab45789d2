// The contract of DESIGN 2 over every registered method.
#include "core/base/text.hpp"
#include "core/contract/method.hpp"
#include "core/frame/scene_renderer.hpp"
#include "methods/registry.hpp"
#include "tests/contract/hostile_method.hpp"
#include "tests/contract/method_shot.hpp"
#include "tests/core/gl/test_context.hpp"
#include "tests/test_scenes.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace alcove {
namespace {

constexpr ImageSize kCanarySize = ShotSettings{}.size;

std::vector<MethodUnit> list_methods() {
    const Registry<MethodUnit> registry = methods_registry();
    return {registry.units().begin(), registry.units().end()};
}

/// Of every image that a method left.
std::pair<std::uint64_t, std::uint64_t> hash_images(const Shot& shot) {
    return {hash_image(shot.visibility), hash_image(shot.radiance)};
}

class MethodContract : public GlTest, public testing::WithParamInterface<MethodUnit> {
  protected:
    static ResolvedParameters resolve(std::vector<ParameterOverride> overrides,
                                      double radius_m = 0.5) {
        return GetParam().parameters.resolve(overrides, {{"scene_radius", radius_m}});
    }

    /// "name=value,..." as overrides.
    static std::vector<ParameterOverride> read_settings(const std::string& text) {
        std::vector<ParameterOverride> overrides;
        for (const KeyValue& entry :
             text.empty() ? std::vector<KeyValue>{} : parse_key_values(text, "alive_with")) {
            overrides.push_back({entry.key, entry.value});
        }
        return overrides;
    }

    /// All frames of the test scene; the last one is kept.
    Shot shoot_fresh(const Scene& scene, const ResolvedParameters& parameters,
                     const ShotSettings& settings = {}) {
        const std::unique_ptr<Method> method = GetParam().create(context(), parameters);
        return shoot(context(), *method, scene, settings);
    }
};

TEST_P(MethodContract, DescriptionIsComplete) {
    const MethodUnit& unit = GetParam();
    EXPECT_EQ(unit.name, unit.folder);
    EXPECT_FALSE(unit.title.empty());
    EXPECT_FALSE(unit.citation.empty());
    EXPECT_EQ(unit.content_hash.size(), 64u);
    ASSERT_FALSE(unit.presets.empty());
    EXPECT_EQ(unit.presets.front().name, "default");
    EXPECT_TRUE(unit.presets.front().overrides.empty());
    for (const Preset& preset : unit.presets) {
        EXPECT_FALSE(preset.meaning.empty()) << preset.name;
        const bool is_own = preset.plane_tolerance != 1.0 || preset.plane_tolerance_75 != 2.0;
        EXPECT_EQ(is_own, !preset.plane_reason.empty())
            << preset.name << ": a tolerance needs its reason";
    }
    if (unit.converged_preset) {
        EXPECT_NO_THROW(static_cast<void>(unit.find_preset(*unit.converged_preset)));
    }
    for (const ParameterTable::Entry& entry : unit.parameters.entries()) {
        EXPECT_FALSE(entry.info.meaning.empty()) << entry.info.name;
        EXPECT_FALSE(entry.info.unit.empty()) << entry.info.name;
        EXPECT_FALSE(entry.info.source.empty()) << entry.info.name;
    }
}

TEST_P(MethodContract, ParametersRoundTrip) {
    const ParameterTable& table = GetParam().parameters;
    for (const ParameterTable::Entry& entry : table.entries()) {
        for (const bool maximum : {false, true}) {
            const std::string text = get_extreme(entry.info, maximum);
            EXPECT_EQ(to_text(resolve({{entry.info.name, text}}).get(entry.info.name)), text);
        }
    }
}

TEST_P(MethodContract, EveryParameterIsAliveOnTheCanary) {
    const TestScene scene = make_box_scene();
    TestScene shadowed = make_box_scene();
    shadowed.cast_shadows();
    for (const ParameterTable::Entry& entry : GetParam().parameters.entries()) {
        const ParameterInfo& info = entry.info;
        if (!info.inert_reason.empty()) {
            continue;
        }
        // A reference with its most rays takes minutes; 256 against 2 shows the same.
        const bool is_rays = GetParam().is_reference && info.name == "rays";
        const std::string top = is_rays ? "256" : get_extreme(info, true);
        std::vector<ParameterOverride> least_overrides = read_settings(info.alive_with);
        std::vector<ParameterOverride> most_overrides = least_overrides;
        least_overrides.push_back({info.name, get_extreme(info, false)});
        most_overrides.push_back({info.name, top});
        const auto changes_something = [&](const TestScene& canary) {
            const Shot least = shoot_fresh(canary, resolve(least_overrides));
            const Shot most = shoot_fresh(canary, resolve(most_overrides));
            return hash_images(least) != hash_images(most) || least.passes != most.passes;
        };
        // Of a method's own shadow maps the canary without shadows shows nothing.
        EXPECT_TRUE(changes_something(scene) || changes_something(shadowed))
            << info.name << " changes neither the image nor the passes";
    }
}

TEST_P(MethodContract, SamePlanTwiceIsTheSameImage) {
    const TestScene scene = make_box_scene();
    const std::unique_ptr<Method> dirt = make_hostile_method(gl());
    ShotSettings hostile;
    hostile.between = dirt.get();
    dirt->resize(hostile.size);
    const Shot first = shoot_fresh(scene, resolve({}));
    EXPECT_EQ(hash_images(first), hash_images(shoot_fresh(scene, resolve({}))));
    EXPECT_EQ(hash_images(first), hash_images(shoot_fresh(scene, resolve({}), hostile)))
        << "after a hostile method";
}

TEST_P(MethodContract, AResizeAndAResetLeaveNothingBehind) {
    const TestScene scene = make_box_scene();
    const Shot fresh = shoot_fresh(scene, resolve({}));
    const std::unique_ptr<Method> method = GetParam().create(context(), resolve({}));
    static_cast<void>(shoot(context(), *method, scene, {{37, 53}, {0, 1}, nullptr}));
    EXPECT_EQ(hash_images(fresh), hash_images(shoot(context(), *method, scene)));
    method->reset_history();
    EXPECT_EQ(hash_images(fresh), hash_images(shoot(context(), *method, scene)));
}

TEST_P(MethodContract, VisibilityIsBetweenZeroAndOneAndTheBackgroundExactlyOne) {
    const TestScene scene = make_box_scene();
    const GBuffer gbuffer(gl(), kCanarySize, kBaseChannels, {});
    SceneRenderer renderer(gl(), scene);
    context().reset_state();
    renderer.render(gbuffer, make_frame_view(scene.get_walkthrough(), 1, kCanarySize, false));
    const Image depth = gl::read_texture(gl(), gbuffer.texture(Channel::eye_depth), 1);
    for (const Preset& preset : GetParam().presets) {
        const Shot shot = shoot_fresh(scene, resolve(preset.overrides));
        for (std::size_t i = 0; i < depth.values().size(); ++i) {
            const float value = shot.visibility.values()[i];
            ASSERT_TRUE(value >= 0.0f && value <= 1.0f) << preset.name << " gives " << value;
            if (std::isinf(depth.values()[i])) {
                ASSERT_EQ(value, 1.0f) << preset.name;
            }
        }
    }
}

TEST_P(MethodContract, PlaneResponseHoldsAtEveryTilt) {
    if (!GetParam().plane_response) {
        GTEST_SKIP() << "the definition gives none";
    }
    const ImageSize size{384, 288};
    for (const Preset& preset : GetParam().presets) {
        for (const int tilt : {0, 15, 30, 45, 60, 75}) {
            const TestScene scene = make_plane_scene(tilt * std::numbers::pi / 180.0);
            const Image visibility =
                shoot_fresh(scene, resolve(preset.overrides), {size, {0}, nullptr}).visibility;
            double sum = 0.0;
            for (int y = 112; y < 176; ++y) {
                for (int x = 160; x < 224; ++x) {
                    sum += visibility.at(x, y);
                }
            }
            const double units = tilt <= 60 ? preset.plane_tolerance : preset.plane_tolerance_75;
            EXPECT_NEAR(sum / 4096.0, *GetParam().plane_response, units / 255.0)
                << preset.name << " at " << tilt << " degrees";
        }
    }
}

TEST_P(MethodContract, AWorldFarFromZeroLooksTheSame) {
    const Image near_zero = shoot_fresh(make_box_scene(), resolve({})).visibility;
    const Image far_away =
        shoot_fresh(make_box_scene(glm::dvec3(1e7, -1e7, 1e7)), resolve({})).visibility;
    for (std::size_t i = 0; i < near_zero.values().size(); ++i) {
        ASSERT_NEAR(near_zero.values()[i], far_away.values()[i], 1.0f / 255.0f) << "pixel " << i;
    }
}

TEST_P(MethodContract, AskingForTheHistoryStateDoesNotChangeTheImage) {
    const TestScene scene = make_box_scene();
    ShotSettings with_state;
    with_state.wants_history_state = true;
    const Shot asked = shoot_fresh(scene, resolve({}), with_state);
    EXPECT_EQ(hash_images(shoot_fresh(scene, resolve({}))), hash_images(asked));
    const bool has_history = GetParam().warm_frames(resolve({})) > 0;
    EXPECT_EQ(asked.history_state.empty(), !has_history);
}

TEST_P(MethodContract, TargetsAreMappedOrDeclined) {
    for (const Falloff falloff : {Falloff::none, Falloff::linear, Falloff::quadratic}) {
        Target target;
        target.radius_m = 0.375;
        target.falloff = falloff;
        const TargetMapping mapping = GetParam().map_target(target);
        EXPECT_TRUE(!mapping.overrides.empty() || !mapping.reason.empty())
            << "neither mapped nor declined";
        EXPECT_NO_THROW(static_cast<void>(resolve(mapping.overrides)));
    }
}

INSTANTIATE_TEST_SUITE_P(All, MethodContract, testing::ValuesIn(list_methods()),
                         [](const auto& unit) { return unit.param.name; });

} // namespace
} // namespace alcove
