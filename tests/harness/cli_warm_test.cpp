// `run --warm` and `run --reference` from the command line to the tables, in one run: each
// validates its timers first.

#include "reports/record/record.hpp"
#include "tests/harness/program.hpp"

namespace alcove {
namespace {

class WarmRun : public ProgramTest {
  protected:
    /// A history number or a metric of the cold frames, by frame.
    static std::map<int, double> read_values(const std::string& metric) {
        std::map<int, double> values;
        for (const MetricRow& row : RunFolder::open(folder() / "warm").read_metrics()) {
            if (row.metric == metric && row.state == SampleState::cold && row.value) {
                EXPECT_TRUE(values.emplace(row.frame, *row.value).second) << row.frame;
            }
        }
        return values;
    }
};

TEST_F(WarmRun, ASegmentBeginsConvergedAndIsFollowedFromThere) {
    const ChildResult warm =
        run({"run", "--scene", "template_scene", "--method", "tssao:history_cap=64", "--reference",
             "tssao@reference_480", "--size", "96x72", "--frames", "2:6", "--warm", "--repeat", "1",
             "--out", "warm"});
    ASSERT_EQ(warm.exit_code, 0) << warm.err;
    const std::map<int, double> converged = read_values("history_converged");
    ASSERT_EQ(converged.size(), 4u);
    EXPECT_GT(converged.at(2), 0.99);
    EXPECT_EQ(read_values("history_no_history").at(2), 0.0);
    EXPECT_EQ(read_values("temporal_flicker").size(), 3u)
        << "the first frame has none before it, however warm";
    const RunFolder folder_read = RunFolder::open(folder() / "warm");
    const RoundRecord& round = folder_read.plan().rounds.at(0);
    EXPECT_TRUE(round.warm);
    EXPECT_EQ(round.reference.method, "tssao");
    EXPECT_EQ(round.reference.preset, "reference_480");
    for (const MetricRow& row : folder_read.read_metrics()) {
        EXPECT_FALSE(row.floor.has_value()) << row.metric << ": the reference has no halves";
    }
}

} // namespace
} // namespace alcove
