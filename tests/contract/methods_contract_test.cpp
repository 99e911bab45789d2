// The contract of DESIGN 2 over every registered method.
#include "core/contract/method.hpp"
#include "core/frame/scene_renderer.hpp"
#include "methods/registry.hpp"
#include "tests/contract/hostile_method.hpp"
#include "tests/core/gl/test_context.hpp"
#include "tests/test_scenes.hpp"

#include <cmath>
#include <numbers>

namespace alcove {
namespace {

constexpr ImageSize kCanarySize{128, 96};
constexpr std::uint32_t kSeed = 1;

std::vector<MethodUnit> list_methods() {
    const Registry<MethodUnit> registry = methods_registry();
    return {registry.units().begin(), registry.units().end()};
}

/// What one frame of a method leaves behind.
struct Shot {
    Image visibility;
    std::vector<std::string> passes;
};

class MethodContract : public GlTest, public testing::WithParamInterface<MethodUnit> {
  protected:
    static ResolvedParameters resolve(std::vector<ParameterOverride> overrides,
                                      double radius_m = 0.5) {
        return GetParam().parameters.resolve(overrides, {{"scene_radius", radius_m}});
    }

    /// Renders frame 0 and 1 of the scene and returns the second, so that histories take part.
    Shot shoot(const Scene& scene, const ResolvedParameters& parameters,
               ImageSize size = kCanarySize, bool hostile = false) {
        const std::unique_ptr<Method> method = GetParam().create(context(), parameters);
        return shoot_with(*method, scene, size, hostile);
    }

    Shot shoot_with(Method& method, const Scene& scene, ImageSize size, bool hostile = false) {
        const MethodRequests requests = method.get_requests();
        const GBuffer gbuffer(gl(), size, kBaseChannels | requests.channels, {});
        SceneRenderer renderer(gl(), scene);
        const PosedGeometry geometry = pose_geometry(scene, 0.0);
        const std::unique_ptr<Method> dirt = make_hostile_method(gl());
        dirt->resize(size);
        method.resize(size);
        Shot shot;
        const int frames = static_cast<int>(scene.get_walkthrough().cameras.size());
        for (int frame = 0; frame < frames; ++frame) {
            const FrameView view = make_frame_view(scene.get_walkthrough(), frame, size, false);
            context().reset_state();
            renderer.render(gbuffer, view);
            MethodInputs inputs{view, gbuffer};
            inputs.geometry = requests.posed_geometry ? &geometry : nullptr;
            inputs.lights = &scene.get_lights();
            inputs.noise_seed = kSeed;
            if (hostile) {
                PassRecorder ignored(PassTiming::none);
                static_cast<void>(dirt->render(inputs, ignored));
            }
            context().reset_state();
            PassRecorder recorder(PassTiming::none);
            const MethodOutput output = method.render(inputs, recorder);
            shot.passes = recorder.names();
            shot.visibility = gl::read_texture(gl(), *output.visibility, 1);
            context().check_errors();
        }
        return shot;
    }

    static std::vector<ParameterOverride> preset_overrides(const Preset& preset) {
        return preset.overrides;
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
    for (const ParameterTable::Entry& entry : GetParam().parameters.entries()) {
        const ParameterInfo& info = entry.info;
        if (!info.inert_reason.empty()) {
            continue;
        }
        // A reference with its most rays takes minutes; 256 against 2 shows the same.
        const bool is_rays = GetParam().is_reference && info.name == "rays";
        const std::string top = is_rays ? "256" : get_extreme(info, true);
        const Shot least = shoot(scene, resolve({{info.name, get_extreme(info, false)}}));
        const Shot most = shoot(scene, resolve({{info.name, top}}));
        EXPECT_TRUE(hash_image(least.visibility) != hash_image(most.visibility) ||
                    least.passes != most.passes)
            << info.name << " changes neither the image nor the passes";
    }
}

TEST_P(MethodContract, SamePlanTwiceIsTheSameImage) {
    const TestScene scene = make_box_scene();
    const Shot first = shoot(scene, resolve({}));
    EXPECT_EQ(hash_image(first.visibility), hash_image(shoot(scene, resolve({})).visibility));
    EXPECT_EQ(hash_image(first.visibility),
              hash_image(shoot(scene, resolve({}), kCanarySize, true).visibility))
        << "after a hostile method";
}

TEST_P(MethodContract, AResizeAndAResetLeaveNothingBehind) {
    const TestScene scene = make_box_scene();
    const Shot fresh = shoot(scene, resolve({}));
    const std::unique_ptr<Method> method = GetParam().create(context(), resolve({}));
    static_cast<void>(shoot_with(*method, scene, {37, 53}));
    EXPECT_EQ(hash_image(fresh.visibility),
              hash_image(shoot_with(*method, scene, kCanarySize).visibility));
    method->reset_history();
    EXPECT_EQ(hash_image(fresh.visibility),
              hash_image(shoot_with(*method, scene, kCanarySize).visibility));
}

TEST_P(MethodContract, VisibilityIsBetweenZeroAndOneAndTheBackgroundExactlyOne) {
    const TestScene scene = make_box_scene();
    const GBuffer gbuffer(gl(), kCanarySize, kBaseChannels, {});
    SceneRenderer renderer(gl(), scene);
    context().reset_state();
    renderer.render(gbuffer, make_frame_view(scene.get_walkthrough(), 1, kCanarySize, false));
    const Image depth = gl::read_texture(gl(), gbuffer.texture(Channel::eye_depth), 1);
    for (const Preset& preset : GetParam().presets) {
        const Shot shot = shoot(scene, resolve(preset_overrides(preset)));
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
                shoot(scene, resolve(preset_overrides(preset)), size).visibility;
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
    const Image near_zero = shoot(make_box_scene(), resolve({})).visibility;
    const Image far_away =
        shoot(make_box_scene(glm::dvec3(1e7, -1e7, 1e7)), resolve({})).visibility;
    int different = 0;
    for (std::size_t i = 0; i < near_zero.values().size(); ++i) {
        different += std::abs(near_zero.values()[i] - far_away.values()[i]) > 1.0f / 255.0f ? 1 : 0;
    }
    // 1e7 m in double has steps of 2e-9 m: a pixel whose centre lies that close to a silhouette may
    // change sides.
    EXPECT_LE(different, 2);
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
