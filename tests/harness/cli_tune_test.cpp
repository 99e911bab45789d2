// `tune` and what it leaves, as a user types it.

#include "core/base/file.hpp"
#include "reports/record/record.hpp"
#include "reports/record/tune_record.hpp"
#include "tests/harness/program.hpp"

#include <filesystem>

namespace alcove {
namespace {

class TuneVerb : public ProgramTest {
  protected:
    static ChildResult tune(const std::string& out, std::vector<std::string> more = {}) {
        std::vector<std::string> arguments{
            "tune",       "hemisphere_ssao", "--scene",
            "lifted_box", "--size",          "48x36",
            "--free",     "strength",        "--evaluations",
            "4",          "--out",           (folder() / out).string()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run(arguments);
    }
};

TEST_F(TuneVerb, LeavesACalibrationThatRunTakesInPlaceOfAPreset) {
    const ChildResult tuned = tune("tuned");
    ASSERT_EQ(tuned.exit_code, 0) << tuned.err;
    EXPECT_NE(tuned.out.find("held-out frames"), std::string::npos) << tuned.out;
    const std::filesystem::path out = folder() / "tuned";
    for (const char* file : {"tune.json", "tune.csv", "judgements.csv", "tune.html"}) {
        EXPECT_TRUE(std::filesystem::exists(out / file)) << file;
    }
    const TuneRecord record = read_tune(out);
    const std::string strength = record.methods.at(0).parameters.at(0).tuned;
    const std::string calibration = (out / record.methods[0].calibration).string();
    const std::filesystem::path again = folder() / "again";
    const ChildResult result =
        run({"run", "--scene", "lifted_box", "--method", "hemisphere_ssao@" + calibration + "#mine",
             "--size", "48x36", "--frames", "0:2", "--repeat", "1", "--out", again.string()});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const PlanRecord plan = RunFolder::open(again).plan();
    const CellRecord& cell = plan.rounds.at(0).cells.at(2);
    EXPECT_EQ(cell.label, "mine");
    EXPECT_EQ(cell.settings, "calibrated");
    for (const ParameterRecord& parameter : cell.parameters) {
        if (parameter.name == "strength") {
            EXPECT_EQ(parameter.value, strength);
            EXPECT_EQ(parameter.provenance, "file");
        }
    }
    const std::string page = read_file(again / "report" / "index.html");
    EXPECT_NE(page.find("<h4>Calibrated</h4>"), std::string::npos);
}

TEST_F(TuneVerb, RefusesAFolderThatHoldsACalibrationAndWhatItCannotTune) {

    std::filesystem::create_directories(folder() / "taken");
    write_file_atomically(folder() / "taken" / "tune.json", "{}");
    const ChildResult taken = tune("taken");
    EXPECT_EQ(taken.exit_code, 2);
    EXPECT_NE(taken.err.find("already holds a calibration"), std::string::npos) << taken.err;
    const ChildResult unknown = tune("new", {"--objective", "rmes"});
    EXPECT_EQ(unknown.exit_code, 2);
    EXPECT_NE(unknown.err.find("rmse"), std::string::npos) << unknown.err;
}

} // namespace
} // namespace alcove
