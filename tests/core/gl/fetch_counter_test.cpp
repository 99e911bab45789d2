// Fetches counted by hand: a loop's, a branch's, of all kinds, and only in programs that are built
// while a counter lives.
#include "core/gl/fetch_counter.hpp"

#include "core/base/error.hpp"
#include "core/gl/program.hpp"
#include "tests/core/gl/test_context.hpp"

#include <array>

namespace alcove {
namespace {

constexpr std::array kFiles{
    EmbeddedFile{"loop.comp.glsl",
                 "layout(local_size_x = 8, local_size_y = 4) in;\n"
                 "layout(r32f, binding = 0) uniform image2D i;\n"
                 "layout(binding = 0) uniform sampler2D t;\n"
                 "void main() {\n"
                 "    ivec2 p = ivec2(gl_GlobalInvocationID.xy);\n"
                 "    float sum = imageLoad(i, p).r;\n"
                 "    for (int k = 0; k < p.x; ++k) {\n"
                 "        sum += texelFetch(t, ivec2(0), 0).r;\n"
                 "    }\n"
                 "    if (p.y == 0) {\n"
                 "        sum += textureLod(t, textureLod(t, vec2(0.5), 0.0).rg, 0.0).r;\n"
                 "    }\n"
                 "    imageStore(i, p, vec4(sum));\n"
                 "}\n"},
    EmbeddedFile{"gather.comp.glsl",
                 "layout(local_size_x = 1) in;\n"
                 "layout(r32f, binding = 0) uniform writeonly image2D i;\n"
                 "layout(binding = 0) uniform sampler2D t;\n"
                 "void main() { imageStore(i, ivec2(0), textureGather(t, vec2(0.5))); }\n"},
};

class FetchCounterTest : public GlTest {
  protected:
    FetchCounterTest() : m_image(gl(), GL_R32F, {8, 4}), m_texture(gl(), GL_R32F, {1, 1}) {}

    gl::Program build(const std::string& file) {
        return gl::build_program(gl(), {std::span<const EmbeddedFile>(kFiles)},
                                 {{GL_COMPUTE_SHADER, file}});
    }
    std::uint64_t count(gl::FetchCounter& counter, const gl::Program& program) {
        program.use();
        gl().BindImageTexture(0, m_image.get(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32F);
        gl().BindTextureUnit(0, m_texture.get());
        counter.begin();
        gl().DispatchCompute(1, 1, 1);
        return counter.read();
    }

    gl::Texture m_image;
    gl::Texture m_texture;
};

TEST_F(FetchCounterTest, CountsWhatIsExecutedNotWhatIsWritten) {
    gl::FetchCounter counter(context());
    const gl::Program program = build("loop.comp.glsl");
    // 32 loads; rows of 0 + 1 + ... + 7 = 28 in a loop; two nested lookups in the first row of 8.
    const std::uint64_t expected = 32 + 4 * 28 + 2 * 8;
    EXPECT_EQ(count(counter, program), expected);
    EXPECT_EQ(count(counter, program), expected) << "from zero every time";
    context().check_errors();
}

TEST_F(FetchCounterTest, ProgramsBuiltWithoutACounterDoNotCount) {
    const gl::Program before = build("loop.comp.glsl");
    gl::Program after;
    {
        gl::FetchCounter counter(context());
        EXPECT_EQ(count(counter, before), 0u);
    }
    after = build("loop.comp.glsl");
    gl::FetchCounter counter(context());
    EXPECT_EQ(count(counter, after), 0u);
}

TEST_F(FetchCounterTest, AFetchThatCannotBeCountedDoesNotCompile) {
    EXPECT_NO_THROW(static_cast<void>(build("gather.comp.glsl")));
    gl::FetchCounter counter(context());
    EXPECT_THROW(static_cast<void>(build("gather.comp.glsl")), FailureError);
}

} // namespace
} // namespace alcove
