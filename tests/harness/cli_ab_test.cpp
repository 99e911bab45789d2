// `alcove ab` of the built program against itself and against sides that fail.

#include "core/base/file.hpp"
#include "reports/record/csv.hpp"
#include "reports/record/record.hpp"
#include "tests/harness/program.hpp"

namespace alcove {
namespace {

namespace fs = std::filesystem;

class AbVerb : public ProgramTest {
  protected:
    /// A side that is no alcove: a shell script.
    static std::string write_script(const std::string& name, const std::string& body) {
        const fs::path path = write(name, "#!/bin/sh\n" + body);
        fs::permissions(path, fs::perms::owner_all);
        return path;
    }
    /// The built program against `next` on a tiny experiment.
    static ChildResult compare_with(const std::string& next, const std::string& out) {
        return run({"ab", program(), next, "--scene", "template_scene", "--method",
                    "hemisphere_ssao", "--size", "64x48", "--frames", "0:4", "--repeat", "5",
                    "--out", out});
    }
    /// Side and step of every turn.
    static std::vector<std::pair<std::string, std::string>> read_turns(const std::string& out) {
        const std::string text = read_file(folder() / out / "turns.csv");
        CsvReader reader(text, "turns.csv");
        std::vector<std::string> fields;
        EXPECT_TRUE(reader.next(fields));
        EXPECT_EQ(fields, (std::vector<std::string>{"side", "step", "begin_s", "end_s"}));
        std::vector<std::pair<std::string, std::string>> turns;
        double last_end = 0.0;
        while (reader.next(fields)) {
            turns.emplace_back(fields.at(0), fields.at(1));
            EXPECT_LE(last_end, std::stod(fields.at(2)) + 1e-3) << "two turns at a time";
            last_end = std::stod(fields.at(3));
        }
        return turns;
    }
};

TEST_F(AbVerb, TheProgramAgainstItselfTakesTurnsAndLeavesTwoWholeRuns) {
    const ChildResult result = compare_with(program(), "twice");
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.out.find("images are identical"), std::string::npos) << result.out;
    for (const char* side : {"base", "new"}) {
        EXPECT_TRUE(RunFolder::open(folder() / "twice" / side).is_complete());
    }
    EXPECT_EQ(RunFolder::open(folder() / "twice" / "base").context().timer_mode,
              RunFolder::open(folder() / "twice" / "new").context().timer_mode);
    for (const char* file : {"comparison.csv", "comparison.md", "comparison.html"}) {
        EXPECT_GT(fs::file_size(folder() / "twice" / file), 0u) << file;
    }
    std::vector<std::pair<std::string, std::string>> expected;
    std::size_t step = 0;
    for (const char* name : {"clock", "prepare r001-template_scene", "repeat 0 r001-template_scene",
                             "repeat 1 r001-template_scene", "repeat 2 r001-template_scene",
                             "repeat 3 r001-template_scene", "repeat 4 r001-template_scene",
                             "capture r001-template_scene"}) {
        const bool base_first = step++ % 2 == 0;
        expected.emplace_back(base_first ? "base" : "new", name);
        expected.emplace_back(base_first ? "new" : "base", name);
    }
    EXPECT_EQ(read_turns("twice"), expected);
    // A folder that holds a comparison is not overwritten.
    const ChildResult again = compare_with(program(), "twice");
    EXPECT_EQ(again.exit_code, 2) << again.err;
    EXPECT_NE(again.err.find("already holds"), std::string::npos) << again.err;
}

TEST_F(AbVerb, AKilledSideEndsBothAndItsLastWordsAreShown) {
    const std::string killed = write_script(
        "killed", "echo 'turn clock'\nread answer\necho 'last words' >&2\nkill -9 $$\n");
    const ChildResult result = compare_with(killed, "killed-out");
    EXPECT_EQ(result.exit_code, 1) << result.err;
    EXPECT_NE(result.err.find("last words"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("signal 9"), std::string::npos) << result.err;
    EXPECT_FALSE(fs::exists(folder() / "killed-out" / "comparison.csv"));
}

TEST_F(AbVerb, AnOlderProgramIsToldFromAFailure) {
    const std::string old = write_script(
        "old", "echo 'alcove: alcove run: unexpected argument: found `--turns`' >&2\nexit 2\n");
    const ChildResult result = compare_with(old, "old-out");
    EXPECT_EQ(result.exit_code, 1) << result.err;
    EXPECT_NE(result.err.find("does not know --turns"), std::string::npos) << result.err;
}

TEST_F(AbVerb, RunsOwnErrorsAreShown) {
    const ChildResult result =
        run({"ab", program(), program(), "--scene", "nowhere", "--out", "wrong"});
    EXPECT_EQ(result.exit_code, 2) << result.err;
    EXPECT_NE(result.err.find("nowhere"), std::string::npos) << result.err;
}

TEST_F(AbVerb, WhatCannotBeStartedIsRefused) {
    expect_refused({"ab", "nowhere", program()}, 2, {"BASE", "nowhere"});
    expect_refused({"ab", program()}, 2, {"new"});
    expect_refused({"ab", program(), program(), "--resume", "x"}, 2, {"--resume"});
    expect_refused({"ab", program(), program(), "--dry-run"}, 2, {"--dry-run"});
    EXPECT_FALSE(fs::exists(folder() / "runs")) << "left behind by what was refused";
}

TEST_F(AbVerb, ARunWithoutAnyoneWhoGivesTurnsFails) {
    const ChildResult result = run({"run", "--scene", "template_scene", "--method", "none",
                                    "--size", "64x48", "--frames", "0:4", "--turns", "--out", "x"});
    EXPECT_EQ(result.exit_code, 1) << result.err;
    EXPECT_NE(result.err.find("standard input ended"), std::string::npos) << result.err;
}

} // namespace
} // namespace alcove
