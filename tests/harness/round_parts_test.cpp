// Parts of a G-buffer are drawn for those who declare them, and charged to them alone.

#include "tests/harness/round_runner_fixture.hpp"

#include <map>

namespace alcove {
namespace {

TEST_F(RoundRunnerTest, DeclaredPartsAreGivenAndChargedAsInputCost) {
    run({"parts_method", "template_method"});
    const PartsLog& parts = parts_log();
    EXPECT_GT(parts.frames, kRoundFrames);
    EXPECT_EQ(parts.layers, 2u);
    EXPECT_EQ(parts.disordered, 0);
    EXPECT_GT(parts.deeper, 100);
    EXPECT_GT(parts.behind, 100);
    EXPECT_EQ(parts.views, 1u);
    EXPECT_EQ(parts.view_size, (ImageSize{48, 36}));
    EXPECT_EQ(parts.samples, 4);
    std::map<std::string, int> rows;
    for (const SampleRow& row : find_samples(cell(0).id, SampleState::cold)) {
        if (row.pass.starts_with("input/")) {
            ++rows[row.pass];
            EXPECT_TRUE(row.time_ns > 0 || row.pass == "input/border") << row.pass;
        }
    }
    const int expected = 2 * kRoundFrames;
    const std::map<std::string, int> all{{"input/border", expected}, {"input/layer2", expected},
                                         {"input/layer3", expected}, {"input/back_faces", expected},
                                         {"input/view1", expected},  {"input/msaa4", expected}};
    EXPECT_EQ(rows, all);
    for (const SampleRow& row : find_samples(cell(1).id, SampleState::cold)) {
        EXPECT_FALSE(row.pass.starts_with("input/layer")) << row.pass;
    }
}

} // namespace
} // namespace alcove
