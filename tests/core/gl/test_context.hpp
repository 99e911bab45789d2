#pragma once
// The fixture of every test that draws: one context a process, and GL errors fail the test that
// made them.

#include "core/gl/context.hpp"

#include <memory>

#include <gtest/gtest.h>

namespace alcove {

class GlTest : public testing::Test {
  protected:
    static void SetUpTestSuite();
    static void TearDownTestSuite();
    void TearDown() override;
    [[nodiscard]] static gl::Context& context() { return *s_context; }
    [[nodiscard]] static const gl::Functions& gl() { return s_context->functions(); }

  private:
    static std::unique_ptr<gl::Context> s_context;
};

} // namespace alcove
