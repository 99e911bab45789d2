#include "core/base/error.hpp"
#include "core/gl/handles.hpp"
#include "tests/core/gl/test_context.hpp"

namespace alcove {
namespace {

using ContextTest = GlTest;

TEST_F(ContextTest, IsOpenGl45AndSaysWhatItIs) {
    GLint major = 0;
    GLint minor = 0;
    gl().GetIntegerv(GL_MAJOR_VERSION, &major);
    gl().GetIntegerv(GL_MINOR_VERSION, &minor);
    EXPECT_GE(10 * major + minor, 45);
    EXPECT_EQ(context().device().device_class, "software");
    EXPECT_EQ(context().device().context, "osmesa");
}

TEST_F(ContextTest, GlErrorsAreThrownOnce) {
    gl().Enable(0xFFFF);
    EXPECT_THROW(context().check_errors(), FailureError);
    EXPECT_NO_THROW(context().check_errors());
}

TEST_F(ContextTest, ImagesSurviveTheDeviceTopRowFirst) {
    Image image({3, 2}, 1);
    for (int i = 0; i < 6; ++i) {
        image.values()[static_cast<std::size_t>(i)] = static_cast<float>(i);
    }
    const gl::Texture texture(gl(), GL_R32F, {3, 2});
    gl::write_texture(gl(), texture, image);
    EXPECT_EQ(hash_image(gl::read_texture(gl(), texture, 1)), hash_image(image));
}

TEST_F(ContextTest, HandlesMoveAndFree) {
    GLuint name = 0;
    {
        gl::Texture first(gl(), GL_R32F, {4, 4});
        name = first.get();
        const gl::Texture second = std::move(first);
        EXPECT_EQ(second.get(), name);
        EXPECT_FALSE(
            first); // NOLINT(bugprone-use-after-move): emptiness after a move is what is tested
    }
    // A freed name is no texture any more.
    gl().BindTextureUnit(0, name);
    EXPECT_THROW(context().check_errors(), FailureError);
}

TEST_F(ContextTest, ResetStateUndoesAHostilePass) {
    gl().Enable(GL_BLEND);
    gl().Enable(GL_DEPTH_TEST);
    gl().ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    gl().ClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
    context().reset_state();
    const gl::Texture texture(gl(), GL_R32F, {1, 1});
    const gl::FramebufferHandle framebuffer = gl::create_framebuffer(gl(), {&texture});
    const float value = 2.0f;
    gl().ClearNamedFramebufferfv(framebuffer.get(), GL_COLOR, 0, &value);
    EXPECT_EQ(gl::read_texture(gl(), texture, 1).at(0, 0), 2.0f);
    GLint origin = 0;
    gl().GetIntegerv(GL_CLIP_ORIGIN, &origin);
    EXPECT_EQ(origin, GL_LOWER_LEFT);
}

} // namespace
} // namespace alcove
