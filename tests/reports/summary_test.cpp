#include "core/base/file.hpp"
#include "core/base/text.hpp"
#include "reports/csv/summary_csv.hpp"
#include "reports/record/csv.hpp"
#include "reports/terminal/terminal_report.hpp"
#include "tests/reports/synthetic_run.hpp"

#include <gtest/gtest.h>

#include <map>

namespace alcove {
namespace {

using synthetic::TemporaryFolder;

std::vector<std::map<std::string, std::string>> read_table(const std::string& text) {
    CsvReader reader(text, "summary.csv");
    std::vector<std::string> columns;
    EXPECT_TRUE(reader.next(columns));
    std::vector<std::map<std::string, std::string>> lines;
    for (std::vector<std::string> fields; reader.next(fields);) {
        EXPECT_EQ(fields.size(), columns.size());
        lines.emplace_back();
        for (std::size_t i = 0; i < fields.size(); ++i) {
            EXPECT_TRUE(lines.back().emplace(columns[i], fields[i]).second) << columns[i];
        }
    }
    return lines;
}

TEST(SummaryCsv, OneLineARoundAndCell) {
    const TemporaryFolder folder;
    const RunFolder run = synthetic::write_run(folder.path(), {.hostile = true});
    write_summary_csv(run, analyze_run(run));
    const auto lines = read_table(read_file(folder.path() / "summary.csv"));
    ASSERT_EQ(lines.size(), 12u);
    const auto& hemisphere = lines[3];
    EXPECT_EQ(hemisphere.at("schema"), std::to_string(kRunSchemaVersion));
    EXPECT_EQ(hemisphere.at("cell"), "hemisphere_ssao");
    EXPECT_EQ(hemisphere.at("label"), run.plan().rounds[0].cells[3].label);
    EXPECT_NEAR(parse_number(hemisphere.at("ratio"), "ratio"), 2.5, 1e-6);
    EXPECT_NEAR(parse_number(hemisphere.at("ratio_lower95"), "ratio"), 2.4902, 1e-4);
    EXPECT_EQ(hemisphere.at("ratio_n"), "6");
    EXPECT_EQ(hemisphere.at("rmse_cold_n"), "48");
    EXPECT_NEAR(parse_number(hemisphere.at("rmse_cold_debiased"), "rmse"), 0.06, 1e-12);
    EXPECT_EQ(hemisphere.at("on_front"), "1");
    const auto& none = lines[2];
    EXPECT_EQ(none.at("ratio"), "");
    EXPECT_EQ(none.at("ratio_n"), "0");
    EXPECT_EQ(none.at("has_passes"), "0");
    EXPECT_EQ(lines[5].at("rmse_converged_below_floor"), "1");
    EXPECT_EQ(lines[0].at("role"), "anchor");
}

TEST(SummaryCsv, MetricsOverTimeAndNumbersOfHistoriesHaveColumns) {
    const TemporaryFolder folder;
    const auto lines =
        read_table(make_summary_csv(analyze_run(synthetic::write_run(folder.path(), {}))));
    const auto& hemisphere = lines[3];
    EXPECT_EQ(hemisphere.at("reference"), "reference_ray_traced");
    EXPECT_NEAR(parse_number(hemisphere.at("temporal_flicker_cold_debiased"), "TF"), 0.02, 1e-12);
    EXPECT_EQ(hemisphere.at("temporal_flicker_cold_n"), "45");
    EXPECT_EQ(hemisphere.at("missed_invalidation_cold"), "");
    EXPECT_EQ(hemisphere.at("history_samples_cold"), "");
    EXPECT_EQ(hemisphere.at("converged_share"), "");
    const auto& tssao = lines[5];
    EXPECT_EQ(tssao.at("temporal_flicker_cold_below_floor"), "1");
    EXPECT_EQ(tssao.at("history_samples_cold"), "11.5");
    EXPECT_EQ(tssao.at("history_samples_cold_max"), "64");
    EXPECT_EQ(tssao.at("history_samples_converged"), "4");
    EXPECT_EQ(tssao.at("history_samples_converged_n"), "8");
    EXPECT_EQ(tssao.at("history_age_converged"), "");
    EXPECT_EQ(tssao.count("temporal_flicker_converged"), 0u);
    EXPECT_EQ(tssao.at("converged_share_n"), "6");
}

TEST(TerminalReport, SaysDeviceVerdictSpreadAndPage) {
    const TemporaryFolder folder;
    const RunFolder run = synthetic::write_run(folder.path(), {.repeats = 3, .finished_rounds = 1});
    const std::string text = make_terminal_report(
        analyze_run(run, {{"r1-courtyard", "tssao", "tssao", 3.0}}), "out/index.html");
    for (const char* part :
         {"AO [ms software]", "software: llvmpipe", "2.4950..2.5050 (n=3)", "< 0.00400 (n=8)",
          "Not beaten in both time and error", "A/A 1.0",
          "provisional: tssao 3.000 ms software (n=1)", "in progress: 1 of 2 rounds",
          "skipped: sponza", "report: out/index.html"}) {
        EXPECT_NE(text.find(part), std::string::npos) << part << " is not in\n" << text;
    }
}

TEST(TerminalReport, TheSecondTableHasTheColumnsThatHaveValues) {
    const TemporaryFolder folder;
    const std::string text =
        make_terminal_report(analyze_run(synthetic::write_run(folder.path(), {})), "p");
    for (const char* part :
         {"TF x255", "5.10 (n=45)", "< 0.510 (n=45)", "rho", "0.250 (n=45)", "5.00 (n=3)",
          "0.00800 (n=45)", "11.5 (n=48)", "TF: change of the error"}) {
        EXPECT_NE(text.find(part), std::string::npos) << part << " is not in\n" << text;
    }
    EXPECT_EQ(text.find("trail energy"), std::string::npos);
    EXPECT_EQ(text.find("false inv."), std::string::npos);

    PlanRecord plan = synthetic::make_plan({.repeats = 1});
    RunFolder run = RunFolder::create(folder.path() / "b", synthetic::make_context(), plan);
    run.finish_round("r0-balls", synthetic::make_samples(plan, plan.rounds[0]), {}, {});
    EXPECT_EQ(make_terminal_report(analyze_run(run), "p").find("over time"), std::string::npos);
}

TEST(TerminalReport, LabelsCannotSteerTheTerminal) {
    const TemporaryFolder folder;
    PlanRecord plan = synthetic::make_plan({});
    plan.rounds.resize(1);
    plan.rounds[0].cells[3].label = "\x1b[2Jgone\r";
    RunFolder run = RunFolder::create(folder.path(), synthetic::make_context(), plan);
    run.finish_round("r0-balls", synthetic::make_samples(plan, plan.rounds[0]),
                     synthetic::make_metrics(plan.rounds[0]), {});
    const std::string text = make_terminal_report(analyze_run(run), "p");
    EXPECT_EQ(text.find('\x1b'), std::string::npos);
    EXPECT_EQ(text.find('\r'), std::string::npos);
}

} // namespace
} // namespace alcove
