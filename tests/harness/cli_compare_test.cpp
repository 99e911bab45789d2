// `alcove compare` on run folders that the program made itself.

#include "core/base/file.hpp"
#include "tests/harness/program.hpp"

#include <regex>

namespace alcove {
namespace {

namespace fs = std::filesystem;

class CompareVerb : public ProgramTest {
  protected:
    static void SetUpTestSuite() {
        ProgramTest::SetUpTestSuite();
        const ChildResult result =
            run({"run", "--scene", "lifted_box", "--method", "none", "--method", "hemisphere_ssao",
                 "--size", "64x48", "--frames", "0:4", "--repeat", "5", "--out", "base"});
        ASSERT_EQ(result.exit_code, 0) << result.err;
        // The machine's own noise is no part of this test: in repeat r everything takes 10 ms and
        // r microseconds.
        edit("base", "samples.csv",
             std::regex(",([0-9]),(divided|envelope),cold,([^,\n]*),-?[0-9]+,"),
             ",$01,$02,cold,$03,1000$01000,");
        // In NEW the method takes ten times as long.
        fs::copy(folder() / "base", folder() / "slow", fs::copy_options::recursive);
        edit("slow", "samples.csv",
             std::regex("(hemisphere_ssao,.*,envelope,cold,envelope,[0-9]+)"), "$010");
        fs::copy(folder() / "base", folder() / "anchor", fs::copy_options::recursive);
        edit_file(folder() / "anchor" / "context.json",
                  std::regex("\"anchor_version\": *\"[^\"]*\""), "\"anchor_version\": \"0\"");
    }

    /// In the table of every round.
    static void edit(const std::string& run, const std::string& table, const std::regex& from,
                     const std::string& to) {
        for (const fs::directory_entry& round : fs::directory_iterator(folder() / run / "rounds")) {
            edit_file(round.path() / table, from, to);
        }
    }

    static void edit_file(const fs::path& file, const std::regex& from, const std::string& to) {
        const std::string before = read_file(file);
        const std::string after = std::regex_replace(before, from, to);
        ASSERT_NE(before, after) << file << " is not as it was";
        write_file_atomically(file, after);
    }
};

TEST_F(CompareVerb, ARunIsTheSameAsItselfUnderTheStrictestGate) {
    const ChildResult result = run({"compare", "base", "base", "--gate=strict"});
    EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
    EXPECT_NE(result.out.find("0 worse, 0 unknown, 0 better"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("images are identical"), std::string::npos) << result.out;
    EXPECT_EQ(result.err, "");
}

TEST_F(CompareVerb, WhatIsSlowerFailsTheGateAndOnlyTheGate) {
    const ChildResult without = run({"compare", "base", "slow"});
    EXPECT_EQ(without.exit_code, 0) << without.err;
    EXPECT_NE(without.out.find("1 worse"), std::string::npos) << without.out;
    // A gate without a value does not take the run behind it for one.
    EXPECT_EQ(run({"compare", "--gate", "base", "slow"}).exit_code, 3);
    EXPECT_EQ(run({"compare", "base", "slow", "--gate=strict"}).exit_code, 3);
    EXPECT_EQ(run({"compare", "slow", "base", "--gate"}).exit_code, 0) << "faster is no failure";
}

TEST_F(CompareVerb, OutHoldsTheTableTheCommentAndThePage) {
    EXPECT_EQ(run({"compare", "base", "slow", "--out", "said"}).exit_code, 0);
    EXPECT_NE(read_file(folder() / "said" / "comparison.csv").find("hemisphere_ssao,"),
              std::string::npos);
    EXPECT_NE(read_file(folder() / "said" / "comparison.md").find("**worse**"), std::string::npos);
    EXPECT_NE(read_file(folder() / "said" / "comparison.html").find("<!DOCTYPE html>"),
              std::string::npos);
}

TEST_F(CompareVerb, UnknownIsAWarningAndFailsTheStrictGateAlone) {
    // Four repeats give no interval.
    fs::copy(folder() / "base", folder() / "few", fs::copy_options::recursive);
    edit("few", "samples.csv", std::regex("[^\n]*,4,(divided|envelope),[^\n]*\n"), "");
    const ChildResult result = run({"compare", "base", "few", "--gate"});
    EXPECT_EQ(result.exit_code, 0) << result.out;
    EXPECT_NE(result.err.find("warning: 1 verdict"), std::string::npos) << result.err;
    EXPECT_EQ(run({"compare", "base", "few", "--gate=strict"}).exit_code, 3);
}

TEST_F(CompareVerb, WhatCannotBeComparedIsRefused) {
    expect_refused({"compare", "base", "anchor"}, 2, {"anchor_version", "`0`"});
    expect_refused({"compare", "base", "nowhere"}, 2, {"nowhere"});
    expect_refused({"compare", "base"}, 2, {"new"});
    expect_refused({"compare", "base", "base", "--margin", "nan"}, 2, {"--margin"});
    expect_refused({"compare", "base", "base", "--margin", "1"}, 2, {"--margin", "[0, 1)"});
    expect_refused({"compare", "base", "base", "--gate=hard"}, 2, {"--gate", "hard", "strict"});
    expect_refused({"compare", "base", "base", "--allow-other-device"}, 2,
                   {"--allow-other-device"});
}

} // namespace
} // namespace alcove
