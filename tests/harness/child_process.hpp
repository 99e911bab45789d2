#pragma once
// The built program as a child process: its exit code, what it printed, and how it was stopped.

#include "tests/harness/temporary_folder.hpp"

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace alcove {

struct ChildOptions {
    std::map<std::string, std::string> environment; ///< over the parent's
    std::filesystem::path folder;                   ///< working directory; empty: the parent's
};

struct ChildResult {
    int exit_code = -1; ///< -1 if a signal ended it
    int signal = 0;
    std::string out;
    std::string err;
};

class ChildProcess {
  public:
    ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                 const ChildOptions& options = {});
    /// Kills a child that was not waited for.
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// True if it ended by itself within that time.
    [[nodiscard]] bool wait_for(std::chrono::milliseconds time);
    /// What it printed on standard error so far.
    [[nodiscard]] std::string read_errors() const;
    /// From now on writes beyond this size fail with EFBIG: a full disk where no disk can be
    /// mounted.
    void limit_file_size(std::uintmax_t bytes) const;
    /// SIGKILL: nothing of the child's runs any more.
    void kill();
    /// Waits for the end and returns all that was printed.
    [[nodiscard]] ChildResult finish();

  private:
    TemporaryFolder m_output; ///< of the captured streams
    ::pid_t m_process = -1;
    std::optional<int> m_status;
};

/// Runs the program to its end.
[[nodiscard]] ChildResult run_child(const std::filesystem::path& program,
                                    const std::vector<std::string>& arguments,
                                    const ChildOptions& options = {});

} // namespace alcove
