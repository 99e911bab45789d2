// READMEs hold the tables that the code declares, word for word.
#include "core/base/file.hpp"
#include "core/base/parameters_markdown.hpp"
#include "methods/registry.hpp"
#include "metrics/registry.hpp"
#include "scenes/common/lighting.hpp"
#include "scenes/registry.hpp"

#include <filesystem>

#include <gtest/gtest.h>

namespace alcove {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = ALCOVE_SOURCE_DIR;

/// The text between `<!-- parameters -->` and `<!-- /parameters -->`, without the line breaks
/// around it.
std::string read_table(const fs::path& readme) {
    const std::string text = read_file(readme);
    const std::string begin = "<!-- parameters -->\n";
    const std::size_t first = text.find(begin);
    const std::size_t last = text.find("<!-- /parameters -->");
    if (first == std::string::npos || last == std::string::npos) {
        return "no table between <!-- parameters --> marks";
    }
    return text.substr(first + begin.size(), last - first - begin.size());
}

template <class Unit>
void check_room(const Registry<Unit>& registry, const std::string& room) {
    for (const Unit& unit : registry.units()) {
        const fs::path readme = kRoot / room / unit.name / "README.md";
        ASSERT_TRUE(fs::exists(readme)) << readme;
        if (!unit.parameters.entries().empty()) {
            EXPECT_EQ(read_table(readme), make_markdown_table(unit.parameters)) << readme;
        }
    }
}

TEST(Readme, MethodsShowTheirParameters) {
    check_room(methods_registry(), "methods");
}
TEST(Readme, MetricsShowTheirParameters) {
    check_room(metrics_registry(), "metrics");
}
TEST(Readme, ScenesShowTheirParameters) {
    check_room(scenes_registry(), "scenes");
}

TEST(Readme, ScenesShowTheLightThatTheyAllTake) {
    EXPECT_EQ(read_table(kRoot / "scenes/README.md"), make_markdown_table(lighting_table()));
}

TEST(Readme, MethodsListTheirPresets) {
    const Registry<MethodUnit> registry = methods_registry();
    for (const MethodUnit& unit : registry.units()) {
        const std::string text = read_file(kRoot / "methods" / unit.name / "README.md");
        for (const Preset& preset : unit.presets) {
            if (preset.name != "default") {
                EXPECT_NE(text.find("`" + preset.name + "`"), std::string::npos)
                    << unit.name << " " << preset.name;
            }
        }
    }
}

TEST(Readme, EveryTopLevelFolderHasOne) {
    for (const char* folder :
         {"core", "methods", "scenes", "metrics", "reports", "harness", "tests"}) {
        EXPECT_TRUE(fs::exists(kRoot / folder / "README.md")) << folder;
    }
}

} // namespace
} // namespace alcove
