#include "tests/core/gl/test_context.hpp"

namespace alcove {

std::unique_ptr<gl::Context> GlTest::s_context;

void GlTest::SetUpTestSuite() {
    s_context = gl::open_context(gl::ContextKind::autodetect);
}

void GlTest::TearDownTestSuite() {
    s_context.reset();
}

void GlTest::TearDown() {
    EXPECT_NO_THROW(s_context->check_errors());
}

} // namespace alcove
