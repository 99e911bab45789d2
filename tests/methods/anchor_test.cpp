// The yardstick must not move: its text is pinned. And the control beside it, `none`.
#include "core/base/hash.hpp"
#include "methods/anchor/anchor.hpp"
#include "methods/common/shaders.hpp"
#include "methods/none/none.hpp"
#include "tests/methods/depth_image_rig.hpp"

#include <algorithm>

namespace alcove {
namespace {

using AnchorTest = DepthImageTest;

TEST_F(AnchorTest, ItsTextIsThatOfItsVersion) {
    const gl::ShaderLibrary library = make_method_shader_library();
    const std::string_view text = library.find("methods/anchor/anchor.frag.glsl");
    EXPECT_STREQ(kAnchorVersion, "1");
    EXPECT_EQ(Hasher().add(text).finish_hex(), "f9ca5d67c3f33ceda737e5f2f52483a6")
        << "anchor.frag.glsl changed: raise kAnchorVersion in anchor.hpp, then pin the new version "
           "and hash here. Times "
           "against different versions are never compared.";
}

TEST_F(AnchorTest, ItIncludesNothingAndHasNoParameters) {
    const gl::ShaderLibrary library = make_method_shader_library();
    EXPECT_EQ(library.find("methods/anchor/anchor.frag.glsl").find("#include"),
              std::string_view::npos);
    EXPECT_TRUE(anchor_unit().parameters.entries().empty());
    EXPECT_EQ(anchor_unit().presets.size(), 1u);
    EXPECT_FALSE(anchor_unit().reported);
}

TEST_F(AnchorTest, ThirtyTwoDifferentTexelsAreCompared) {
    // One texel is nearer than all others: every pixel that fetches it, except itself, misses 1
    // of 32.
    DepthImage image = make_wall_image({64, 64}, 2.0f);
    image.depth.at(31, 33) = 1.0f;
    const MethodUnit unit = anchor_unit();
    const RigResult result = run(unit, resolve(unit, "default", {}), image);
    EXPECT_EQ(result.passes, std::vector<std::string>{"anchor/fetch"});
    const std::span<const float> values = result.visibility.values();
    EXPECT_EQ(std::count(values.begin(), values.end(), 31.0f / 32.0f), 32);
    EXPECT_EQ(std::count(values.begin(), values.end(), 1.0f), 64 * 64 - 32);
}

TEST_F(AnchorTest, NoneDrawsNothingAndIsOpen) {
    DepthImage image = make_wall_image({16, 12}, 2.0f);
    image.depth.at(3, 4) = 1.0f;
    const MethodUnit unit = none_unit();
    const RigResult result = run(unit, resolve(unit, "default", {}), image);
    EXPECT_TRUE(result.passes.empty());
    EXPECT_FALSE(unit.has_passes);
    const std::span<const float> values = result.visibility.values();
    EXPECT_EQ(std::count(values.begin(), values.end(), 1.0f), 16 * 12);
}

} // namespace
} // namespace alcove
