// Programs of others as metrics: what they are given, and every way in which they can fail.

#include "harness/run/external_metric.hpp"
#include "tests/harness/expect_error.hpp"
#include "tests/harness/temporary_folder.hpp"

#include <csignal>
#include <fstream>

namespace alcove {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

class ExternalMetricTest : public ::testing::Test {
  protected:
    /// A shell script that can be executed; `more` are words behind it.
    ExternalMetric make(const std::string& script, const std::string& more = "") const {
        const fs::path path = folder.write("program", "#!/bin/sh\n" + script + "\n");
        fs::permissions(path, fs::perms::owner_all);
        return parse_external_metric("exec:" + path.string() + " " + more, "--metric");
    }
    static std::vector<ExternalValue> call(const ExternalMetric& metric,
                                           std::chrono::milliseconds time = 60s) {
        return run_external_metric(metric, "a b.png", "/c.png", time);
    }
    void expect_failure(const std::string& script, std::initializer_list<const char*> parts,
                        std::chrono::milliseconds time = 60s) const {
        SCOPED_TRACE(script);
        expect_error([&] { static_cast<void>(call(make(script), time)); }, 1, parts);
    }

    TemporaryFolder folder;
};

TEST_F(ExternalMetricTest, GetsItsWordsAndTwoAbsolutePathsWithoutAShell) {
    const ExternalMetric metric =
        make(R"(printf '%s\n' "$@" > "$(dirname "$0")/seen"; echo '{"b":1,"a.x":-2.5e-3}')",
             " -q  $HOME;true");
    const std::vector<ExternalValue> values = call(metric);
    ASSERT_EQ(values.size(), 2u);
    EXPECT_EQ(values[0].name, "b");
    EXPECT_EQ(values[0].value, 1.0);
    EXPECT_EQ(values[1].name, "a.x");
    EXPECT_EQ(values[1].value, -2.5e-3);
    std::ifstream seen(folder.path() / "seen");
    const std::string text(std::istreambuf_iterator<char>(seen), {});
    EXPECT_EQ(text, "-q\n$HOME;true\n" + fs::absolute("a b.png").string() + "\n/c.png\n");
}

TEST_F(ExternalMetricTest, NullIsNoValue) {
    EXPECT_FALSE(call(make("echo '{\"x\":null}'")).front().value.has_value());
}

TEST_F(ExternalMetricTest, IsFoundAlongPath) {
    EXPECT_EQ(parse_external_metric("exec:sh -c x", "--metric").program.filename(), "sh");
    expect_error([] { static_cast<void>(parse_external_metric("exec:no_such_program", "here")); },
                 2, {"here", "no_such_program", "PATH"});
    expect_error([] { static_cast<void>(parse_external_metric("exec:  ", "here")); }, 2, {"here"});
    const std::string text = folder.write("text", "no program").string();
    expect_error([&] { static_cast<void>(parse_external_metric("exec:" + text, "here")); }, 2,
                 {"here", "text", "executed"});
}

TEST_F(ExternalMetricTest, WhatIsNoObjectOfNumbersIsRefused) {
    for (const char* answer : {"garbage", "", "[1]", "{}", "3", R"({"x":1} trailing)",
                               R"({"x":1e999})", R"({"x":NaN})", R"({"x":)"}) {
        expect_failure(std::string("cat <<'END'\n") + answer + "\nEND", {"program", "JSON object"});
    }
    for (const char* value : {"\"1\"", "true", "[1]", "{\"y\":1}"}) {
        expect_failure(std::string("cat <<'END'\n{\"x\":") + value + "}\nEND",
                       {"program", "`x`", "no number"});
    }
    for (const char* name : {"", "a b", "<script>", "x<1", "a/b"}) {
        expect_failure(std::string("cat <<'END'\n{\"") + name + "\":1}\nEND",
                       {"program", "cannot be a metric's name"});
    }
}

TEST_F(ExternalMetricTest, ADeathQuotesStandardErrorInOneLine) {
    expect_failure("echo '{\"x\":1}'; printf 'first\\n\\033[31mlast\\n' >&2; exit 7",
                   {"exit code 7", "first  [31mlast`"});
    expect_failure("kill -SEGV $$", {"signal 11"});
}

TEST_F(ExternalMetricTest, AHangEndsWithAllThatTheProgramStarted) {
    const auto begin = std::chrono::steady_clock::now();
    expect_failure("sleep 60 & echo $! > \"$(dirname \"$0\")/child\"; wait",
                   {"has not ended in time", "0.3 s"}, 300ms);
    // Without its streams too.
    expect_failure("exec >&- 2>&-; sleep 60", {"has not ended in time"}, 300ms);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, 30s);
    std::ifstream file(folder.path() / "child");
    int child = 0;
    file >> child;
    ASSERT_GT(child, 1);
    const auto is_running = [child] {
        std::ifstream status("/proc/" + std::to_string(child) + "/stat");
        std::string number;
        std::string name;
        std::string state;
        return status >> number >> name >> state && state != "Z";
    };
    for (int i = 0; i < 500 && is_running(); ++i) {
        ::usleep(10'000);
    }
    EXPECT_FALSE(is_running());
}

TEST_F(ExternalMetricTest, AChildThatKeepsThePipeOpenIsNotWaitedFor) {
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ(call(make("sleep 60 & echo '{\"x\":1}'")).front().value, 1.0);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, 30s);
}

TEST_F(ExternalMetricTest, FloodsAreCut) {
    expect_failure("head -c 10000000 /dev/zero; sleep 60",
                   {"too much", "standard output", "1048576"});
    // Not for ever: a flood that is not ended must not fill the disk.
    expect_failure("head -c 17000000 /dev/zero >&2; sleep 60", {"too much", "standard error"});
}

TEST_F(ExternalMetricTest, StandardInputIsClosed) {
    EXPECT_EQ(call(make("cat > /dev/null; echo '{\"x\":2}'")).front().value, 2.0);
}

} // namespace
} // namespace alcove
