#include "reports/analysis/analysis.hpp"
#include "reports/analysis/wording.hpp"
#include "reports/csv/summary_csv.hpp"
#include "reports/terminal/terminal_report.hpp"
#include "tests/reports/synthetic_run.hpp"

#include <gtest/gtest.h>

namespace alcove {
namespace {

ContextRecord make_context() {
    ContextRecord context;
    context.cpu_threads = 2;
    return context;
}

Estimate make_aa(double half_width) {
    return {1.0, Interval{1.0 - half_width, 1.0 + half_width}, 0.99, 1.01, 6};
}

/// A replay of one second on a machine that does nothing else.
MachineRecord make_quiet() {
    return {1.0, 2.0, 0.01, 0.0, 20.0, 3000.0};
}

Fitness judge(const std::vector<MachineRecord>& machine, double noise = 0.01,
              const std::vector<double>& memories = {}, std::size_t repeats = 6) {
    RoundDone done;
    done.machine = machine;
    return judge_fitness(done, make_context(), make_aa(noise), memories, repeats);
}

Fitness judge_with(std::optional<double> MachineRecord::*member, double value) {
    MachineRecord record = make_quiet();
    record.*member = value;
    return judge({record});
}

TEST(Fitness, AQuietMachineIsFitAndSaysWhatItHasSeen) {
    const Fitness fitness = judge({make_quiet(), make_quiet()});
    EXPECT_EQ(fitness.verdict, MachineVerdict::fit);
    EXPECT_TRUE(fitness.reasons.empty());
    EXPECT_NE(describe_fitness(fitness).find("machine fit: other processes took 1.0 %"),
              std::string::npos)
        << describe_fitness(fitness);
    // both repeats read the same clock
    ASSERT_EQ(fitness.unknown.size(), 1u);
    EXPECT_NE(fitness.unknown[0].find("3000 MHz in every repeat"), std::string::npos);
}

TEST(Fitness, EverySourceCanRaiseDoubtAndWorse) {
    struct Source {
        std::optional<double> MachineRecord::*member;
        FitnessLimit limit;
        double scale; ///< from what the limit is of to what is recorded
    };
    const Source sources[] = {{&MachineRecord::others_share, kOthersLimit, 1.0},
                              {&MachineRecord::steal_share, kStealLimit, 1.0},
                              {&MachineRecord::load, kLoadLimit, 2.0},
                              {&MachineRecord::switches_per_s, kSwitchLimit, 2.0}};
    for (const Source& source : sources) {
        const auto at = [&](double value) {
            return judge_with(source.member, source.scale * value).verdict;
        };
        EXPECT_EQ(at(0.99 * source.limit.doubtful), MachineVerdict::fit);
        EXPECT_EQ(at(1.01 * source.limit.doubtful), MachineVerdict::doubtful);
        EXPECT_EQ(at(1.01 * source.limit.unfit), MachineVerdict::unfit);
    }
    EXPECT_EQ(judge({make_quiet()}, 0.03).verdict, MachineVerdict::doubtful);
    EXPECT_EQ(judge({make_quiet()}, 0.11).verdict, MachineVerdict::unfit);
    MachineRecord slow = make_quiet();
    slow.clock_mhz = 2700.0; // 10 % less
    const Fitness clock = judge({make_quiet(), slow});
    EXPECT_EQ(clock.verdict, MachineVerdict::doubtful);
    EXPECT_NEAR(*clock.clock_spread, 0.1, 1e-12);
}

TEST(Fitness, LongReplaysWeighMore) {
    MachineRecord busy = make_quiet();
    busy.wall_s = 3.0;
    busy.others_share = 0.2;
    EXPECT_NEAR(*judge({make_quiet(), busy}).others_share, (0.01 + 3.0 * 0.2) / 4.0, 1e-12);
}

TEST(Fitness, MissingSourcesAreSaidAndNothingIsFitUnwatched) {
    const Fitness bare = judge({MachineRecord{1.0, {}, {}, {}, {}, {}}});
    EXPECT_EQ(bare.verdict, MachineVerdict::fit);
    EXPECT_EQ(bare.unknown.size(), 5u);
    EXPECT_NE(describe_fitness(bare).find("not known: other processes (no /proc/stat), steal"),
              std::string::npos)
        << describe_fitness(bare);
    EXPECT_EQ(judge({}).verdict, MachineVerdict::doubtful);
}

TEST(Fitness, RepeatsThatResembleTheOnesBeforeRaiseDoubt) {
    EXPECT_EQ(judge({make_quiet()}, 0.01, {0.1, 0.2, 0.9}, 24).verdict, MachineVerdict::fit);
    const Fitness fitness = judge({make_quiet()}, 0.01, {0.1, 0.5, 0.9}, 24);
    EXPECT_EQ(fitness.verdict, MachineVerdict::doubtful);
    EXPECT_EQ(fitness.memory, 0.5);
    // surely there in 2400 repeats, and too little to matter
    EXPECT_EQ(judge({make_quiet()}, 0.01, {0.09}, 2400).verdict, MachineVerdict::fit);
    EXPECT_EQ(judge({make_quiet()}, 0.01, {0.11}, 2400).verdict, MachineVerdict::doubtful);
}

TEST(Fitness, StandsInEveryReport) {
    const synthetic::TemporaryFolder folder;
    const RunFolder run = synthetic::write_run(folder.path(), {});
    const RunAnalysis analysis = analyze_run(run);
    const RoundAnalysis& round = analysis.rounds.at(0);
    // The synthetic repeats are a ramp: what follows resembles what came before.
    EXPECT_EQ(round.machine.verdict, MachineVerdict::doubtful);
    EXPECT_NEAR(*round.machine.memory, 0.5, 0.05);
    EXPECT_NE(make_terminal_report(analysis, "page").find("  machine doubtful: repeats resemble"),
              std::string::npos);
    const std::string csv = make_summary_csv(analysis);
    for (const char* column :
         {",machine,machine_reasons,", ",outliers_mild,outliers_severe,", ",content_p99_ms,",
          ",content_slowest_1_percent_mean_ms,", ",content_time_integral_1_percent_ms,",
          ",noise_p99_ms,", ",stop_reason,", ",lag1,"}) {
        EXPECT_NE(csv.find(column), std::string::npos) << column;
    }
    EXPECT_NE(csv.find(",doubtful,"), std::string::npos);
}

TEST(Fitness, OutliersAreCountedAndKept) {
    const synthetic::TemporaryFolder folder;
    RunFolder run = RunFolder::create(folder.path() / "run", synthetic::make_context(),
                                      synthetic::make_plan({}));
    const RoundRecord round = run.plan().rounds[0];
    std::vector<SampleRow> samples = synthetic::make_samples(run.plan(), round);
    for (SampleRow& row : samples) {
        if (row.cell == "tssao" && row.repeat == 3 && row.kind == SampleKind::envelope) {
            row.time_ns *= 2;
        }
    }
    run.finish_round(round.id, samples, synthetic::make_metrics(round), {});
    const RunAnalysis analysis = analyze_run(run);
    const CellAnalysis& cell = analysis.rounds.at(0).cells.at(5);
    ASSERT_TRUE(cell.outliers);
    EXPECT_EQ(cell.outliers->severe, 1u);
    EXPECT_EQ(cell.outliers->n, 6u);
    EXPECT_EQ(cell.ratio->n, 6u) << "kept";
    EXPECT_EQ(describe_outliers(analysis.rounds[0]), "outlying repeats, kept: tssao 1 severe of 6");
    EXPECT_FALSE(analysis.rounds[0].cells.at(3).outliers->any());
}

} // namespace
} // namespace alcove
