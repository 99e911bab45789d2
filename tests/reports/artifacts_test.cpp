// The artefact catalogue names cells that its experiments run, and what it computes is right.
#include "reports/papers/artifacts/artifacts_parts.hpp"

#include "harness/run/experiment_file.hpp"
#include "harness/run/plan.hpp"
#include "reports/papers/paper_files.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include <gtest/gtest.h>

namespace alcove {
namespace {

Experiment read_part(const std::string& part) {
    const std::string name = "reports/papers/artifacts/" + part + ".toml";
    return parse_experiment(find_paper_file(name), name, std::filesystem::current_path(),
                            get_units());
}

TEST(Artifacts, NameCellsAndMetricsOfTheirExperiments) {
    std::set<std::string> numbers;
    for (const Artifact& artifact : list_artifacts()) {
        SCOPED_TRACE(artifact.number);
        EXPECT_TRUE(numbers.insert(artifact.number).second);
        for (const CellAddress& address : {artifact.on, artifact.off}) {
            SCOPED_TRACE(address.label);
            const Experiment part = read_part(address.part);
            const PlanRecord plan = make_plan(part, get_units()).record;
            ASSERT_LT(address.round, plan.rounds.size());
            const auto& cells = plan.rounds[address.round].cells;
            const auto cell = std::find_if(cells.begin(), cells.end(), [&](const CellRecord& one) {
                return one.label == address.label;
            });
            ASSERT_NE(cell, cells.end());
            EXPECT_TRUE(std::any_of(plan.metrics.begin(), plan.metrics.end(),
                                    [&](const auto& one) { return one.name == artifact.metric; }));
        }
    }
    EXPECT_EQ(numbers, (std::set<std::string>{"4.1", "4.2", "4.3", "4.4", "4.5", "4.7", "4.8",
                                              "4.9"})); // 4.6 is a picture, 4.10 a time
}

TEST(Artifacts, AnglesOfTiltedNormalsClump) {
    // By hand at 60 degrees: vectors at 0, 45 and 90 degrees are turned to 0, atan(1/2) = 26.57 and
    // 90: gaps of 26.57 and 63.43 degrees.
    const PaperTable table = make_angles_table();
    const auto find_row = [&](const std::string& tilt) {
        return *std::find_if(table.rows.begin(), table.rows.end(),
                             [&](const auto& row) { return row.front() == tilt; });
    };
    EXPECT_EQ(find_row("60").at(1), "2.39");
    EXPECT_EQ(find_row("0").at(1), "1");
    EXPECT_EQ(find_row("0").at(2), "0");
    double before = -1.0;
    for (const auto& row : table.rows) {
        const double chi_square = std::stod(row.at(2));
        EXPECT_GT(chi_square, before) << row.front();
        before = chi_square;
    }
}

} // namespace
} // namespace alcove
