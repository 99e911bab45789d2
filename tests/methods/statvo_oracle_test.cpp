// The shaders of statvo against the same formulas in double precision.
#include "tests/methods/depth_image_rig.hpp"
#include "tests/methods/statvo_oracle.hpp"
#include "tests/methods/statvo_rig.hpp"

#include <cmath>

namespace alcove {
namespace {

class StatvoOracleTest : public StatvoRig {
  protected:
    /// To 1e-4 where no sample in the box might lie in another layer. Elsewhere such a sample
    /// counts with its own psi, 1 at most, and by how far it moves the mean of a layer: four
    /// heights lie between the wall and what stands before it.
    void expect_equal(const Overrides& settings, double least_unflagged = 0.5) {
        SCOPED_TRACE(describe(settings));
        const ResolvedParameters resolved = resolve(m_unit, "default", settings);
        const auto params = m_unit.parameters.bind<StatvoParams>(resolved);
        const StatvoScene scene = make_statvo_scene(kStatvoSize);
        const RigResult result = run_peeled(m_unit, resolved, scene.visible, scene.hidden);
        const std::vector<StatvoPixel> oracle = evaluate_statvo_oracle(
            scene.visible.depth, result.normal, scene.hidden, scene.visible.camera, params);
        double unflagged = 0.0;
        double flagged = 0.0;
        int occluded = 0;
        double largest = 0.0;
        double largest_excess = 0.0;
        for (std::size_t i = 0; i < oracle.size(); ++i) {
            if (oracle[i].is_near) {
                continue;
            }
            const double deviation =
                std::abs(static_cast<double>(result.visibility.values()[i]) - oracle[i].visibility);
            occluded += oracle[i].visibility < 0.95 ? 1 : 0;
            flagged += oracle[i].flagged_share / static_cast<double>(oracle.size());
            largest_excess = std::max(largest_excess, deviation - 5.0 * oracle[i].flagged_share);
            if (oracle[i].flagged_share == 0.0) {
                unflagged += 1.0 / static_cast<double>(oracle.size());
                largest = std::max(largest, deviation);
            }
        }
        EXPECT_LE(largest, 1e-4);
        EXPECT_LE(largest_excess, 1e-4);
        EXPECT_GE(unflagged, least_unflagged);
        EXPECT_LE(flagged, 0.1);
        EXPECT_GE(occluded, 100) << "nothing was compared";
        RecordProperty("largest_deviation " + describe(settings), std::to_string(largest));
    }
};

TEST_F(StatvoOracleTest, AdaptiveLayersMatchAtEachSizeOfSamples) {
    for (const char* levels : {"0", "2", "3"}) {
        for (const char* downsample : {"1", "2", "3", "4"}) {
            // The deeper, the more often a sample is alone in its layer: at its own mean.
            expect_equal({{"levels", levels}, {"downsample", downsample}},
                         levels[0] == '3' ? 0.1 : 0.5);
        }
    }
}

TEST_F(StatvoOracleTest, AllTablesMatchAsDifferencesDo) {
    for (const char* levels : {"2", "3"}) {
        expect_equal({{"levels", levels}, {"tables", "all"}, {"downsample", "1"}});
        expect_equal({{"levels", levels}, {"tables", "all"}, {"downsample", "2"}});
    }
}

TEST_F(StatvoOracleTest, UniformLayersMatch) {
    for (const char* slices : {"8", "19"}) {
        expect_equal({{"layering", "uniform"}, {"slices", slices}, {"downsample", "1"}});
        expect_equal({{"layering", "uniform"}, {"slices", slices}, {"downsample", "2"}});
    }
}

TEST_F(StatvoOracleTest, EachKindOfNumbersMatches) {
    for (const char* numbers : {"float32", "float32_centred", "integer"}) {
        for (const char* downsample : {"1", "4"}) {
            expect_equal({{"numbers", numbers}, {"downsample", downsample}});
        }
    }
}

TEST_F(StatvoOracleTest, EachBoxAndProjectionMatches) {
    for (const char* regions : {"one", "four"}) {
        for (const char* downsample : {"1", "2"}) {
            const Overrides common{{"regions", regions}, {"downsample", downsample}};
            for (const Overrides& form :
                 {Overrides{{"projection", "normal"}},
                  Overrides{{"projection", "view_aligned"}, {"box", "surface"}},
                  Overrides{{"projection", "view_aligned"}, {"box", "centre"}},
                  Overrides{{"height", "0.3"}, {"drop", "4"}, {"strength", "1.5"}}}) {
                Overrides settings = common;
                settings.insert(settings.end(), form.begin(), form.end());
                expect_equal(settings);
            }
        }
    }
}

TEST_F(StatvoOracleTest, PeeledSamplesMatch) {
    for (const char* downsample : {"1", "4"}) {
        expect_equal({{"source", "peeled"}, {"downsample", downsample}});
        expect_equal({{"source", "peeled"},
                      {"downsample", downsample},
                      {"layering", "uniform"},
                      {"slices", "5"}});
    }
}

TEST_F(StatvoOracleTest, ABoxAsLargeAsTheImageMatches) {
    expect_equal({{"radius", "40"}, {"height", "2"}, {"downsample", "4"}});
    expect_equal({{"radius", "40"}, {"height", "2"}, {"downsample", "1"}});
}

TEST(StatvoPsi, IsZeroThenTheShareThenFallsWithItsSlope) {
    EXPECT_EQ(compute_oracle_psi(-1.0, 2.0), 0.0);
    EXPECT_EQ(compute_oracle_psi(0.0, 2.0), 0.0);
    EXPECT_EQ(compute_oracle_psi(0.5, 2.0), 0.5);
    EXPECT_EQ(compute_oracle_psi(1.0, 2.0), 1.0);
    EXPECT_DOUBLE_EQ(compute_oracle_psi(1.25, 2.0), 0.5);
    EXPECT_EQ(compute_oracle_psi(1.5, 2.0), 0.0);
    EXPECT_EQ(compute_oracle_psi(9.0, 2.0), 0.0);
}

} // namespace
} // namespace alcove
