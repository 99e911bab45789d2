// `alcove stability` as people call it.

#include "core/base/file.hpp"
#include "reports/record/stability_record.hpp"
#include "tests/harness/program.hpp"

namespace alcove {
namespace {

namespace fs = std::filesystem;

using StabilityVerb = ProgramTest;

TEST_F(StabilityVerb, TheGateFailsOnAFailureAndOnlyTheGate) {
    // Without a bias a leaning plane blocks itself.
    const std::vector<std::string> failing{
        "stability", "--method", "hemisphere_ssao:bias=0#plant", "--case", "plane_grazing",
        "--size",    "48x36"};
    const auto with = [&](std::initializer_list<const char*> more) {
        std::vector<std::string> arguments = failing;
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run(arguments);
    };
    const ChildResult ungated = with({"--out", "plant"});
    EXPECT_EQ(ungated.exit_code, 0) << ungated.err;
    EXPECT_NE(ungated.out.find("[1] plant"), std::string::npos) << ungated.out;
    EXPECT_EQ(with({"--out", "gated", "--gate"}).exit_code, 3);
    const StabilityRecord record = read_stability(folder() / "plant");
    ASSERT_EQ(record.cells.size(), 1u);
    EXPECT_NE(record.cells[0].outcome, StabilityOutcome::holds);
    EXPECT_TRUE(fs::exists(folder() / "plant" / record.cells[0].scores.back().picture));
    EXPECT_NE(read_file(folder() / "plant" / "stability.html").find("Grazing plane"),
              std::string::npos);
    EXPECT_NE(read_file(folder() / "plant" / "stability.csv").find("plane_grazing,plant,"),
              std::string::npos);
}

TEST_F(StabilityVerb, TheGateIsMetWhereEverythingHolds) {
    const ChildResult result =
        run({"stability", "--method", "none", "--method", "hemisphere_ssao", "--case", "fov_wide",
             "--case", "normals_zero", "--size", "48x36", "--out", "met", "--gate"});
    EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
    EXPECT_EQ(read_stability(folder() / "met").cells.size(), 4u);
}

TEST_F(StabilityVerb, RefusesWhatItDoesNotKnow) {
    expect_refused({"stability", "--case", "fov_wid"}, 2, {"--case", "fov_wid", "fov_wide"});
    expect_refused({"stability", "--method", "hemisfere_ssao"}, 2, {"hemisphere_ssao"});
    expect_refused({"stability", "--size", "8x8"}, 2, {"--size", "8x8", "32x32"});
    expect_refused({"stability", "--gaet"}, 2, {"--gaet", "--gate"});
}

} // namespace
} // namespace alcove
