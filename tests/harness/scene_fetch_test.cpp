#include "harness/run/scene_fetch.hpp"

#include "core/base/error.hpp"
#include "core/base/file.hpp"
#include "harness/run/scene_file.hpp"
#include "tests/harness/temporary_folder.hpp"

#include <algorithm>
#include <cctype>
#include <set>

#include <gtest/gtest.h>

namespace alcove {
namespace {

TEST(SceneFetchTest, TheCatalogueNamesASourceALicenceAndSafeFilesForEveryScene) {
    std::set<std::string> names;
    for (const FetchableScene& scene : list_fetchable_scenes()) {
        EXPECT_TRUE(names.insert(scene.name).second) << scene.name;
        EXPECT_NE(scene.debian.empty(), scene.npm.empty()) << scene.name;
        EXPECT_FALSE(scene.licence.spdx.empty());
        EXPECT_FALSE(scene.licence.attribution.empty());
        // What nobody has licensed is neither shipped nor shown.
        if (scene.licence.spdx == "unstated") {
            EXPECT_FALSE(scene.licence.redistribute) << scene.name;
            EXPECT_FALSE(scene.licence.figures) << scene.name;
        }
        ASSERT_FALSE(scene.files.empty());
        EXPECT_TRUE(is_scene_file(scene.files.front().as)) << scene.files.front().as;
        for (const FetchableFile& file : scene.files) {
            EXPECT_TRUE(std::all_of(file.as.begin(), file.as.end(), [](unsigned char c) {
                return std::isalnum(c) != 0 || c == '.' || c == '_';
            })) << file.as;
        }
    }
    EXPECT_GE(names.size(), 17u);
}

TEST(SceneFetchTest, WhatIsThereIsNotFetchedAgainAndNothingIsFetchedAgainstTheUsersWill) {
    const TemporaryFolder folder;
    const ScopedVariable cache("ALCOVE_CACHE", folder.path().string());
    const ScopedVariable forbidden("ALCOVE_NO_INSTALL", "1");
    const std::vector<FetchableScene> chosen{find_fetchable_scene("dragon")};
    const auto silent = [](const std::string&) {};
    EXPECT_THROW(fetch_scenes(chosen, silent), InputError);
    write_file_atomically(get_fetched_file(chosen.front()), "OFF\n");
    EXPECT_TRUE(is_fetched(chosen.front()));
    EXPECT_NO_THROW(fetch_scenes(chosen, silent));
    EXPECT_THROW(static_cast<void>(find_fetchable_scene("dragoon")), InputError);
}

TEST(SceneFetchTest, ALicenceThatForbidsPicturesIsAWarning) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "model.off";
    write_file_atomically(file, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    std::vector<std::string> warnings;
    static_cast<void>(open_scene_file(file.string(), warnings));
    EXPECT_TRUE(warnings.empty());
    Licence licence{"unstated", "nobody knows", false, false};
    write_file_atomically(folder.path() / kLicenceFile, write_licence(licence));
    static_cast<void>(open_scene_file(file.string(), warnings));
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("may not be published"), std::string::npos);
    licence.figures = true;
    warnings.clear();
    write_file_atomically(folder.path() / kLicenceFile, write_licence(licence));
    static_cast<void>(open_scene_file(file.string(), warnings));
    EXPECT_TRUE(warnings.empty());
    write_file_atomically(folder.path() / kLicenceFile, "{\"spdx\": 3}");
    EXPECT_THROW(static_cast<void>(open_scene_file(file.string(), warnings)), InputError);
}

} // namespace
} // namespace alcove
