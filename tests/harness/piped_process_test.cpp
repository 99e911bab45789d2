#include "core/base/error.hpp"
#include "harness/run/piped_process.hpp"
#include "tests/harness/temporary_folder.hpp"

#include <chrono>
#include <csignal>

#include <gtest/gtest.h>

namespace alcove {
namespace {

class PipedProcessTest : public ::testing::Test {
  protected:
    TemporaryFolder folder;
    std::filesystem::path log = folder.path() / "log";
};

TEST_F(PipedProcessTest, IsTalkedToLineByLine) {
    PipedProcess cat("/bin/cat", {}, log);
    EXPECT_TRUE(cat.write("first\nsec"));
    EXPECT_EQ(cat.read_line(), "first");
    EXPECT_TRUE(cat.write("ond\n"));
    EXPECT_EQ(cat.read_line(), "second");
}

TEST_F(PipedProcessTest, ArgumentsAreNotReadByAShell) {
    PipedProcess echo("/bin/echo", {"$HOME; `exit`", "a  b"}, log);
    EXPECT_EQ(echo.read_line(), "$HOME; `exit` a  b");
    EXPECT_EQ(echo.read_line(), std::nullopt);
    EXPECT_EQ(echo.finish().exit_code, 0);
}

TEST_F(PipedProcessTest, SaysHowItEnded) {
    PipedProcess code("/bin/sh", {"-c", "echo why >&2; exit 7"}, log);
    EXPECT_EQ(code.finish().exit_code, 7);
    EXPECT_EQ(code.read_log(), "why\n");
    PipedProcess signal("/bin/sh", {"-c", "kill -TERM $$"}, log);
    EXPECT_EQ(signal.finish().signal, SIGTERM);
}

TEST_F(PipedProcessTest, WritingToOneThatIsGoneIsNoSignal) {
    PipedProcess gone("/bin/true", {}, log);
    EXPECT_EQ(gone.finish().exit_code, 0);
    EXPECT_FALSE(gone.write("go\n"));
}

TEST_F(PipedProcessTest, DoesNotOutliveItsObject) {
    const auto begin = std::chrono::steady_clock::now();
    { const PipedProcess sleeping("/bin/sleep", {"600"}, log); }
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(60));
}

TEST_F(PipedProcessTest, RunsToItsEndWithinLimits) {
    using namespace std::chrono_literals;
    const ProcessLimits limits{60s, 100, 100};
    PipedProcess echo("/bin/sh", {"-c", "cat; echo out; echo err >&2; exit 3"}, log);
    EXPECT_EQ(echo.run_to_end(limits), "out\n");
    EXPECT_EQ(echo.finish().exit_code, 3);
    EXPECT_EQ(echo.read_log(), "err\n");
    PipedProcess exact("/bin/sh", {"-c", "head -c 100 /dev/zero"}, log);
    EXPECT_EQ(exact.run_to_end(limits).size(), 100u);
    PipedProcess more("/bin/sh", {"-c", "head -c 101 /dev/zero"}, log);
    EXPECT_THROW(static_cast<void>(more.run_to_end(limits)), FailureError);
    PipedProcess slow("/bin/sleep", {"600"}, log);
    EXPECT_THROW(static_cast<void>(slow.run_to_end({50ms, 100, 100})), FailureError);
}

TEST_F(PipedProcessTest, WhatCannotBeStartedIsNamed) {
    try {
        const PipedProcess nothing(folder.path() / "nothing", {}, log);
        FAIL() << "started";
    } catch (const FailureError& error) {
        EXPECT_NE(std::string(error.what()).find("nothing"), std::string::npos) << error.what();
    }
}

} // namespace
} // namespace alcove
