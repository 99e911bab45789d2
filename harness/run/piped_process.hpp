#pragma once
// A program that is started, talked to line by line, and never outlives the object that started it.

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace alcove {

/// How a process ended: by itself with an exit code, or by a signal.
struct ProcessEnd {
    int exit_code = -1; ///< -1 if a signal ended it
    int signal = 0;     ///< 0 if none did
};

/// shared: ours, so that Ctrl-C at a terminal reaches it too. own: it leads one, and all that it
/// started ends with it (SIGKILL); Ctrl-C at a terminal does not reach it.
enum class ProcessGroup { shared, own };

/// What a process may use until it has ended.
struct ProcessLimits {
    std::chrono::milliseconds time{0};
    std::size_t output_bytes = 0;
    std::size_t log_bytes = 0;
};

class PipedProcess {
  public:
    /// Starts `program` with `arguments` as they are: no shell reads them. Standard input and
    /// output are pipes, standard error goes to the file `log`, which is created anew. Throws
    /// FailureError naming the program if it cannot be started.
    PipedProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                 std::filesystem::path log, ProcessGroup group = ProcessGroup::shared);
    /// Ends it (SIGKILL) if it still runs.
    ~PipedProcess();
    PipedProcess(const PipedProcess&) = delete;
    PipedProcess& operator=(const PipedProcess&) = delete;

    /// Waits for the next line of its standard output, without the line end; nothing once it has
    /// closed that. Throws FailureError on a line of more than 64 KiB.
    [[nodiscard]] std::optional<std::string> read_line();
    /// Writes to its standard input; false if it no longer reads.
    [[nodiscard]] bool write(std::string_view text);
    /// Closes its standard input, reads all of its standard output and waits until it has ended.
    /// Throws FailureError naming the program if it takes longer or writes more than it may.
    [[nodiscard]] std::string run_to_end(const ProcessLimits& limits);
    /// Waits until it has ended.
    [[nodiscard]] ProcessEnd finish();
    /// The last 16 KiB of its standard error so far.
    [[nodiscard]] std::string read_log() const;

  private:
    /// Appends what can be read within that time; false once there will be no more.
    bool take_output(std::string& output, std::chrono::milliseconds patience);
    [[nodiscard]] bool has_ended() const;
    void reap();

    std::string m_program;
    std::filesystem::path m_log;
    ProcessGroup m_group;
    ::pid_t m_process = -1;
    int m_input = -1;  ///< our end of its standard input
    int m_output = -1; ///< our end of its standard output
    std::string m_buffer;
    std::optional<ProcessEnd> m_end;
};

} // namespace alcove
