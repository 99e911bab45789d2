// The verdicts of `reproduce ssdo` on forged runs of its parts: every claim has one, and they
// follow the times and errors that were planted.
#include "reports/papers/ssdo/ssdo.hpp"
#include "tests/reports/forged_reproduction.hpp"

#include <gtest/gtest.h>

namespace alcove {
namespace {

class SsdoReproduction : public testing::Test {
  protected:
    static Reproduction reproduce(const Planted& planted) {
        // Planned once: a scene of a part has a million triangles.
        static ForgedRuns runs{"ssdo",
                               {"ssdo/direct", "ssdo/bounce", "ssao_environment/occlusion"}};
        return reproduce_ssdo(runs.forge(planted), "small");
    }
};

/// Passes of table 1 in milliseconds; beside them a frame has 10. In proportion to the paper's at
/// 1600x1200, less what smaller sizes save.
Planted plant_times() {
    Planted planted;
    const double kPixels[] = {0.41, 0.6, 0.64, 1.0};
    for (std::size_t round = 0; round < 4; ++round) {
        const std::string place = "table1:" + std::to_string(round) + ":";
        const double pixels = kPixels[round];
        planted.cost_ms[place + "nothing"] = 0.0;
        planted.cost_ms[place + "SSAO 8"] = 32.0 * pixels;
        planted.cost_ms[place + "SSDO 8"] = 33.0 * pixels;
        planted.cost_ms[place + "bounce 8"] = 50.0 * pixels;
        planted.cost_ms[place + "SSAO 16"] = 51.0 * pixels;
        planted.cost_ms[place + "SSDO 16"] = 56.0 * pixels;
        planted.cost_ms[place + "bounce 16"] = 90.0 * pixels;
    }
    planted.cost_ms["fig7:0:one view"] = 10.0;
    planted.cost_ms["fig7:0:four cameras"] = 21.0; // a frame of 31 against 20
    planted.cost_ms["fig7:0:two layers"] = 17.0;
    planted.cost_ms["fig7_large:0:one view"] = 10.0;
    planted.cost_ms["fig7_large:0:four cameras"] = 42.0;
    planted.cost_ms["fig7_large:0:two layers"] = 17.0;
    // Frames of 2.12, 2.99 and 2.14 times the bias's, and a third more with two layers.
    planted.cost_ms["fig9:0:bias"] = 5.0;
    planted.cost_ms["fig9:0:corrected, 16 samples"] = 21.8;
    planted.cost_ms["fig9:0:corrected, 2 layers, 8 samples"] = 34.9;
    planted.cost_ms["fig10:0:bias"] = 5.0;
    planted.cost_ms["fig10:0:corrected"] = 22.1;
    planted.cost_ms["fig6:0:1 layer, 0.5 m"] = 5.0;
    planted.cost_ms["fig6:0:2 layers, 0.5 m"] = 9.5;
    return planted;
}

/// Errors as the paper has them.
Planted plant_errors() {
    Planted planted;
    planted.error = {{"nothing", 0.06},
                     {"SSAO", 0.05},
                     {"SSDO", 0.04},
                     {"bounce", 0.03},
                     {"identity:0:SSDO", 0.0001},
                     {"identity:1:SSDO", 0.1},
                     {"turning_light:0:SSAO", 0.01},
                     {"turning_light:0:SSDO", 0.9},
                     {"1 layer", 0.06},
                     {"2 layers", 0.05},
                     {"4 layers", 0.04},
                     {"4 layers, 4 cameras", 0.03},
                     {"4 samples, 1 set", 0.09},
                     {"64 samples, 1 set", 0.05},
                     {"4 samples", 0.09},
                     {"16 samples", 0.06},
                     {"64 samples", 0.05},
                     {"256 samples", 0.04},
                     {"converged:0:256 samples", 0.045},
                     {"converged:1:256 samples", 0.045},
                     {"converged:0:64 samples", 0.05},
                     {"bandwidth:0:16 samples", 0.01},
                     {"bandwidth:1:16 samples", 0.02},
                     {"bandwidth:2:16 samples", 0.09},
                     {"fig7:0:one view", 0.05},
                     {"fig7:0:four cameras", 0.04},
                     {"fig6:0:1 layer, 1 m", 0.09},
                     {"fig6:0:2 layers, 1 m", 0.03},
                     {"fig9:0:corrected, 16 samples", 0.03},
                     {"fig9:0:corrected, 2 layers, 8 samples", 0.02},
                     {"fig11_corrected:0:fine maps", 0.01},
                     {"fig12:0:clamped part", 0.04},
                     {"fig12:0:added", 0.03},
                     {"flicker:0:bounce", 0.05},
                     {"distance:1:SSDO", 0.038},
                     {"distance:2:SSDO", 0.03},
                     {"distance:3:SSDO", 0.025}};
    for (std::size_t round = 0; round < 4; ++round) {
        const std::string at = std::to_string(round) + ":SSDO";
        planted.error["fig14_shadow:" + at] = 0.01 * static_cast<double>(round + 1);
        planted.error["fig14_bounce:" + at] = 0.01 * static_cast<double>(round + 1);
    }
    for (std::size_t round = 0; round < 8; ++round) {
        const std::string place = "silhouettes:" + std::to_string(round) + ":";
        planted.error[place + "1 layer"] = 0.01 * static_cast<double>(round % 4 + 1);
        planted.error[place + "2 layers"] = 0.005;
    }
    return planted;
}

TEST_F(SsdoReproduction, HasAVerdictForEachClaimAndRowsThatFit) {
    const Reproduction reproduction = reproduce({});
    EXPECT_EQ(reproduction.verdicts.size(), 90u);
    EXPECT_EQ(reproduction.tables.size(), 10u);
    for (const PaperTable& table : reproduction.tables) {
        EXPECT_FALSE(table.rows.empty()) << table.id;
        for (const std::vector<std::string>& row : table.rows) {
            EXPECT_EQ(row.size(), table.columns.size()) << table.id;
        }
    }
    for (const PaperFigure& figure : reproduction.figures) {
        EXPECT_FALSE(figure.pictures.empty()) << figure.title;
    }
    EXPECT_FALSE(reproduction.errata.empty());
    // With equal times and errors nothing is faster, darker or nearer than anything else.
    for (const char* id :
         {"SSDO-001", "SSDO-004", "SSDO-030", "SSDO-035", "SSDO-036", "SSDO-037", "SSDO-043",
          "SSDO-044", "SSDO-045", "SSDO-049", "SSDO-050", "SSDO-052", "SSDO-067", "SSDO-068",
          "SSDO-074", "SSDO-083", "SSDO-085", "SSDO-088", "SSDO-089", "SSDO-090"}) {
        EXPECT_NE(find_outcome(reproduction, id), Outcome::holds) << id;
    }
    // What was set, times that are equal at all polygons, flicker that is equal.
    for (const char* id :
         {"SSDO-032", "SSDO-053", "SSDO-071", "SSDO-072", "SSDO-073", "SSDO-079", "SSDO-080"}) {
        EXPECT_EQ(find_outcome(reproduction, id), Outcome::holds) << id;
    }
}

TEST_F(SsdoReproduction, VerdictsFollowPlantedTimes) {
    Planted planted = plant_times();
    Reproduction reproduction = reproduce(planted);
    for (const char* id :
         {"SSDO-001", "SSDO-003", "SSDO-005", "SSDO-020", "SSDO-028", "SSDO-030", "SSDO-031",
          "SSDO-033", "SSDO-034", "SSDO-035", "SSDO-036", "SSDO-037", "SSDO-038", "SSDO-039",
          "SSDO-040", "SSDO-047", "SSDO-048", "SSDO-049", "SSDO-051", "SSDO-052", "SSDO-054",
          "SSDO-056", "SSDO-057", "SSDO-058", "SSDO-060", "SSDO-061"}) {
        EXPECT_EQ(find_outcome(reproduction, id), Outcome::holds) << id;
    }
    // Lookups that cost as much as samples; a bounce that is free; a size that costs twice as much
    // a pixel; cameras that cost more of little than of much; passes that draw triangles.
    planted.cost_ms["table1:3:SSDO 16"] = 80.0;
    planted.cost_ms["table1:0:bounce 8"] = 13.0;
    planted.cost_ms["table1:1:SSAO 8"] = 40.0;
    planted.cost_ms["fig7:0:four cameras"] = 90.0;
    planted.cost_ms["polygons:1:direct"] = 8.0;
    planted.cost_ms["fig9:0:corrected, 2 layers, 8 samples"] = 15.0;
    planted.cost_ms["fig10:0:corrected"] = 60.0;
    planted.cost_ms["fig6:0:2 layers, 0.5 m"] = 40.0;
    reproduction = reproduce(planted);
    for (const char* id :
         {"SSDO-005", "SSDO-028", "SSDO-038", "SSDO-049", "SSDO-052", "SSDO-054", "SSDO-079"}) {
        EXPECT_EQ(find_outcome(reproduction, id), Outcome::fails) << id;
    }
}

TEST_F(SsdoReproduction, VerdictsFollowPlantedErrors) {
    Planted planted = plant_errors();
    Reproduction reproduction = reproduce(planted);
    for (const char* id : {"SSDO-043", "SSDO-045", "SSDO-050", "SSDO-067", "SSDO-068", "SSDO-074",
                           "SSDO-075", "SSDO-085", "SSDO-086", "SSDO-087", "SSDO-088", "SSDO-089",
                           "SSDO-090", "SSDO-046", "SSDO-059", "SSDO-065", "SSDO-066"}) {
        EXPECT_EQ(find_outcome(reproduction, id), Outcome::holds) << id;
    }
    // One scene where ambient occlusion is nearer; shadows of SSAO that have a colour; light that
    // depends on its direction where it has none; layers, samples and radii that turn round.
    planted.error["fig13:7:SSDO"] = 0.055;
    planted.error["turning_light:0:SSAO"] = 0.4;
    planted.error["identity:0:SSDO"] = 0.02;
    planted.error["fig5:2:2 layers"] = 0.07;
    planted.error["fig14_bounce:3:SSDO"] = 0.02;
    planted.error["silhouettes:5:2 layers"] = 0.05;
    planted.error["bandwidth:1:16 samples"] = 0.005;
    planted.error["flicker:1:SSDO"] = 0.06;
    planted.error["fig7:0:four cameras"] = 0.06;
    planted.error["fig6:0:2 layers, 1 m"] = 0.1;
    planted.error["fig9:0:corrected, 16 samples"] = 0.08;
    planted.error["fig11_corrected:0:fine maps"] = 0.08;
    planted.error["fig12:0:added"] = 0.08;
    planted.error["distance:3:SSDO"] = 0.01;
    reproduction = reproduce(planted);
    for (const char* id : {"SSDO-043", "SSDO-045", "SSDO-050", "SSDO-067", "SSDO-068", "SSDO-074",
                           "SSDO-080", "SSDO-085", "SSDO-086", "SSDO-088", "SSDO-089", "SSDO-090",
                           "SSDO-046", "SSDO-059", "SSDO-065", "SSDO-066"}) {
        EXPECT_EQ(find_outcome(reproduction, id), Outcome::fails) << id;
    }
}

} // namespace
} // namespace alcove
