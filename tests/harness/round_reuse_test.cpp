#include "harness/run/round_reuse.hpp"

#include "harness/run/gbuffer_store.hpp"
#include "tests/harness/expect_error.hpp"
#include "tests/harness/round_runner_fixture.hpp"

#include <algorithm>
#include <fstream>
#include <map>

namespace alcove {
namespace {

namespace fs = std::filesystem;

class Reuse : public RoundRunnerTest {
  protected:
    Reuse() { m_keeps_cache = true; }

    std::map<std::string, std::string> list_outcomes() const {
        std::map<std::string, std::string> outcomes;
        for (const ReuseRecord& item : m_result.done.reuse) {
            outcomes[item.what] = item.outcome;
        }
        return outcomes;
    }
    std::string find_reason(const std::string& what) const {
        for (const ReuseRecord& item : m_result.done.reuse) {
            if (item.what == what) {
                return item.reason;
            }
        }
        return {};
    }
    /// Every row, in an order of its own.
    std::vector<std::string> list_numbers() const {
        std::vector<std::string> numbers;
        for (const MetricRow& row : m_result.metrics) {
            numbers.push_back(row.cell + " " + std::to_string(row.segment) + " " +
                              std::to_string(row.frame) + " " + row.metric + " " +
                              std::to_string(row.value.value_or(-1.0)) + " " + row.image_hash);
        }
        std::sort(numbers.begin(), numbers.end());
        return numbers;
    }
    std::map<std::string, std::string> read_pictures() const {
        std::map<std::string, std::string> pictures;
        for (const auto& file : fs::recursive_directory_iterator(m_folder.path() / "images")) {
            if (file.is_regular_file()) {
                std::ifstream stream(file.path(), std::ios::binary);
                pictures[file.path().string()].assign(std::istreambuf_iterator<char>(stream), {});
            }
        }
        return pictures;
    }
};

TEST_F(Reuse, AnUnchangedRoundIsTimedAnewAndNothingElse) {
    m_films_burst = true;
    run({"none", "hemisphere_ssao"});
    EXPECT_EQ(m_result.done.gbuffers_loaded > 0, true);
    EXPECT_GT(m_result.done.references_made, 0);
    const std::vector<std::string> numbers = list_numbers();
    const std::map<std::string, std::string> pictures = read_pictures();
    const std::size_t samples = m_result.samples.size();
    fs::remove_all(m_folder.path() / "images");
    run({"none", "hemisphere_ssao"});
    EXPECT_EQ(m_result.done.gbuffers_drawn, 0);
    EXPECT_EQ(m_result.done.references_made, 0);
    for (const auto& [what, outcome] : list_outcomes()) {
        EXPECT_EQ(outcome, "reused") << what;
    }
    EXPECT_EQ(list_outcomes().size(), 3u);
    EXPECT_EQ(list_numbers(), numbers);
    EXPECT_EQ(read_pictures(), pictures);
    // Input costs come from the cache and say so; passes are new.
    EXPECT_EQ(m_result.samples.size(), samples);
    for (const SampleRow& row : m_result.samples) {
        EXPECT_EQ(row.cached, row.pass.starts_with("input/")) << row.pass;
    }
}

TEST_F(Reuse, ACaptureWithoutTheFilmDoesNotStandForOneWithIt) {
    run({"none"});
    m_films_burst = true;
    run({"none"});
    EXPECT_EQ(list_outcomes().at(cell(0).id), "made");
    const std::map<std::string, std::string> pictures = read_pictures();
    EXPECT_TRUE(std::any_of(pictures.begin(), pictures.end(), [](const auto& picture) {
        return picture.first.find("film") != std::string::npos;
    }));
}

TEST_F(Reuse, OnlyTheCellThatIsNewIsCaptured) {
    run({"none", "hemisphere_ssao"});
    run({"none", "hemisphere_ssao:samples=8", "hemisphere_ssao"});
    EXPECT_EQ(list_outcomes().at(cell(0).id), "reused");
    EXPECT_EQ(list_outcomes().at(cell(1).id), "made");
    EXPECT_EQ(list_outcomes().at(cell(2).id), "reused");
    EXPECT_NE(find_reason(cell(1).id).find("never captured"), std::string::npos);
    EXPECT_EQ(m_result.done.references_made, 0);
    // Cells that were captured together and apart have the same numbers.
    const std::vector<std::string> numbers = list_numbers();
    fs::remove_all(m_folder.path() / "cache");
    run({"none", "hemisphere_ssao:samples=8", "hemisphere_ssao"});
    EXPECT_EQ(list_numbers(), numbers);
}

TEST_F(Reuse, AnIngredientThatChangedIsNamed) {
    run({"hemisphere_ssao"});
    // The same names in another state, as after an edit of the method's shader.
    CaptureIngredients ingredients;
    for (const ReuseRecord& item : m_result.done.reuse) {
        if (item.what == cell(0).id) {
            ingredients.names = item.names;
            ingredients.contents = item.contents;
        }
    }
    ASSERT_FALSE(ingredients.contents.empty());
    const CaptureStore store(m_folder.path() / "cache");
    ASSERT_TRUE(store.has(ingredients.make_key()));
    fs::remove_all(
        make_cache_path(m_folder.path() / "cache", "captures", ingredients.make_key(), ""));
    ASSERT_EQ(ingredients.contents.back().name, "sources of the method");
    ingredients.contents.back().value = "before the edit";
    store.store(ingredients, {}, cell(0).id, m_folder.path() / "missing");
    run({"hemisphere_ssao"});
    EXPECT_EQ(list_outcomes().at(cell(0).id), "made");
    EXPECT_EQ(list_outcomes().at("reference"), "reused");
    EXPECT_EQ(find_reason(cell(0).id), "changed since it was captured last: sources of the method");
    run({"hemisphere_ssao"});
    EXPECT_EQ(list_outcomes().at(cell(0).id), "reused");
}

TEST_F(Reuse, DamagedEntriesAreMadeAnew) {
    run({"hemisphere_ssao"});
    const std::vector<std::string> numbers = list_numbers();
    for (const auto& file : fs::recursive_directory_iterator(m_folder.path() / "cache")) {
        if (file.is_regular_file() && file.path().extension() != ".csv") {
            std::ofstream(file.path(), std::ios::binary | std::ios::app) << "x";
        }
    }
    run({"hemisphere_ssao"});
    EXPECT_EQ(list_outcomes().at(cell(0).id), "made");
    EXPECT_NE(find_reason(cell(0).id).find("damaged"), std::string::npos);
    EXPECT_GT(m_result.done.gbuffers_drawn, 0);
    EXPECT_EQ(list_numbers(), numbers);
    run({"hemisphere_ssao"});
    EXPECT_EQ(list_outcomes().at(cell(0).id), "reused");
}

TEST_F(Reuse, AFullAuditMakesEverythingAgainAndAgrees) {
    run({"hemisphere_ssao"});
    m_audit_share = 1.0;
    run({"hemisphere_ssao"});
    EXPECT_EQ(list_outcomes().at(cell(0).id), "audited");
    EXPECT_EQ(list_outcomes().at("reference"), "audited");
    // Two captures, every frame's truth, and every channel of every G-buffer.
    EXPECT_GE(m_result.done.audited, 2 + kRoundFrames + kRoundFrames * 4);
}

TEST_F(Reuse, AnAuditFailsOnANumberThatWasForged) {
    run({"hemisphere_ssao"});
    CaptureIngredients ingredients;
    for (const ReuseRecord& item : m_result.done.reuse) {
        if (item.what == cell(0).id) {
            ingredients = {item.names, item.contents};
        }
    }
    std::vector<MetricRow> rows = m_result.metrics;
    rows.front().value = 0.125;
    const CaptureStore store(m_folder.path() / "cache");
    store.store(ingredients, rows, cell(0).id,
                m_folder.path() / "images" / round().id / cell(0).id);
    m_audit_share = 1.0;
    expect_error([&] { run({"hemisphere_ssao"}); }, 1, {"audit", "metrics.csv", "hemisphere_ssao"});
}

TEST_F(Reuse, AnAuditFailsOnAGBufferThatWasForged) {
    run({"hemisphere_ssao"});
    const GBufferStore store(m_folder.path() / "cache", "");
    for (const auto& file :
         fs::recursive_directory_iterator(m_folder.path() / "cache" / "gbuffers")) {
        if (file.path().extension() == ".texels") {
            const std::string key = file.path().stem().string();
            // Of the round's size in RGBA16F: normals, albedo or direct light.
            if (const auto texels = store.read(key, std::size_t{96} * 72 * 8)) {
                store.write(key, std::vector<std::byte>(texels->size()));
            }
        }
    }
    m_audit_share = 1.0;
    expect_error([&] { run({"hemisphere_ssao"}); }, 1, {"audit", "G-buffer"});
}

} // namespace
} // namespace alcove
