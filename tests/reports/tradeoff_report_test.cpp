// Trade-offs as a table of the page and as a file.

#include "core/base/file.hpp"
#include "core/base/text.hpp"
#include "reports/csv/tradeoff_csv.hpp"
#include "reports/html/html_report.hpp"
#include "reports/html/tradeoff_section.hpp"
#include "reports/record/csv.hpp"
#include "tests/reports/synthetic_run.hpp"
#include "tests/reports/tradeoff_runs.hpp"

#include <algorithm>
#include <map>

#include <gtest/gtest.h>

namespace alcove {
namespace {

std::vector<std::map<std::string, std::string>> read_table(const std::string& text) {
    CsvReader reader(text, "tradeoff.csv");
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

TEST(TradeoffCsv, OneLineACellWithItsPartners) {
    const synthetic::TemporaryFolder folder;
    const RunFolder run = synthetic::write_run(folder.path(), {.hostile = true});
    write_tradeoff_csv(run, analyze_run(run));
    const auto lines = read_table(read_file(folder.path() / "tradeoff.csv"));
    ASSERT_EQ(lines.size(), 8u);
    const auto& tssao = lines[2];
    EXPECT_EQ(tssao.at("cell"), "tssao");
    EXPECT_EQ(tssao.at("metric"), "rmse");
    EXPECT_EQ(tssao.at("state"), "converged");
    EXPECT_EQ(tssao.at("on_front"), "1");
    EXPECT_EQ(tssao.at("surely_beaten"), "0");
    EXPECT_EQ(tssao.at("error_n"), "8");
    EXPECT_EQ(tssao.at("equal_time_cell"), "hemisphere_ssao");
    EXPECT_EQ(tssao.at("equal_error_cell"), "");
    EXPECT_EQ(tssao.at("bound_2_frames"), "7");
    EXPECT_EQ(lines[3].at("surely_beaten"), "1");
    EXPECT_EQ(lines[3].at("equal_error_cell"), "tssao");
}

TEST(TradeoffCsv, ARunWithoutOneHasTheHeaderAlone) {
    const std::string empty = make_tradeoff_csv(make_run({}));
    EXPECT_EQ(std::count(empty.begin(), empty.end(), '\n'), 1);
    const std::string full = make_tradeoff_csv(make_simple_run(0.01));
    EXPECT_TRUE(full.starts_with(empty));
    EXPECT_EQ(read_table(full).size(), 4u);
}

TEST(TradeoffSection, OneTableAGroupAndARowACell) {
    const std::string text = make_tradeoff_section(make_simple_run(0.01));
    EXPECT_NE(text.find("id=\"tradeoff\""), std::string::npos);
    EXPECT_NE(text.find("<details open"), std::string::npos);
    EXPECT_NE(text.find("<td class=\"text\">beaten</td>"), std::string::npos);
    EXPECT_NE(text.find("a:<wbr>n=4"), std::string::npos);
    EXPECT_NE(text.find("not reached"), std::string::npos);
    EXPECT_EQ(make_tradeoff_section(make_run({})), "");
}

TEST(TradeoffSection, WhatIsNotSurelyBeatenIsNotCalledBeaten) {
    const std::string text = make_tradeoff_section(make_simple_run(0.4));
    EXPECT_EQ(text.find("<td class=\"text\">beaten</td>"), std::string::npos);
    EXPECT_NE(text.find("<td class=\"text\">not surely beaten</td>"), std::string::npos);
}

TEST(TradeoffSection, StandsOnThePageAndItsErrorsIntervalsInTheChart) {
    const synthetic::TemporaryFolder folder;
    const RunFolder run = synthetic::write_run(folder.path(), {});
    write_html_report(run, {});
    const std::string page = read_file(folder.path() / "report" / "index.html");
    for (const char* part :
         {"<a href=\"#tradeoff\">", "<section id=\"tradeoff\">", "<a href=\"../tradeoff.csv\">"}) {
        EXPECT_NE(page.find(part), std::string::npos) << part;
    }
    const RunAnalysis analysis = analyze_run(run);
    const MetricAnalysis* ssim = analysis.rounds.at(0).cells.back().find(SampleState::cold, "ssim");
    ASSERT_NE(ssim, nullptr);
    const Interval ends = get_bounds(ssim->content);
    EXPECT_LT(ends.lower, ends.upper);
    EXPECT_NE(page.find("\"lower\":" + format_number(ends.lower) +
                        ",\"upper\":" + format_number(ends.upper)),
              std::string::npos);
}

TEST(TradeoffSection, LongGroupsAreFolded) {
    std::vector<CellAnalysis> cells;
    for (int i = 0; i < 40; ++i) {
        cells.push_back(make_cell("a:n=" + std::to_string(i), known(1.0 + i, 0.01), "rmse",
                                  known(1.0 / (1.0 + i), 0.001)));
    }
    const std::string text = make_tradeoff_section(make_run({make_round("r0", cells)}));
    EXPECT_EQ(text.find("<details open"), std::string::npos);
    EXPECT_NE(text.find("<details"), std::string::npos);
}

TEST(TradeoffSection, NothingOfARunBecomesMarkup) {
    const synthetic::TemporaryFolder folder;
    const RunFolder run = synthetic::write_run(folder.path(), {.hostile = true});
    const std::string text = make_tradeoff_section(analyze_run(run));
    EXPECT_NE(text.find("&lt;img src=x"), std::string::npos);
    EXPECT_EQ(text.find("<img"), std::string::npos);
    EXPECT_EQ(text.find("<script"), std::string::npos);
}

} // namespace
} // namespace alcove
