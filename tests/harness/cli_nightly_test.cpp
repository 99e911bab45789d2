// `alcove nightly`: two nights that the program measures itself, and nights forged between them.

#include "core/base/file.hpp"
#include "reports/record/store.hpp"
#include "tests/harness/program.hpp"
#include "tests/reports/forged_store.hpp"

#include <nlohmann/json.hpp>

namespace alcove {
namespace {

namespace fs = std::filesystem;

const std::string kHostile = "]]></failure><script>document.title='owned'</script>\x01&\"";

class NightlyVerb : public ProgramTest {
  protected:
    static ChildResult run_night(const std::string& out, const std::string& store,
                                 const std::string& commit = "") {
        return run({"nightly", "--scene", "lifted_box", "--method", "hemisphere_ssao", "--metric",
                    "rmse", "--size", "64x48", "--frames", "0:4", "--repeat", "5", "--commit",
                    commit, "--store", store, "--out", out});
    }

    static void SetUpTestSuite() {
        ProgramTest::SetUpTestSuite();
        for (const char* night : {"night1", "night2"}) {
            const ChildResult result = run_night(night, "store.sqlite");
            ASSERT_EQ(result.exit_code, 0) << result.out << result.err;
            ASSERT_NE(result.err.find("too little history"), std::string::npos) << result.err;
        }
    }

    static Store open_store(const std::string& name) { return Store(folder() / name); }

