#include "core/gl/program.hpp"

#include "core/base/error.hpp"
#include "tests/core/gl/test_context.hpp"

#include <array>

namespace alcove {
namespace {

constexpr std::array kFiles{
    EmbeddedFile{"main.comp.glsl", "#include \"lib.glsl\"\n#include \"lib.glsl\"\n"
                                   "layout(local_size_x = 1) in;\n"
                                   "layout(r32f, binding = 0) uniform writeonly image2D i;\n"
                                   "void main() { imageStore(i, ivec2(0), vec4(twice(21.0))); }\n"},
    EmbeddedFile{"lib.glsl", "// a library\nfloat twice(float x) { return 2.0 * x; }\n"},
    EmbeddedFile{"broken.comp.glsl",
                 "layout(local_size_x = 1) in;\n\nvoid main() { undefined_name = 1; }\n"},
    EmbeddedFile{"broken_include.comp.glsl",
                 "layout(local_size_x = 1) in;\n#include \"bad.glsl\"\nvoid main() {}\n"},
    EmbeddedFile{"bad.glsl", "float ok;\nfloat f() { return missing; }\n"},
    EmbeddedFile{"after_include.comp.glsl",
                 "#include \"lib.glsl\"\nlayout(local_size_x = 1) in;\nvoid main() { wrong(); }\n"},
};

gl::ShaderLibrary make_library() {
    return {std::span<const EmbeddedFile>(kFiles)};
}

class ProgramTest : public GlTest {
  protected:
    std::string message_of(const std::string& file) {
        try {
            static_cast<void>(gl::build_program(gl(), make_library(), {{GL_COMPUTE_SHADER, file}}));
        } catch (const FailureError& error) {
            return error.what();
        }
        return "no error";
    }
};

TEST_F(ProgramTest, IncludesAreInsertedOnceAndRun) {
    const gl::Program program =
        gl::build_program(gl(), make_library(), {{GL_COMPUTE_SHADER, "main.comp.glsl"}});
    const gl::Texture texture(gl(), GL_R32F, {1, 1});
    program.use();
    gl().BindImageTexture(0, texture.get(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32F);
    gl().DispatchCompute(1, 1, 1);
    gl().MemoryBarrier(GL_ALL_BARRIER_BITS);
    EXPECT_EQ(gl::read_texture(gl(), texture, 1).at(0, 0), 42.0f);
}

TEST_F(ProgramTest, ErrorsNameFileAndLine) {
    EXPECT_NE(message_of("broken.comp.glsl").find("broken.comp.glsl:3"), std::string::npos)
        << message_of("broken.comp.glsl");
}

TEST_F(ProgramTest, ErrorsInIncludesSayWhoIncluded) {
    const std::string message = message_of("broken_include.comp.glsl");
    EXPECT_NE(message.find("bad.glsl:2 (included from broken_include.comp.glsl:2)"),
              std::string::npos)
        << message;
}

TEST_F(ProgramTest, LinesAfterAnIncludeCountOn) {
    const std::string message = message_of("after_include.comp.glsl");
    EXPECT_NE(message.find("after_include.comp.glsl:3"), std::string::npos) << message;
}

TEST_F(ProgramTest, UnknownFilesGetTheNearestName) {
    EXPECT_NE(message_of("main.cmp.glsl").find("main.comp.glsl"), std::string::npos);
}

TEST_F(ProgramTest, GeneratedFilesComeBeforeTheLibrary) {
    const gl::ExpandedSource source = gl::expand_includes(
        make_library(), "broken_include.comp.glsl", {{"bad.glsl", "const int answer = 42;\n"}});
    EXPECT_NE(source.text.find("answer = 42"), std::string::npos);
    ASSERT_EQ(source.files.size(), 2u);
    EXPECT_EQ(source.files[1].included_from, "broken_include.comp.glsl:2");
}

} // namespace
} // namespace alcove
