// The verdicts of `reproduce statvo` on forged runs of its parts: every claim has one, and they
// follow the times and errors that were planted.
#include "harness/run/experiment_file.hpp"
#include "harness/run/plan.hpp"
#include "reports/papers/paper_files.hpp"
#include "reports/papers/statvo/statvo.hpp"
#include "tests/reports/synthetic_run.hpp"

#include <cmath>
#include <map>

#include <gtest/gtest.h>

namespace alcove {
namespace {

/// Of cells, by label; what is not named costs 4 ms in four equal passes and has every metric at
/// 0.05.
struct Planted {
    std::map<std::string, double> cost_ms;
    std::map<std::string, double> error;
};

double find_or(const std::map<std::string, double>& values, const std::string& key, double other) {
    const auto found = values.find(key);
    return found == values.end() ? other : found->second;
}

std::vector<SampleRow> forge_samples(const PlanRecord& plan, const RoundRecord& round,
                                     const Planted& planted) {
    const char* const kPasses[] = {"statvo/downsample", "statvo/root", "statvo/level1",
                                   "statvo/level2", "statvo/evaluate"};
    std::vector<SampleRow> rows;
    for (std::size_t s = 0; s < round.segments.size(); ++s) {
        for (int frame = round.segments[s].begin; frame < round.segments[s].end; ++frame) {
            for (int repeat = 0; repeat < plan.repeats; ++repeat) {
                // A tenth of a percent of scatter, so that intervals have a width.
                const double scatter = 1.0 + 0.001 * std::sin(7.0 * repeat + frame);
                for (const CellRecord& cell : round.cells) {
                    const double ns = 1e6 * scatter * find_or(planted.cost_ms, cell.label, 4.0);
                    SampleRow row;
                    row.round = round.id;
                    row.cell = cell.id;
                    row.segment = static_cast<int>(s);
                    row.frame = frame;
                    row.repeat = repeat;
                    if ((repeat + frame) % 2 == 0) {
                        row.kind = SampleKind::envelope;
                        row.pass = "envelope";
                        row.time_ns = static_cast<std::int64_t>(ns);
                        rows.push_back(row);
                        continue;
                    }
                    for (const char* pass : kPasses) {
                        row.pass = pass;
                        row.time_ns = static_cast<std::int64_t>(ns / 5.0);
                        rows.push_back(row);
                    }
                }
            }
        }
    }
    return rows;
}

std::vector<MetricRow> forge_metrics(const PlanRecord& plan, const RoundRecord& round,
                                     const Planted& planted) {
    std::vector<MetricRow> rows;
    for (std::size_t s = 0; s < round.segments.size(); ++s) {
        for (int frame = round.segments[s].begin; frame < round.segments[s].end; ++frame) {
            for (const CellRecord& cell : round.cells) {
                for (const MetricDescription& metric : plan.metrics) {
                    MetricRow row;
                    row.round = round.id;
                    row.cell = cell.id;
                    row.segment = static_cast<int>(s);
                    row.frame = frame;
                    row.metric = metric.name;
                    row.value = find_or(planted.error, cell.label, 0.05) *
                                (1.0 + 0.001 * std::sin(3.0 * frame));
                    rows.push_back(row);
                }
            }
        }
    }
    return rows;
}

class StatvoReproduction : public testing::Test {
  protected:
    Evidence forge(const Planted& planted) {
        const Units units = get_units();
        Evidence evidence;
        for (const EmbeddedFile& file : embedded_papers()) {
            const std::filesystem::path path(file.name);
            if (path.extension() != ".toml" || path.parent_path().filename() != "statvo") {
                continue;
            }
            const Experiment part = parse_experiment(file.text, std::string(file.name),
                                                     std::filesystem::current_path(), units);
            RunFolder run =
                RunFolder::create(m_folder.path() / std::to_string(m_runs++),
                                  synthetic::make_context(), make_plan(part, units).record);
            for (const RoundRecord& round : run.plan().rounds) {
                run.finish_round(round.id, forge_samples(run.plan(), round, planted),
                                 forge_metrics(run.plan(), round, planted), {});
            }
            evidence.add(part.name, run);
        }
        return evidence;
    }

    static Outcome find_outcome(const Reproduction& reproduction, const std::string& id) {
        for (const ClaimVerdict& verdict : reproduction.verdicts) {
            if (verdict.claim.id == id) {
                return verdict.outcome;
            }
        }
        ADD_FAILURE() << id;
        return Outcome::not_testable;
    }

  private:
    TemporaryFolder m_folder;
    int m_runs = 0;
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