    /// A copy of the store, with the second night alone, whose clock is one that needs no proof: on
    /// a busy machine a proof can fail, and times of another clock begin a new segment.
    static fs::path copy_store(const std::string& name) {
        const fs::path path = folder() / name;
        fs::copy_file(folder() / "store.sqlite", path);
        forged::execute_sql(path,
                            "DELETE FROM points WHERE run = 1; DELETE FROM runs WHERE id = 1; "
                            "DELETE FROM segments WHERE id NOT IN (SELECT segment FROM "
                            "points)");
        for (const char* mode : {"timestamp_finish", "timestamp_flush_both", "timestamp_flush",
                                 "timestamp", "time_elapsed"}) {
            const std::string from = std::string("'") + mode + "'";
            forged::execute_sql(path, "UPDATE segments SET device = replace(device, " + from +
                                          ", 'fenced_wall')");
        }
        forged::execute_sql(path, "UPDATE runs SET timer_mode = 'fenced_wall'");
        return path;
    }
};

TEST_F(NightlyVerb, ANightLeavesRunReportsStoreAndDashboard) {
    for (const char* file :
         {"run/report/index.html", "junit.xml", "summary.md", "benchmark.json"}) {
        EXPECT_TRUE(fs::is_regular_file(folder() / "night1" / file)) << file;
    }
    EXPECT_TRUE(fs::is_regular_file(folder() / "dashboard" / "index.html"));
    const auto json = nlohmann::json::parse(read_file(folder() / "night1" / "benchmark.json"));
    EXPECT_EQ(json.at("benchmarks").at(0).at("label"), "software");
    const StoredHistory history = open_store("store.sqlite").read();
    ASSERT_EQ(history.runs.size(), 2u);
    EXPECT_EQ(history.runs[0].suite, "nightly");
    EXPECT_EQ(history.runs[0].folder, "night1/run");
    for (const StoredSeries& series : history.series) {
        if (series.kind == SeriesKind::images || series.kind == SeriesKind::quality) {
            ASSERT_EQ(series.points.size(), 2u) << series.name.metric;
            EXPECT_EQ(series.points[0].image_hash, series.points[1].image_hash);
            EXPECT_EQ(series.points[0].value, series.points[1].value) << "images are deterministic";
            EXPECT_EQ(series.points[0].segment, series.points[1].segment);
        }
    }
}

TEST_F(NightlyVerb, AnotherImageThanLastNightFailsTheGateOnce) {
    const fs::path path = copy_store("images.sqlite");
    forged::execute_sql(path, "UPDATE points SET image_hash = '0000000000000000' WHERE image_hash "
                              "<> ''");
    const ChildResult result = run_night("changed", "images.sqlite");
    EXPECT_EQ(result.exit_code, 3) << result.out << result.err;
    EXPECT_NE(result.out.find("image changed"), std::string::npos) << result.out;
    EXPECT_NE(
        read_file(folder() / "changed" / "junit.xml").find("<failure message=\"image changed"),
        std::string::npos);
    EXPECT_NE(read_file(folder() / "changed" / "summary.md").find("**image changed**"),
              std::string::npos);
    EXPECT_EQ(run_night("after", "images.sqlite").exit_code, 0) << "a step is reported once";
}

TEST_F(NightlyVerb, ATimeBeyondItsFenceIsMeasuredAgainBeforeItFails) {
    const fs::path path = copy_store("times.sqlite");
    // Twelve nights on which everything took a hundredth: nobody doubts tonight.
    forged::execute_sql(path, R"(
        UPDATE points SET value = 0.01 WHERE series IN
            (SELECT id FROM series WHERE kind IN ('time', 'pass'));
        WITH RECURSIVE night(n) AS (SELECT 3 UNION ALL SELECT n + 1 FROM night WHERE n < 14)
        INSERT INTO runs(id, utc, build, device, device_class, timer_mode, suite, folder)
            SELECT n, utc, build, device, device_class, timer_mode, suite, '' FROM runs, night
            WHERE runs.id = 2;
        INSERT INTO points SELECT series, runs.id, segment, 0.01 + 0.0001 * (runs.id % 3), NULL,
            NULL, n, '' FROM points, runs WHERE points.run = 2 AND runs.id > 2 AND series IN
            (SELECT id FROM series WHERE kind IN ('time', 'pass')))");
    const ChildResult result = run_night("slow", "times.sqlite");
    EXPECT_EQ(result.exit_code, 3) << result.out << result.err;
    EXPECT_NE(result.err.find("measuring them again"), std::string::npos) << result.err;
    EXPECT_NE(result.out.find("second measurement"), std::string::npos) << result.out;
    EXPECT_TRUE(fs::exists(folder() / "slow" / "second" / "metrics.csv"));
    std::size_t confirmed = 0;
    for (const StoredSeries& series : open_store("times.sqlite").read().series) {
        for (const StoredVerdict& verdict : series.verdicts) {
            EXPECT_EQ(verdict.kind, StepKind::slower);
            confirmed += verdict.is_confirmed ? 1 : 0;
        }
    }
    EXPECT_GE(confirmed, 2u) << "envelope and passes";
}

TEST_F(NightlyVerb, WhatPeopleWriteStaysText) {
    const fs::path path = copy_store("hostile.sqlite");
    forged::execute_sql(path, "UPDATE series SET method = method || '<script>old</script>' WHERE "
                              "kind = 'quality'");
    const ChildResult result = run_night("hostile", "hostile.sqlite", kHostile);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const std::string xml = read_file(folder() / "hostile" / "junit.xml");
    EXPECT_EQ(xml.find("<script"), std::string::npos);
    EXPECT_NE(xml.find("]]&gt;&lt;/failure&gt;"), std::string::npos);
    EXPECT_EQ(xml.find('\x01'), std::string::npos);
    const std::string page = read_file(folder() / "dashboard" / "index.html");
    EXPECT_EQ(page.find("<script>document.title"), std::string::npos);
    EXPECT_EQ(page.find("<script>old"), std::string::npos);
    EXPECT_NE(page.find("&lt;script&gt;old"), std::string::npos);
    EXPECT_EQ(read_file(folder() / "hostile" / "summary.md").find("<script"), std::string::npos);
}

TEST_F(NightlyVerb, WhatCannotBeAppendedToIsRefusedBeforeTheRun) {
    const fs::path path = copy_store("newer.sqlite");
    forged::execute_sql(path, "PRAGMA user_version = 99");
    expect_refused({"nightly", "--store", "newer.sqlite", "--out", "no"}, 2,
                   {"newer.sqlite", "newer alcove", "99"});
    EXPECT_FALSE(fs::exists(folder() / "no"));
    write("text.sqlite", "no database at all, but longer than a header");
    expect_refused({"nightly", "--store", "text.sqlite"}, 2, {"text.sqlite", "not a database"});
    expect_refused({"nightly", "--store", "store.sqlite", "--out", "night1"}, 2,
                   {"night1", "already holds a night"});
    expect_refused({"nightly", "--stor", "x"}, 2, {"--stor", "nearest", "--store"});
}

} // namespace
} // namespace alcove
