// Whole runs of the program. Each validates its timers first (about 5 s on two cores), so they are
// few and shared.

#include "core/base/file.hpp"
#include "reports/record/record.hpp"
#include "tests/harness/program.hpp"

#include <fstream>
#include <set>

namespace alcove {
namespace {

namespace fs = std::filesystem;

class RunVerb : public ProgramTest {
  protected:
    static void SetUpTestSuite() {
        ProgramTest::SetUpTestSuite();
        s_first = replay("first", "1");
    }
    /// The same small run into another folder, with so many driver threads.
    static ChildResult replay(const std::string& out, const std::string& threads) {
        ChildOptions options;
        options.environment["LP_NUM_THREADS"] = threads;
        return run({"run", "--scene", "template_scene", "--method", "none", "--method",
                    "hemisphere_ssao", "--size", "96x72", "--frames", "0:4", "--repeat", "2",
                    "--out", out},
                   options);
    }
    static ChildResult s_first;
};

ChildResult RunVerb::s_first;

TEST_F(RunVerb, LeavesARunFolderAPageAndATable) {
    ASSERT_EQ(s_first.exit_code, 0) << s_first.err;
    for (const char* file :
         {"context.json", "plan.json", "samples.csv", "metrics.csv", "summary.csv", "passes.csv",
          "tradeoff.csv", "report/index.html", "rounds/r001-template_scene/samples.csv",
          "rounds/r001-template_scene/metrics.csv", "rounds/r001-template_scene/done.json"}) {
        EXPECT_GT(fs::file_size(folder() / "first" / file), 0u) << file;
    }
    EXPECT_TRUE(RunFolder::open(folder() / "first").is_complete());
    EXPECT_NE(s_first.out.find("hemisphere_ssao"), std::string::npos) << s_first.out;
    EXPECT_NE(s_first.out.find("report/index.html"), std::string::npos) << s_first.out;
    // No terminal, no progress line.
    EXPECT_EQ(s_first.err.find('\r'), std::string::npos);
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder() / "first")) {
        EXPECT_EQ(entry.path().filename().string().find("tmp"), std::string::npos) << entry.path();
    }
}

TEST_F(RunVerb, TablesHaveTheRowsOfThePlan) {
    const RunFolder run = RunFolder::open(folder() / "first");
    std::set<std::string> cells;
    for (const SampleRow& row : run.read_samples()) {
        cells.insert(row.cell);
    }
    // `none` has its compose and nothing else; the base belongs to the harness.
    EXPECT_EQ(cells, (std::set<std::string>{"anchor-a", "anchor-b", "c1-none", "c2-hemisphere_ssao",
                                            "harness"}));
    EXPECT_EQ(read_image_hashes(folder() / "first").size(), 2u * 4u);
    EXPECT_EQ(count_lines(folder() / "first" / "samples.csv"), run.read_samples().size() + 1);
    EXPECT_EQ(count_lines(folder() / "first" / "metrics.csv"), run.read_metrics().size() + 1);
    EXPECT_EQ(run.context().device_class, "software");
    EXPECT_EQ(run.context().driver_threads, 1);
    EXPECT_FALSE(run.context().timer_trials.empty());
}

TEST_F(RunVerb, ImagesAreEqualBetweenRunsAndBetweenThreadCounts) {
    ASSERT_EQ(replay("again", "1").exit_code, 0);
    ASSERT_EQ(replay("threads", "2").exit_code, 0);
    const auto hashes = read_image_hashes(folder() / "first");
    EXPECT_FALSE(hashes.empty());
    EXPECT_EQ(read_image_hashes(folder() / "again"), hashes);
    EXPECT_EQ(read_image_hashes(folder() / "threads"), hashes);
}

TEST_F(RunVerb, AFolderThatHoldsARunIsNotOverwritten) {
    const std::string before = read_file(folder() / "first" / "context.json");
    const ChildResult result = replay("first", "1");
    EXPECT_EQ(result.exit_code, 2) << result.err;
    EXPECT_NE(result.err.find("already holds a run"), std::string::npos) << result.err;
    EXPECT_EQ(read_file(folder() / "first" / "context.json"), before);
}

TEST_F(RunVerb, ReportWritesThePageAnew) {
    const fs::path page = folder() / "first" / "report" / "index.html";
    ASSERT_TRUE(fs::remove(page));
    ASSERT_TRUE(fs::remove(folder() / "first" / "samples.csv"));
    const ChildResult here = run({"report", "first"});
    EXPECT_EQ(here.exit_code, 0) << here.err;
    EXPECT_TRUE(fs::is_regular_file(page));
    EXPECT_TRUE(fs::is_regular_file(folder() / "first" / "samples.csv"));
    EXPECT_NE(here.out.find("hemisphere_ssao"), std::string::npos);
    EXPECT_EQ(run({"report", "first", "--out", "elsewhere"}).exit_code, 0);
    EXPECT_TRUE(fs::is_regular_file(folder() / "elsewhere" / "index.html"));
}

TEST_F(RunVerb, ADamagedRunIsNamedByFileAndPlace) {
    fs::copy(folder() / "first", folder() / "damaged", fs::copy_options::recursive);
    const fs::path plan = folder() / "damaged" / "plan.json";
    fs::resize_file(plan, fs::file_size(plan) / 2);
    expect_refused({"report", "damaged"}, 2, {"plan.json"});
    expect_refused({"run", "--resume", "damaged"}, 2, {"plan.json"});
}

TEST_F(RunVerb, OnePixelIsMeasuredAndWhatCannotBeSaysWhy) {
    const ChildResult result =
        run({"run", "--scene", "template_scene", "--method", "hemisphere_ssao", "--size", "1x1",
             "--frames", "0:1", "--repeat", "1", "--out", "pixel"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    int ssim_rows = 0;
    for (const MetricRow& row : RunFolder::open(folder() / "pixel").read_metrics()) {
        if (row.metric == "ssim") {
            ++ssim_rows;
            EXPECT_FALSE(row.value.has_value());
            EXPECT_FALSE(row.note.empty());
        }
    }
    EXPECT_EQ(ssim_rows, 1);
}

} // namespace
} // namespace alcove
