// Contexts side by side: equal images wherever they end on the same rasteriser, and software never
// taken for a GPU.

#include "core/base/error.hpp"
#include "core/frame/scene_renderer.hpp"
#include "core/gl/egl_context.hpp"
#include "core/gl/glfw_context.hpp"
#include "core/gl/library.hpp"
#include "core/gl/osmesa_context.hpp"
#include "methods/registry.hpp"
#include "tests/contract/method_shot.hpp"
#include "tests/harness/temporary_folder.hpp"
#include "tests/test_scenes.hpp"

#include <array>
#include <cstdint>
#include <cstdlib>
#include <map>

#include <gtest/gtest.h>

namespace alcove {
namespace {

constexpr ImageSize kSize{96, 64};

std::unique_ptr<gl::Context> open_device() {
    return gl::open_egl_context(gl::EglPlatform::device, gl::EglDevices::software);
}

std::unique_ptr<gl::Context> open_surfaceless() {
    return gl::open_egl_context(gl::EglPlatform::surfaceless, gl::EglDevices::software);
}

/// Every channel of the G-buffer and the AO of two methods, one without and one with a history, in
/// both frames of the canary scene.
std::map<std::string, std::uint64_t> hash_frames(gl::Context& context) {
    const TestScene scene = make_box_scene();
    const Registry<MethodUnit> methods = methods_registry();
    std::map<std::string, std::uint64_t> hashes;
    for (const int frame : {0, 1}) {
        const std::string at = " of frame " + std::to_string(frame);
        ChannelSet channels;
        for (const ChannelInfo& info : kChannels) {
            channels.add(info.channel);
        }
        const GBuffer gbuffer(context.functions(), kSize, channels, {});
        SceneRenderer renderer(context.functions(), scene);
        context.reset_state();
        renderer.render(gbuffer, make_frame_view(scene.get_walkthrough(), frame, kSize, false));
        for (const ChannelInfo& info : kChannels) {
            hashes[std::string(info.name) + at] = hash_image(gl::read_texture(
                context.functions(), gbuffer.texture(info.channel), info.components));
        }
        for (const char* name : {"hemisphere_ssao", "tssao"}) {
            const MethodUnit& unit = methods.find(name);
            const std::unique_ptr<Method> method = unit.create(
                context, unit.parameters.resolve({}, {{"scene_radius", scene.get_ao_radius_m()}}));
            ShotSettings settings;
            settings.size = kSize;
            settings.frames.clear();
            for (int i = 0; i <= frame; ++i) { // frame 1 with the history of frame 0
                settings.frames.push_back(i);
            }
            hashes[name + at] = hash_image(shoot(context, *method, scene, settings).visibility);
        }
    }
    context.check_errors();
    return hashes;
}

std::string catch_message(const auto& action) {
    try {
        action();
    } catch (const Error& error) {
        return std::to_string(error.exit_code()) + " " + error.what();
    }
    return "nothing was thrown";
}

void expect_parts(const std::string& message, std::initializer_list<const char*> parts) {
    for (const char* part : parts) {
        EXPECT_NE(message.find(part), std::string::npos)
            << "`" << part << "` is missing in: " << message;
    }
}

TEST(ContextsTest, EglDrawsWhatOsmesaDraws) {
    std::map<std::string, std::uint64_t> expected;
    {
        const auto context = gl::open_osmesa_context();
        expected = hash_frames(*context);
        EXPECT_EQ(hash_frames(*context), expected) << "the yardstick itself must hold still";
    }
    ASSERT_EQ(expected.size(), 2 * (kChannels.size() + 2));
    {
        const auto context = open_device();
        EXPECT_EQ(context->device().context, "egl-device");
        EXPECT_EQ(context->device().device_class, "software");
        EXPECT_EQ(hash_frames(*context), expected);
    }
    {
        const auto context = open_surfaceless();
        EXPECT_EQ(context->device().context, "egl-surfaceless");
        EXPECT_EQ(context->device().device_class, "software");
        EXPECT_EQ(hash_frames(*context), expected);
    }
    const auto context = gl::open_osmesa_context();
    EXPECT_EQ(hash_frames(*context), expected) << "after EGL in the same process";
}

TEST(ContextsTest, AClosedEglDisplayCanBeOpenedAgain) {
    for (int i = 0; i < 3; ++i) {
        const auto context = open_device();
        GLint major = 0;
        context->functions().GetIntegerv(GL_MAJOR_VERSION, &major);
        EXPECT_EQ(major, 4);
        EXPECT_NO_THROW(context->check_errors());
    }
}

TEST(ContextsTest, SurfacelessSoftwareLeavesTheEnvironmentAsItWas) {
    for (const char* before : {"0", "false"}) {
        const ScopedVariable variable("LIBGL_ALWAYS_SOFTWARE", before);
        const auto context = open_surfaceless();
        EXPECT_STREQ(std::getenv("LIBGL_ALWAYS_SOFTWARE"), before);
    }
    ::unsetenv("LIBGL_ALWAYS_SOFTWARE");
    const auto context = open_surfaceless();
    EXPECT_EQ(std::getenv("LIBGL_ALWAYS_SOFTWARE"), nullptr);
}

TEST(ContextsTest, ASoftwareRendererIsRefusedByNameUnlessItIsAllowed) {
    // Whatever GPU a machine has, this makes Mesa's surfaceless platform a software renderer.
    const ScopedVariable software("LIBGL_ALWAYS_SOFTWARE", "1");
    const std::string message = catch_message([] {
        static_cast<void>(
            gl::open_egl_context(gl::EglPlatform::surfaceless, gl::EglDevices::hardware));
    });
    expect_parts(message, {"2 ", "--context egl", "llvmpipe", "--allow-software"});
    EXPECT_TRUE(gl::is_software(
        gl::open_egl_context(gl::EglPlatform::surfaceless, gl::EglDevices::any)->device()));
}

TEST(ContextsTest, EglNeverGivesSoftwareWithoutPermission) {
    bool has_gpu = true;
    const std::string message = catch_message([&] {
        has_gpu = false;
        const auto context = gl::open_context(gl::ContextKind::egl, gl::SoftwarePolicy::refuse);
        has_gpu = !gl::is_software(context->device());
    });
    if (!has_gpu) {
        expect_parts(message, {"2 ", "--context egl", "llvmpipe", "--allow-software"});
    }
    const auto allowed = gl::open_context(gl::ContextKind::egl, gl::SoftwarePolicy::allow);
    EXPECT_EQ(gl::is_software(allowed->device()), !has_gpu) << "a GPU goes before permission";
}

TEST(ContextsTest, GlfwWithoutADisplaySaysWhatToDo) {
    const ScopedVariable x11("DISPLAY", "");
    const ScopedVariable wayland("WAYLAND_DISPLAY", "");
    expect_parts(catch_message([] { static_cast<void>(gl::open_glfw_context()); }),
                 {"1 GLFW", "DISPLAY", "xvfb-run"});
}

TEST(ContextsTest, AnUnknownKindNamesTheNearest) {
    expect_parts(catch_message([] { static_cast<void>(gl::parse_context_kind("osmsea")); }),
                 {"2 --context", "osmsea", "auto, osmesa, egl, glfw", "nearest: osmesa"});
    expect_parts(catch_message([] { static_cast<void>(gl::parse_context_kind("gfw")); }),
                 {"nearest: glfw"});
    for (const char* name : {"auto", "osmesa", "egl", "glfw"}) {
        EXPECT_EQ(gl::to_text(gl::parse_context_kind(name)), name);
    }
}

TEST(ContextsTest, AMissingLibraryIsNamedWithItsPackage) {
    constexpr std::array kNames{"libalcove_nosuch.so.1"};
    EXPECT_FALSE(gl::can_open_library(kNames));
    expect_parts(catch_message([&] { const gl::Library library("Part", kNames, "libnosuch1"); }),
                 {"1 Part", "libalcove_nosuch.so.1", "libnosuch1"});
    constexpr std::array kSystem{"libalcove_nosuch.so.1", "libc.so.6"};
    const gl::Library library("libc", kSystem, "libc6");
    EXPECT_NE(library.find<void (*)()>("malloc"), nullptr);
    expect_parts(catch_message([&] { static_cast<void>(library.find<void (*)()>("no_such")); }),
                 {"1 libc", "no_such"});
}

} // namespace
} // namespace alcove
