// The verdicts of `reproduce statvo` on forged runs of its parts: every claim has one, and they
// follow the times and errors that were planted.
#include "reports/papers/statvo/statvo.hpp"
#include "tests/reports/forged_reproduction.hpp"

#include <gtest/gtest.h>

namespace alcove {
namespace {

class StatvoReproduction : public testing::Test {
  protected:
    Evidence forge(const Planted& planted) { return m_runs.forge(planted); }

  private:
    ForgedRuns m_runs{
        "statvo",
        {"statvo/downsample", "statvo/root", "statvo/level1", "statvo/level2", "statvo/evaluate"}};
};

TEST_F(StatvoReproduction, HasAVerdictForEachClaimAndTablesForTheFigures) {
    const Reproduction reproduction = reproduce_statvo(forge({}), "small");
    EXPECT_EQ(reproduction.verdicts.size(), 70u);
    EXPECT_EQ(reproduction.tables.size(), 6u);
    for (const PaperTable& table : reproduction.tables) {
        for (const std::vector<std::string>& row : table.rows) {
            EXPECT_EQ(row.size(), table.columns.size()) << table.id;
        }
    }
    for (const PaperFigure& figure : reproduction.figures) {
        EXPECT_FALSE(figure.pictures.empty()) << figure.title;
    }
    // With equal times and errors nothing is faster, flatter or nearer than anything else.
    EXPECT_EQ(find_outcome(reproduction, "STATVO-060"), Outcome::holds);
    EXPECT_EQ(find_outcome(reproduction, "STATVO-018"), Outcome::fails);
    EXPECT_NE(find_outcome(reproduction, "STATVO-050"), Outcome::holds);
    EXPECT_NE(find_outcome(reproduction, "STATVO-054"), Outcome::holds);
}

TEST_F(StatvoReproduction, VerdictsFollowPlantedTimes) {
    Planted planted;
    planted.cost_ms = {{"full", 16.6},       {"half", 4.0},        {"quarter", 1.0},
                       {"all tables", 28.0}, {"statvo", 1.0},      {"17 points", 2.0},
                       {"12 lines", 1.5},    {"SAO", 0.7},         {"1 layer", 1.0},
                       {"4 uniform", 4.0},   {"16 uniform", 16.0}, {"32 uniform", 32.0},
                       {"64 uniform", 64.0}, {"4 adaptive", 30.0}, {"statvo 2 m", 6.0}};
    const Reproduction reproduction = reproduce_statvo(forge(planted), "small");
    for (const char* id : {"STATVO-018", "STATVO-036", "STATVO-037", "STATVO-040", "STATVO-027",
                           "STATVO-028", "STATVO-029", "STATVO-050", "STATVO-051", "STATVO-052"}) {
        EXPECT_EQ(find_outcome(reproduction, id), Outcome::holds) << id;
    }
    EXPECT_EQ(find_outcome(reproduction, "STATVO-060"), Outcome::fails);
    // 28 / 16.6 is no 23 / 8.86, and equal passes are no shares of the paper's.
    EXPECT_EQ(find_outcome(reproduction, "STATVO-059"), Outcome::fails);
    EXPECT_EQ(find_outcome(reproduction, "STATVO-001"), Outcome::fails);
}

TEST_F(StatvoReproduction, VerdictsFollowPlantedErrors) {
    Planted planted;
    planted.error = {{"1 layer", 0.2},       {"2 adaptive", 0.1},   {"4 adaptive", 0.06},
                     {"4 uniform", 0.15},    {"16 uniform", 0.1},   {"32 uniform", 0.07},
                     {"64 uniform", 0.05},   {"full", 0.05},        {"half", 0.06},
                     {"four regions", 0.04}, {"all tables", 0.001}, {"raw points", 0.2},
                     {"raw lines", 0.2},     {"4 layers", 0.08},    {"8 layers", 0.07}};
    const Reproduction reproduction = reproduce_statvo(forge(planted), "small");
    for (const char* id : {"STATVO-026", "STATVO-030", "STATVO-031", "STATVO-034", "STATVO-041",
                           "STATVO-053", "STATVO-054", "STATVO-066", "STATVO-070"}) {
        EXPECT_EQ(find_outcome(reproduction, id), Outcome::holds) << id;
    }
    planted.error["4 adaptive"] = 0.15;
    EXPECT_EQ(find_outcome(reproduce_statvo(forge(planted), "small"), "STATVO-031"),
              Outcome::fails);
}

} // namespace
} // namespace alcove
