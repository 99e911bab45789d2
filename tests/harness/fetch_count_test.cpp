// Fetches of methods' passes in a round: those that their shaders are known to make, and the same
// images as without.
#include "harness/run/fetch_count.hpp"
#include "tests/harness/round_runner_fixture.hpp"

#include <algorithm>

namespace alcove {
namespace {

class FetchCountTest : public RoundRunnerTest {
  protected:
    FetchCountTest() { m_counts_fetches = true; }

    double find(const std::string& cell, const std::string& pass) const {
        const auto found = std::find_if(
            m_result.done.fetches.begin(), m_result.done.fetches.end(),
            [&](const FetchRecord& record) { return record.cell == cell && record.pass == pass; });
        return found == m_result.done.fetches.end() ? -1.0 : found->fetches_per_pixel;
    }
};

TEST_F(FetchCountTest, SamplesAreFetchesAndBackgroundNeedsNone) {
    run({"ssao_environment:samples=16,blur=false", "ssao_environment:samples=8,blur=false"}, 1);
    const double sixteen = find(cell(0).id, "ssao_environment/occlusion");
    const double eight = find(cell(1).id, "ssao_environment/occlusion");
    // A pixel with a surface takes N samples; what else it fetches does not depend on N, and
    // samples outside the image, which have nothing to fetch, are few.
    const double share = (sixteen - eight) / 8.0;
    EXPECT_GT(share, 0.3);
    EXPECT_LE(share, 1.0);
    EXPECT_NEAR(sixteen - 16.0 * share, eight - 8.0 * share, 1e-9);
    EXPECT_LE(sixteen, 19.0);
    for (const FetchRecord& record : m_result.done.fetches) {
        EXPECT_EQ(record.frames, 3) << "the singles";
        EXPECT_GT(record.fetches_per_pixel, 0.0) << record.pass;
    }
}

TEST_F(FetchCountTest, HistoriesAreConvergedAndEveryTimedPassIsCounted) {
    run({"tssao"}, 1);
    for (const SampleRow& row : m_result.samples) {
        if (row.cell == cell(0).id && row.pass.starts_with("tssao/")) {
            EXPECT_GT(find(row.cell, row.pass), 0.0) << row.pass;
        }
    }
}

TEST_F(FetchCountTest, NothingIsCountedUnlessAskedFor) {
    m_counts_fetches = false;
    run({"ssao_environment"}, 1);
    EXPECT_TRUE(m_result.done.fetches.empty());
    EXPECT_EQ(m_result.done.counting_s, 0.0);
}

} // namespace
} // namespace alcove
