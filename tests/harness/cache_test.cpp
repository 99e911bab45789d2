#include "harness/run/cache.hpp"

#include "harness/run/cache_check.hpp"
#include "tests/harness/temporary_folder.hpp"

#include <chrono>
#include <fstream>

#include <gtest/gtest.h>

namespace alcove {
namespace {

namespace fs = std::filesystem;

void age(const fs::path& path, int hours) {
    fs::last_write_time(path, fs::file_time_type::clock::now() - std::chrono::hours(hours));
}

TEST(CacheFolder, TheEnvironmentNamesIt) {
    const ScopedVariable cache("ALCOVE_CACHE", "/somewhere/else");
    EXPECT_EQ(get_cache_folder(), fs::path("/somewhere/else"));
}

TEST(CacheFolder, HomeHoldsItOtherwise) {
    const ScopedVariable cache("ALCOVE_CACHE", "");
    const ScopedVariable home("HOME", "/home/someone");
    EXPECT_EQ(get_cache_folder(), fs::path("/home/someone/.cache/alcove"));
}

TEST(Cache, FilesAndFoldersAreEntriesOldestFirst) {
    const TemporaryFolder folder;
    write_cache_file(folder.path() / "references" / "ab" / "ab1.exr", std::string(10, 'x'));
    write_cache_file(folder.path() / "captures" / "cd" / "cd1" / "metrics.csv",
                     std::string(20, 'x'));
    write_cache_file(folder.path() / "captures" / "cd" / "cd1" / "pictures" / "0.png",
                     std::string(30, 'x'));
    write_cache_file(folder.path() / "builds" / "sha" / "program", std::string(40, 'x'));
    write_cache_file(folder.path() / "something" / "else", "not ours");
    age(folder.path() / "captures" / "cd" / "cd1", 3);
    age(folder.path() / "builds" / "sha", 2);
    age(folder.path() / "references" / "ab" / "ab1.exr", 1);
    const std::vector<CacheEntry> entries = list_cache(folder.path());
    ASSERT_EQ(entries.size(), 3u);
    EXPECT_EQ(entries[0].kind, "captures");
    EXPECT_EQ(entries[0].bytes, 50u);
    EXPECT_EQ(entries[1].kind, "builds");
    EXPECT_EQ(entries[2].kind, "references");
    EXPECT_EQ(prune_cache(folder.path(), 60), 50u);
    EXPECT_EQ(list_cache(folder.path()).size(), 2u);
    mark_used(folder.path() / "builds" / "sha");
    EXPECT_EQ(prune_cache(folder.path(), 40), 10u);
    EXPECT_EQ(list_cache(folder.path()).at(0).kind, "builds");
    EXPECT_EQ(prune_cache(folder.path(), 0), 40u);
    EXPECT_TRUE(fs::exists(folder.path() / "something" / "else"));
}

TEST(Cache, AnEmptyOneIsPrunedAndCheckedWithoutAnError) {
    const TemporaryFolder folder;
    EXPECT_EQ(prune_cache(folder.path() / "missing", 0), 0u);
    EXPECT_EQ(check_cache(folder.path() / "missing").intact, 0u);
}

TEST(Cache, CheckingRemovesWhatIsDamagedAndKeepsTheRest) {
    const TemporaryFolder folder;
    const fs::path damaged = folder.path() / "gbuffers" / "ab" / "ab1.texels";
    const fs::path build = folder.path() / "builds" / "sha" / "program";
    write_cache_file(damaged, "not a G-buffer");
    write_cache_file(build, "whatever");
    const CacheCheck check = check_cache(folder.path());
    EXPECT_EQ(check.intact, 1u);
    EXPECT_EQ(check.damaged, std::vector<fs::path>{damaged});
    EXPECT_FALSE(fs::exists(damaged));
    EXPECT_TRUE(fs::exists(build));
}

TEST(Audit, DrawsItsShareAndTheSameForTheSameSeed) {
    const Audit audit{0.1, 3};
    int drawn = 0;
    int drawn_by_both = 0;
    for (int i = 0; i < 10000; ++i) {
        const std::string key = "key" + std::to_string(i);
        EXPECT_EQ(audit.draws(key), (Audit{0.1, 3}).draws(key));
        drawn += audit.draws(key) ? 1 : 0;
        drawn_by_both += audit.draws(key) && Audit{0.1, 4}.draws(key) ? 1 : 0;
        EXPECT_FALSE((Audit{0.0, 3}).draws(key));
        EXPECT_TRUE((Audit{1.0, 3}).draws(key));
    }
    // Binomial: 1000 with a standard deviation of 30, and 100 with one of 10; five of them.
    EXPECT_NEAR(drawn, 1000, 150);
    EXPECT_NEAR(drawn_by_both, 100, 50);
}

} // namespace
} // namespace alcove
