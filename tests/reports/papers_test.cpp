#include "reports/papers/judge.hpp"

#include "harness/run/experiment_file.hpp"
#include "harness/run/plan.hpp"
#include "reports/csv/reproduction_csv.hpp"
#include "reports/html/reproduction_index.hpp"
#include "reports/html/reproduction_page.hpp"
#include "reports/latex/latex_table.hpp"
#include "reports/papers/claim.hpp"
#include "reports/papers/estimates.hpp"
#include "reports/papers/paper_files.hpp"
#include "reports/papers/verdict.hpp"

#include <cmath>
#include <filesystem>
#include <set>

#include <gtest/gtest.h>

namespace alcove {
namespace {

Estimate make_estimate(double value, double half_width) {
    Estimate estimate;
    estimate.value = value;
    estimate.minimum = value - 2.0 * half_width;
    estimate.maximum = value + 2.0 * half_width;
    estimate.interval = Interval{value - half_width, value + half_width};
    estimate.n = 6;
    return estimate;
}

TEST(Claims, AreReadWholeAndNamedOnce) {
    const std::vector<Claim> claims = load_claims("TSSAO");
    EXPECT_EQ(claims.size(), 150u);
    std::set<std::string> ids;
    for (const Claim& claim : claims) {
        EXPECT_TRUE(ids.insert(claim.id).second) << claim.id;
        EXPECT_FALSE(claim.location.empty()) << claim.id;
        EXPECT_FALSE(claim.shape.empty()) << claim.id;
    }
    EXPECT_EQ(claims[1].id, "TSSAO-002");
    EXPECT_EQ(claims[1].value, "29");
    EXPECT_FALSE(load_claims("STATVO").empty());
    EXPECT_FALSE(load_errata("TSSAO").empty());
}

TEST(Verdicts, FollowTheWholeInterval) {
    EXPECT_EQ(judge_above(make_estimate(1.2, 0.1), 1.0), Outcome::holds);
    EXPECT_EQ(judge_above(make_estimate(1.05, 0.1), 1.0), Outcome::inconclusive);
    EXPECT_EQ(judge_above(make_estimate(0.8, 0.1), 1.0), Outcome::fails);
    EXPECT_EQ(judge_below(make_estimate(0.8, 0.1), 1.0), Outcome::holds);
    EXPECT_EQ(judge_below(make_estimate(1.2, 0.1), 1.0), Outcome::fails);
    EXPECT_EQ(judge_within(make_estimate(1.0, 0.1), 0.8, 1.2), Outcome::holds);
    EXPECT_EQ(judge_within(make_estimate(1.15, 0.1), 0.8, 1.2), Outcome::inconclusive);
    EXPECT_EQ(judge_within(make_estimate(1.5, 0.1), 0.8, 1.2), Outcome::fails);
    // Without an interval the extremes stand for it.
    Estimate few = make_estimate(1.2, 0.15);
    few.interval.reset();
    EXPECT_EQ(judge_above(few, 1.0), Outcome::inconclusive);
    EXPECT_EQ(combine({Outcome::holds, Outcome::holds}), Outcome::holds);
    EXPECT_EQ(combine({Outcome::holds, Outcome::inconclusive}), Outcome::inconclusive);
    EXPECT_EQ(combine({Outcome::inconclusive, Outcome::fails}), Outcome::fails);
}

TEST(Verdicts, OfAnOrderAllowSlack) {
    const Estimate low = make_estimate(1.0, 0.1);
    EXPECT_EQ(judge_order(make_estimate(1.3, 0.1), low, 0.0), Outcome::holds);
    EXPECT_EQ(judge_order(make_estimate(1.15, 0.1), low, 0.0), Outcome::inconclusive);
    EXPECT_EQ(judge_order(make_estimate(1.15, 0.1), low, 0.1), Outcome::holds);
    EXPECT_EQ(judge_order(make_estimate(0.7, 0.1), low, 0.0), Outcome::fails);
}

TEST(Estimates, ScaleWithTheirIntervalAndCorrelate) {
    const Estimate doubled = scale_estimate(make_estimate(1.0, 0.1), 2.0);
    EXPECT_DOUBLE_EQ(doubled.value, 2.0);
    EXPECT_DOUBLE_EQ(doubled.interval->upper, 2.2);
    EXPECT_DOUBLE_EQ(doubled.minimum, 1.6);
    // By hand: deviations (-1.5, -0.5, 0.5, 1.5) and (-1, -1, 1, 1) give 4 / sqrt(5 * 4).
    const Estimate r = correlate({1.0, 2.0, 3.0, 4.0}, {1.0, 1.0, 3.0, 3.0});
    EXPECT_NEAR(r.value, 4.0 / std::sqrt(20.0), 1e-12);
    EXPECT_LT(r.interval->lower, r.value);
    EXPECT_GT(r.interval->upper, r.value);
}

TEST(Verdicts, AreOneAClaimWithItsReason) {
    Judge judge;
    judge.set("B", {Outcome::holds, "form", std::nullopt, "on something"});
    judge.set_untestable({"A"}, "for want of a city");
    std::vector<Claim> claims(2);
    claims[0].id = "A";
    claims[1].id = "B";
    const std::vector<ClaimVerdict> verdicts = judge.finish(claims);
    EXPECT_EQ(verdicts[0].outcome, Outcome::not_testable);
    EXPECT_EQ(verdicts[0].why, "for want of a city");
    EXPECT_EQ(verdicts[1].tested, "form");
    EXPECT_DEATH(judge.set("B", {}), "one finding a claim");
    claims.pop_back();
    EXPECT_DEATH(static_cast<void>(judge.finish(claims)), "known claims");
    claims.emplace_back().id = "C";
    EXPECT_DEATH(static_cast<void>(judge.finish(claims)), "every claim");
}

TEST(Experiments, OfThePaperCanBePlanned) {
    const Units units = get_units();
    std::size_t parts = 0;
    for (const EmbeddedFile& file : embedded_papers()) {
        if (!file.name.ends_with(".toml")) {
            continue;
        }
        SCOPED_TRACE(file.name);
        const Experiment part = parse_experiment(file.text, std::string(file.name),
                                                 std::filesystem::current_path(), units);
        EXPECT_EQ(part.name, std::filesystem::path(file.name).stem().string());
        EXPECT_FALSE(make_plan(part, units).record.rounds.empty());
        ++parts;
    }
    EXPECT_GE(parts, 23u);
}

Reproduction make_reproduction() {
    Reproduction reproduction;
    reproduction.paper = "P<script>";
    reproduction.scale = "small";
    ClaimVerdict verdict;
    verdict.claim.id = "P-001";
    verdict.claim.value = "\"3\" & <b>more</b>";
    verdict.outcome = Outcome::fails;
    verdict.measured = make_estimate(1.5, 0.1);
    verdict.why = "a, \"b\"\nc";
    reproduction.verdicts.push_back(verdict);
    reproduction.tables.push_back({"t1", "50 % of a_b & c", "note", {"x", "y"}, {{"<1", "{2}"}}});
    return reproduction;
}

TEST(ReproductionPage, EscapesWhatItShowsAndCountsVerdicts) {
    const std::string page = make_reproduction_page(make_reproduction());
    EXPECT_EQ(page.find("<script"), std::string::npos);
    EXPECT_EQ(page.find("<b>more"), std::string::npos);
    EXPECT_NE(page.find("0 holds, 1 fails, 0 inconclusive, 0 not testable here"),
              std::string::npos);
    EXPECT_NE(page.find("1.50"), std::string::npos);
}

TEST(ReproductionIndex, LinksToEachPaperWithItsCounts) {
    const std::vector<IndexedReproduction> papers{{"a b", make_reproduction()}};
    const std::string page = make_reproduction_index(papers);
    EXPECT_NE(page.find("href=\"a%20b/index.html\">P&lt;script&gt;</a>"), std::string::npos)
        << page;
    EXPECT_NE(page.find("<th>holds</th><th>fails</th>"), std::string::npos) << page;
    EXPECT_NE(page.find("<td>0</td><td>1</td><td>0</td><td>0</td>"), std::string::npos) << page;
}

TEST(ReproductionCsv, QuotesItsFields) {
    const std::string csv = make_verdicts_csv(make_reproduction());
    EXPECT_NE(csv.find("\"a, \"\"b\"\"\nc\""), std::string::npos) << csv;
    EXPECT_NE(csv.find(",fails,"), std::string::npos);
}

TEST(LatexTable, EscapesAndUsesBooktabs) {
    EXPECT_EQ(escape_latex("a_b 50% #1 {x} \\ ~ ^ < > | & $\n"),
              "a\\_b 50\\% \\#1 \\{x\\} \\textbackslash{} \\textasciitilde{} \\textasciicircum{} "
              "\\textless{} \\textgreater{} \\textbar{} \\& \\$ ");
    const std::string table = make_latex_table(make_reproduction().tables.front());
    for (const char* part : {"\\toprule", "\\midrule", "\\bottomrule", "\\begin{tabular}{lr}",
                             "50 \\% of a\\_b \\& c", "\\textless{}1 & \\{2\\} \\\\"}) {
        EXPECT_NE(table.find(part), std::string::npos) << part << "\n" << table;
    }
}

} // namespace
} // namespace alcove
