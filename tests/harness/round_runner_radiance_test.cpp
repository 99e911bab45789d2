// Rounds whose target is radiance: pictures are measured, of every method alike.
#include "core/base/image_file.hpp"
#include "core/frame/compose.hpp"
#include "tests/harness/expect_error.hpp"
#include "tests/harness/round_runner_fixture.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace alcove {
namespace {

namespace fs = std::filesystem;

class RoundRadianceTest : public RoundRunnerTest {
  protected:
    RoundRadianceTest() { m_target = "output=radiance"; }

    /// Values of a metric of the i-th method, by segment and frame, cold.
    [[nodiscard]] std::map<std::pair<int, int>, MetricRow>
    find_rows(std::size_t method, const std::string& name) const {
        std::map<std::pair<int, int>, MetricRow> rows;
        for (const MetricRow& row : m_result.metrics) {
            if (row.cell == cell(method).id && row.metric == name &&
                row.state == SampleState::cold) {
                rows[{row.segment, row.frame}] = row;
            }
        }
        return rows;
    }
    [[nodiscard]] fs::path picture(const std::string& cell, int frame, const char* name) const {
        return m_folder.path() / RunFolder::make_image_path(round().id, cell, frame, name);
    }
};

TEST_F(RoundRadianceTest, AMethodAgainstItselfIsExactInEveryImageMetric) {
    m_reference = "hemisphere_ssao";
    run({"hemisphere_ssao", "none"}, 1);
    for (const char* metric : {"rmse", "flip", "chroma_error", "energy_ratio"}) {
        const auto own = find_rows(0, metric);
        ASSERT_EQ(own.size(), static_cast<std::size_t>(kRoundFrames)) << metric;
        for (const auto& [frame, row] : own) {
            EXPECT_EQ(row.value, 0.0) << metric << " of frame " << frame.second << row.note;
        }
        for (const auto& [frame, row] : find_rows(1, metric)) {
            EXPECT_GT(row.value.value(), 0.0) << metric << " of frame " << frame.second;
        }
    }
}

TEST_F(RoundRadianceTest, RadianceTakesThePlaceOfAmbientLight) {
    // Against black, the light of the method alone is too much: it adds (R, 0, 0) to the direct
    // light, where there is a surface.
    m_reference = "light_method:red=0";
    run({"light_method:red=0", "light_method:red=1", "light_method:red=1,gives_both=true"}, 1);
    for (const auto& [frame, row] : find_rows(0, "rmse")) {
        EXPECT_EQ(row.value, 0.0);
    }
    const auto alone = find_rows(1, "rmse");
    const auto both = find_rows(2, "rmse");
    for (const auto& [frame, row] : alone) {
        EXPECT_GT(row.value.value(), 0.01);
        EXPECT_EQ(row.value, both.at(frame).value) << "its visibility has no part in the picture";
        EXPECT_EQ(row.image_hash, both.at(frame).image_hash);
    }
    EXPECT_EQ(light_log().asked, 0) << "pictures have no use for visibility";
}

TEST_F(RoundRadianceTest, KeepsThePictureThatIsMeasured) {
    m_reference = "light_method:red=0";
    m_films_burst = true;
    run({"light_method:red=1"}, 1);
    const int frame = round().image_frames.front();
    const std::string& id = cell(0).id;
    const Image kept = read_image_file(picture(id, frame, "picture")).image;
    const Image truth = read_image_file(picture("reference", frame, "picture")).image;
    ASSERT_EQ(kept.channels(), 3);
    // What is kept is off by half a code; the errors that it shows are those of the table.
    double sum = 0.0;
    bool is_redder = false;
    Image expected(kept.size(), 1);
    for (int y = 0; y < kept.height(); ++y) {
        for (int x = 0; x < kept.width(); ++x) {
            // tone_map backwards: the root of x^2 / 16 + (1 - t) x - t.
            const float t = decode_srgb(truth.at(x, y));
            expected.at(x, y) =
                1.0f + 8.0f * (std::sqrt((1.0f - t) * (1.0f - t) + 0.25f * t) - (1.0f - t));
        }
    }
    expected = tone_map(expected);
    for (int y = 0; y < kept.height(); ++y) {
        for (int x = 0; x < kept.width(); ++x) {
            for (int c = 0; c < 3; ++c) {
                const double error = static_cast<double>(decode_srgb(kept.at(x, y, c))) -
                                     static_cast<double>(decode_srgb(truth.at(x, y, c)));
                sum += error * error;
                if (c == 0 && error > 0.01) { // a surface: the background takes no light
                    is_redder = true;
                    EXPECT_NEAR(decode_srgb(kept.at(x, y)), expected.at(x, y), 0.02);
                }
                EXPECT_TRUE(c == 0 || std::abs(error) < 0.01);
            }
        }
    }
    EXPECT_TRUE(is_redder);
    const double rmse = std::sqrt(sum / static_cast<double>(kept.values().size()));
    for (const auto& [key, row] : find_rows(0, "rmse")) {
        if (key.second == frame && key.first > 0) {
            EXPECT_NEAR(rmse, row.value.value(), 0.005);
        }
    }
    EXPECT_TRUE(fs::exists(picture(id, frame, "error")));
    EXPECT_FALSE(fs::exists(picture(id, frame, "visibility")));
    EXPECT_FALSE(fs::exists(picture(id, frame, "shaded")));
    const SegmentRecord& film = round().film;
    EXPECT_TRUE(fs::exists(picture(id, film.begin, "film_picture")));
    EXPECT_TRUE(fs::exists(picture("reference", film.begin, "film_picture")));
    EXPECT_EQ(read_image_file(picture(id, film.end - 1, "accumulated_profile")).image.channels(),
              3);
}

TEST_F(RoundRadianceTest, MetricsOverTimeLookAtTheLuminance) {
    m_reference = "light_method:red=0";
    run({"light_method:red=0", "hemisphere_ssao"}, 1);
    int values = 0;
    for (const auto& [frame, row] : find_rows(0, "temporal_flicker")) {
        EXPECT_EQ(row.value, 0.0);
    }
    for (const auto& [frame, row] : find_rows(1, "temporal_flicker")) {
        EXPECT_GT(row.value.value(), 0.0);
        ++values;
    }
    EXPECT_EQ(values, 2) << "frames 1 and 3 follow another one";
}

TEST_F(RoundRadianceTest, MeasuresAgainstPathTracedHalvesByDefault) {
    run({"none", "reference_path_traced:rays=512"}, 1);
    EXPECT_EQ(round().reference.method, "reference_path_traced");
    const auto none = find_rows(0, "rmse");
    for (const auto& [frame, row] : none) {
        EXPECT_TRUE(row.debiased && row.floor) << "two halves";
        EXPECT_GT(*row.floor, 0.0);
        EXPECT_GT(row.debiased.value(), *row.floor) << "open everywhere is too bright";
    }
    // The tracer as a method, in half floats and another rasteriser's direct light.
    for (const auto& [frame, row] : find_rows(1, "rmse")) {
        EXPECT_LT(row.debiased.value(), 0.5 * none.at(frame).debiased.value());
    }
}

TEST_F(RoundRadianceTest, TheReferencesOwnParametersCount) {
    // Without a bounce occluders are black, which is what visibility says; with one they send about
    // as much light as the surroundings.
    m_reference = "reference_path_traced:bounces=0";
    run({"none", "reference_ray_traced:rays=512"}, 1);
    const auto none = find_rows(0, "rmse");
    for (const auto& [frame, row] : find_rows(1, "rmse")) {
        EXPECT_LT(row.debiased.value(), 0.2 * none.at(frame).debiased.value());
    }
    m_reference.clear();
    run({"none", "reference_ray_traced:rays=512"}, 1);
    for (const auto& [frame, row] : find_rows(1, "rmse")) {
        EXPECT_GT(row.debiased.value(), 0.2 * none.at(frame).debiased.value());
    }
}

TEST_F(RoundRadianceTest, RegionsTellTheirOwnEnergy) {
    m_reference = "light_method:red=0";
    m_regions = {"box", "floor"};
    run({"light_method:red=1"}, 1);
    for (const char* region : {"box", "floor"}) {
        const auto rows = find_rows(0, std::string("energy_ratio[") + region + "]");
        ASSERT_EQ(rows.size(), static_cast<std::size_t>(kRoundFrames)) << region;
        for (const auto& [frame, row] : rows) {
            EXPECT_GT(row.value.value(), 0.0) << region;
        }
    }
    const auto box = find_rows(0, "pixels[box]");
    const auto floor = find_rows(0, "pixels[floor]");
    for (const auto& [frame, row] : box) {
        EXPECT_GT(row.value.value(), 0.0);
        EXPECT_LT(row.value.value(), floor.at(frame).value.value());
    }
    EXPECT_TRUE(find_rows(0, "rmse[depth_edges]").empty()) << "strata are asked for apart";
}

TEST_F(RoundRadianceTest, AnUnchangedRoundIsReused) {
    m_reference = "light_method:red=0";
    m_keeps_cache = true;
    run({"hemisphere_ssao"}, 1);
    const auto first = find_rows(0, "rmse");
    run({"hemisphere_ssao"}, 1);
    for (const ReuseRecord& item : m_result.done.reuse) {
        EXPECT_EQ(item.outcome, "reused") << item.what << ": " << item.reason;
        const bool knows_lights =
            std::any_of(item.contents.begin(), item.contents.end(),
                        [](const IngredientRecord& part) { return part.name == "lights"; });
        EXPECT_TRUE(knows_lights) << item.what;
    }
    for (const auto& [frame, row] : find_rows(0, "rmse")) {
        EXPECT_EQ(row.value, first.at(frame).value);
    }
    m_target.clear();
    run({"hemisphere_ssao"}, 1);
    for (const ReuseRecord& item : m_result.done.reuse) {
        EXPECT_EQ(item.outcome, "made") << "another target: " << item.what;
    }
}

class RoundVisibilityTest : public RoundRunnerTest {};

TEST_F(RoundVisibilityTest, AsksMethodsOfRadianceForTheirVisibilityAndNotWhileTimesAreTaken) {
    m_reference = "constant";
    run({"light_method"}, 2);
    EXPECT_EQ(light_log().asked, kRoundFrames) << "the capture";
    EXPECT_GE(light_log().unasked, 2 * kRoundFrames) << "the timing replays";
    int rows = 0;
    for (const MetricRow& row : m_result.metrics) {
        if (row.metric == "energy_ratio") {
            ADD_FAILURE() << "a metric of pictures";
        }
        rows += row.metric == "rmse" ? 1 : 0;
    }
    EXPECT_EQ(rows, kRoundFrames);
}

TEST_F(RoundVisibilityTest, RefusesAMethodThatHasNone) {
    expect_error([&] { run({"light_method:is_stubborn=true"}, 1); }, 2,
                 {"light_method", "radiance alone", "output=radiance"});
}

} // namespace
} // namespace alcove
