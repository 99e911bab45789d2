// The verdicts of `reproduce shanmugam_arikan` on forged runs of its parts: every claim has one,
// and they follow the times, errors and images that were planted.
#include "reports/papers/shanmugam_arikan/shanmugam_arikan.hpp"
#include "tests/reports/forged_reproduction.hpp"

#include <gtest/gtest.h>

namespace alcove {
namespace {

class ShanmugamArikanReproduction : public testing::Test {
  protected:
    static Reproduction reproduce(const Planted& planted) {
        // Planned once: a scene of a part has a million triangles.
        static ForgedRuns runs{"shanmugam_arikan",
                               {"shanmugam_arikan/near", "shanmugam_arikan/spheres",
                                "shanmugam_arikan/far", "shanmugam_arikan/combine"}};
        return reproduce_shanmugam_arikan(runs.forge(planted), "small");
    }
};

/// Times as the paper has them: by neighbours and billboards, and two milliseconds of six thousand
/// spheres in a frame of 38.
Planted plant_times() {
    Planted planted;
    for (const int count : {8, 16, 32, 64, 128, 256}) {
        planted.cost_ms["neighbours:0:" + std::to_string(count) + " (native)"] = 1.0 + 0.1 * count;
    }
    planted.cost_ms.insert({{"distance:0:near (native)", 16.0},
                            {"distance:1:near (native)", 4.0},
                            {"distance:2:near (native)", 1.0},
                            {"r_far:0:1.25 units (native)", 1.0},
                            {"r_far:0:2.5 units (native)", 2.0},
                            {"r_far:0:5 units (native)", 4.0},
                            {"r_far:0:10 units (native)", 8.0},
                            {"fill:0:epsilon 0.5 (native)", 6.54},
                            {"fill:0:epsilon 0.3 (native)", 10.73},
                            {"fill:0:epsilon 0.2 (native)", 15.96},
                            {"fill:0:epsilon 0.1 (native)", 31.67},
                            {"fill:0:epsilon 0.05 (native)", 63.08},
                            {"fill:0:1000 spheres (native)", 31.0},
                            {"shares:0:near (native)", 26.0},
                            {"shares:0:as printed (native)", 28.0},
                            {"shares:0:combined (native)", 28.0},
                            {"shares:0:as printed, far (native)", 2.0},
                            {"shares:0:far (native)", 2.0}});
    return planted;
}

/// Errors and occlusion as the paper has them.
Planted plant_errors() {
    Planted planted;
    planted.error = {{"figure5:0:combined (native)", 0.04},
                     {"figure5:0:as printed (native)", 0.04},
                     {"figure5:1:combined (native)", 0.04},
                     {"figure5:1:as printed (native)", 0.04},
                     {"layers:0:1 layer (native)", 0.045},
                     {"layers:0:2 layers (native)", 0.03},
                     {"layers:0:3 layers (native)", 0.03},
                     {"layers:0:4 layers (native)", 0.03},
                     {"layers:1:1 layer (native)", 0.06},
                     {"occlusion:0:160 units (native)", 0.4},
                     {"occlusion:0:40 units (native)", 0.3},
                     {"occlusion:0:10 units (native)", 0.2},
                     {"occlusion:0:2 units (native)", 0.1},
                     {"occlusion:0:combined (native)", 0.45},
                     {"occlusion:0:multiplicative (native)", 0.42},
                     {"rays:0:10 units (native)", 0.95},
                     {"rays:0:2 units (native)", 0.1},
                     {"rays:0:constant (native)", 0.3},
                     {"planes:0:near (native)", 0.001},
                     {"planes:1:near (native)", 0.001},
                     {"planes:2:near (native)", 0.001},
                     {"far_camera:1:near (native)", 0.06},
                     {"far_camera:2:near (native)", 0.07},
                     {"low_poly:0:near (native)", 0.06}};
    return planted;
}

TEST_F(ShanmugamArikanReproduction, HasAVerdictForEachClaimAndRowsThatFit) {
    const Reproduction reproduction = reproduce({});
    EXPECT_EQ(reproduction.verdicts.size(), 49u);
    EXPECT_EQ(reproduction.tables.size(), 7u);
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
    // With equal times and errors nothing is faster or nearer than anything else.
    for (const char* id :
         {"SA07-012", "SA07-014", "SA07-016", "SA07-021", "SA07-022", "SA07-023", "SA07-028",
          "SA07-033", "SA07-035", "SA07-036", "SA07-038", "SA07-039", "SA07-041", "SA07-047"}) {
        EXPECT_NE(find_outcome(reproduction, id), Outcome::holds) << id;
    }
    // Equal times at all polygons, errors that do not change while figures walk, equal images.
    for (const char* id : {"SA07-010", "SA07-024", "SA07-032", "SA07-034"}) {
        EXPECT_EQ(find_outcome(reproduction, id), Outcome::holds) << id;
    }
}

TEST_F(ShanmugamArikanReproduction, VerdictsFollowPlantedTimesAndImages) {
    Planted planted = plant_times();
    const char* const kClaims[] = {"SA07-014", "SA07-022", "SA07-032", "SA07-033",
                                   "SA07-038", "SA07-039", "SA07-047"};
    Reproduction reproduction = reproduce(planted);
    for (const char* id : kClaims) {
        EXPECT_EQ(find_outcome(reproduction, id), Outcome::holds) << id;
    }
    // Twice the time at a million triangles; a far part that takes as long as the rest of a frame,
    // in one of both readings; time that goes with the number of spheres.
    planted.cost_ms["polygons:1:near (native)"] = 8.0;
    planted.cost_ms["shares:0:combined (native)"] = 60.0;
    planted.cost_ms["shares:0:far (native)"] = 36.0;
    planted.cost_ms["fill:0:1000 spheres (native)"] = 31.67 / 6.0;
    // A frame that depends on those before it.
    planted.image_hash["independence:0:combined (native)"] = "0123456789abcdef";
    planted.image_hash["independence:1:combined (native)"] = "0123456789abcdee";
    reproduction = reproduce(planted);
    for (const char* id : {"SA07-010", "SA07-022", "SA07-032", "SA07-038", "SA07-039"}) {
        EXPECT_EQ(find_outcome(reproduction, id), Outcome::fails) << id;
    }
    EXPECT_EQ(find_outcome(reproduction, "SA07-034"), Outcome::holds); // of the near part alone
}

TEST_F(ShanmugamArikanReproduction, VerdictsFollowPlantedErrors) {
    Planted planted = plant_errors();
    Reproduction reproduction = reproduce(planted);
    for (const char* id :
         {"SA07-012", "SA07-016", "SA07-017", "SA07-018", "SA07-021", "SA07-023", "SA07-028",
          "SA07-030", "SA07-035", "SA07-036", "SA07-040", "SA07-041", "SA07-049"}) {
        EXPECT_EQ(find_outcome(reproduction, id), Outcome::holds) << id;
    }
    // One reading of the paper alone is worse; a black room; a self-occluding plane; spheres that
    // stay behind; a third layer that matters.
    planted.error["figure5:0:combined (native)"] = 0.06;
    planted.error["figure5:1:as printed (native)"] = 0.06;
    planted.error["closed_room:0:as printed (native)"] = 0.9;
    planted.error["planes:1:near (native)"] = 0.02;
    planted.error["deforming:1:silhouettes (native)"] = 0.08;
    planted.error["layers:0:4 layers (native)"] = 0.06;
    planted.error["layers:1:3 layers (native)"] = 0.04; // as much as the second gains
    reproduction = reproduce(planted);
    for (const char* id :
         {"SA07-012", "SA07-023", "SA07-024", "SA07-028", "SA07-030", "SA07-040", "SA07-049"}) {
        EXPECT_EQ(find_outcome(reproduction, id), Outcome::fails) << id;
    }
}

} // namespace
} // namespace alcove
