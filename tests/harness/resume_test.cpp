// SIGKILL at any moment, then --resume: the same images and complete tables.

#include "core/base/file.hpp"
#include "reports/record/record.hpp"
#include "tests/harness/program.hpp"

#include <chrono>
#include <random>
#include <set>

namespace alcove {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

constexpr int kRounds = 6;
constexpr int kKills = 5;

class Resume : public ProgramTest {
  protected:
    static void SetUpTestSuite() {
        ProgramTest::SetUpTestSuite();
        for (int i = 0; i < kRounds; ++i) {
            write("scene" + std::to_string(i) + ".gltf", make_box_gltf(0.2 * i));
        }
        ChildProcess child(program(), make_arguments("whole"), with_cache({}));
        static_cast<void>(wait_for_rounds(child));
        const auto begin = std::chrono::steady_clock::now();
        s_whole = child.finish();
        s_rounds_time =
            std::chrono::duration_cast<milliseconds>(std::chrono::steady_clock::now() - begin);
    }
    /// Until the timers are validated and the rounds begin. False if it ended before.
    static bool wait_for_rounds(ChildProcess& child) {
        while (child.read_errors().find("writing to") == std::string::npos) {
            if (child.wait_for(milliseconds(5))) {
                return false;
            }
        }
        return true;
    }
    static std::vector<std::string> make_arguments(const std::string& out) {
        std::vector<std::string> arguments{
            "run",      "--method", "hemisphere_ssao", "--method", "none",  "--size", "160x120",
            "--frames", "0:16",     "--repeat",        "4",        "--out", out};
        for (int i = 0; i < kRounds; ++i) {
            arguments.emplace_back("--scene");
            arguments.push_back("scene" + std::to_string(i) + ".gltf");
        }
        return arguments;
    }
    static std::set<std::string> list_finished(const fs::path& run) {
        std::set<std::string> rounds;
        if (fs::exists(run / "rounds")) {
            for (const fs::directory_entry& entry : fs::directory_iterator(run / "rounds")) {
                const std::string name = entry.path().filename().string();
                if (name.find(".tmp") == std::string::npos) {
                    rounds.insert(name);
                }
            }
        }
        return rounds;
    }
    static ChildResult s_whole;
    static milliseconds s_rounds_time;
};

ChildResult Resume::s_whole;
milliseconds Resume::s_rounds_time{};

TEST_F(Resume, KilledAtFiveMomentsEndsLikeAnUninterruptedRun) {
    ASSERT_EQ(s_whole.exit_code, 0) << s_whole.err;
    // What is killed has a cache of its own: the references must come out equal as well.
    ChildOptions own_cache;
    own_cache.environment["ALCOVE_CACHE"] = (folder() / "cold-cache").string();
    const fs::path run_folder = folder() / "killed";
    std::mt19937 random(20261122);
    std::set<std::string> finished;
    std::map<std::string, std::string> bytes;
    for (int kill = 0; kill < kKills; ++kill) {
        const bool exists = fs::exists(run_folder / "context.json");
        ChildProcess child(program(),
                           exists ? std::vector<std::string>{"run", "--resume", "killed"}
                                  : make_arguments("killed"),
                           with_cache(own_cache));
        ASSERT_TRUE(wait_for_rounds(child)) << child.finish().err;
        // Up to two fifths of the rounds at a time: five kills fall all over the run.
        std::uniform_int_distribution<long> moment(0, 2 * s_rounds_time.count() / 5);
        const milliseconds wait(moment(random));
        const bool ended = child.wait_for(wait);
        child.kill();
        const ChildResult result = child.finish();
        std::printf("kill %d after %ld ms%s, %zu of %d rounds finished\n", kill + 1,
                    static_cast<long>(wait.count()), ended ? " (had ended)" : "",
                    list_finished(run_folder).size(), kRounds);
        if (ended) {
            EXPECT_EQ(result.exit_code, 0) << result.err;
        }
        const std::set<std::string> now = list_finished(run_folder);
        for (const std::string& round : finished) {
            EXPECT_TRUE(now.contains(round)) << round << " was lost";
            EXPECT_EQ(read_file(run_folder / "rounds" / round / "samples.csv"), bytes[round])
                << round << " was measured again";
        }
        for (const std::string& round : now) {
            bytes[round] = read_file(run_folder / "rounds" / round / "samples.csv");
        }
        finished = now;
    }
    const ChildResult last = run({"run", "--resume", "killed"}, own_cache);
    ASSERT_EQ(last.exit_code, 0) << last.err;
    EXPECT_TRUE(RunFolder::open(run_folder).is_complete());
    EXPECT_EQ(read_image_hashes(run_folder), read_image_hashes(folder() / "whole"));
    for (const char* table : {"samples.csv", "metrics.csv", "summary.csv"}) {
        EXPECT_EQ(count_lines(run_folder / table), count_lines(folder() / "whole" / table))
            << table;
    }
    for (const auto& [round, text] : bytes) {
        EXPECT_EQ(read_file(run_folder / "rounds" / round / "samples.csv"), text) << round;
    }
    EXPECT_TRUE(fs::is_regular_file(run_folder / "report" / "index.html"));
    EXPECT_EQ(list_finished(run_folder).size(), static_cast<std::size_t>(kRounds));
}

TEST_F(Resume, ACompleteRunStaysAsItIs) {
    const std::string before = read_file(folder() / "whole" / "samples.csv");
    const ChildResult result = run({"run", "--resume", "whole"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(read_file(folder() / "whole" / "samples.csv"), before);
}

TEST_F(Resume, ARunOfAnotherBuildIsRefusedNamingBoth) {
    const std::string build = RunFolder::open(folder() / "whole").context().build_id;
    const fs::path file = folder() / "whole" / "context.json";
    const std::string before = read_file(file);
    std::string text = before;
    ASSERT_NE(text.find(build), std::string::npos);
    text.replace(text.find(build), build.size(), "00000000deadbeef");
    write_file_atomically(file, text);
    expect_refused({"run", "--resume", "whole"}, 2, {"build", "00000000deadbeef", build.c_str()});
    write_file_atomically(file, before);
}

} // namespace
} // namespace alcove
