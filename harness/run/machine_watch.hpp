#pragma once
// What else the machine does while something is timed: other processes, other guests, the clock.

#include "reports/record/record.hpp"

#include <chrono>
#include <filesystem>

namespace alcove {

/// Watches from its construction. Reads text files of Linux; what is missing there stays empty.
class MachineWatch {
  public:
    /// `root` is where proc/ and sys/ lie: "/", or a folder of a test.
    explicit MachineWatch(std::filesystem::path root = "/");

    /// Since construction. Shares of processor time are empty where the system's clock of 10 ms has
    /// not moved.
    [[nodiscard]] MachineRecord read() const;

  private:
    /// Processor time of the whole machine in ticks, since it was started.
    struct ProcessorTimes {
        double busy = 0.0; ///< neither idle nor stolen
        double all = 0.0;
        std::optional<double> stolen; ///< none before Linux 2.6.11
    };
    struct OwnTimes {
        double busy_s = 0.0; ///< of all our threads
        double switches = 0.0;
    };

    [[nodiscard]] std::optional<ProcessorTimes> read_processor_times() const;
    [[nodiscard]] std::optional<double> read_load() const;
    [[nodiscard]] std::optional<double> read_clock_mhz() const;
    [[nodiscard]] static OwnTimes read_own_times();

    std::filesystem::path m_root;
    std::chrono::steady_clock::time_point m_begin = std::chrono::steady_clock::now();
    std::optional<ProcessorTimes> m_processors = read_processor_times();
    OwnTimes m_own = read_own_times();
};

} // namespace alcove
