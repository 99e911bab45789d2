#include "harness/run/machine_watch.hpp"

#include "core/base/file.hpp"
#include "tests/harness/temporary_folder.hpp"

#include <ctime>
#include <unistd.h>

#include <gtest/gtest.h>

namespace alcove {
namespace {

class MachineWatchTest : public ::testing::Test {
  protected:
    void write(const char* path, const std::string& text) {
        std::filesystem::create_directories((m_folder.path() / path).parent_path());
        write_file_atomically(m_folder.path() / path, text);
    }

    TemporaryFolder m_folder;
};

TEST_F(MachineWatchTest, SharesAreThoseOfAllProcessors) {
    write("proc/stat", "cpu  100000 0 0 500000 0 0 0 1000 77 0\ncpu0 1 2 3\n");
    write("proc/loadavg", "2.50 1.00 0.50 3/200 4711\n");
    write("proc/cpuinfo", "processor\t: 0\ncpu MHz\t\t: 2000.0\n\ncpu MHz\t\t: 3000.0\n");
    const MachineWatch watch(m_folder.path());
    // 100000 ticks: 40000 busy, 10000 stolen, the rest idle or waiting; guests' 500 are in user
    write("proc/stat", "cpu  120000 10000 5000 540000 10000 2000 3000 11000 577 0\n");
    const MachineRecord record = watch.read();
    ASSERT_TRUE(record.others_share && record.steal_share && record.load && record.clock_mhz);
    EXPECT_NEAR(*record.others_share, 0.4, 0.005) << "but for what this test itself took";
    EXPECT_NEAR(*record.steal_share, 0.1, 1e-12);
    EXPECT_EQ(*record.load, 2.5);
    EXPECT_EQ(*record.clock_mhz, 2500.0);
}

TEST_F(MachineWatchTest, TheClockOfTheGovernorComesFirst) {
    write("proc/cpuinfo", "cpu MHz\t\t: 2000.0\n");
    write("sys/devices/system/cpu/cpu0/cpufreq/scaling_cur_freq", "1800000\n");
    write("sys/devices/system/cpu/cpu1/cpufreq/scaling_cur_freq", "2200000\n");
    EXPECT_EQ(MachineWatch(m_folder.path()).read().clock_mhz, 2000.0);
}

TEST_F(MachineWatchTest, WhatTheSystemDoesNotHaveStaysEmpty) {
    const MachineRecord bare = MachineWatch(m_folder.path()).read();
    EXPECT_FALSE(bare.others_share || bare.steal_share || bare.load || bare.clock_mhz);
    write("proc/stat", "cpu  100 0 0 500\n"); // no steal column, and nothing moves
    const MachineWatch watch(m_folder.path());
    EXPECT_FALSE(watch.read().others_share);
    write("proc/stat", "cpu  100 0 0 900000\n");
    EXPECT_EQ(watch.read().others_share, 0.0);
    EXPECT_FALSE(watch.read().steal_share);
    write("proc/stat", "nonsense\n");
    EXPECT_FALSE(watch.read().others_share);
}

TEST_F(MachineWatchTest, OurOwnWorkIsNotThatOfOthers) {
    write("proc/stat", "cpu  0 0 0 0 0 0 0 0\n");
    const MachineWatch watch(m_folder.path());
    const std::clock_t begin = std::clock();
    while (std::clock() - begin < CLOCKS_PER_SEC * 3 / 10) {
    }
    // Of 100 ticks 50 were busy: some 30 of them with the loop above.
    const long tick = ::sysconf(_SC_CLK_TCK);
    write("proc/stat",
          "cpu  " + std::to_string(tick / 2) + " 0 0 " + std::to_string(tick / 2) + " 0 0 0 0\n");
    const MachineRecord record = watch.read();
    ASSERT_TRUE(record.others_share);
    EXPECT_GT(*record.others_share, 0.1);
    EXPECT_LE(*record.others_share, 0.21);
}

} // namespace
} // namespace alcove
