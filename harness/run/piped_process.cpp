#include "harness/run/piped_process.hpp"

#include "core/base/error.hpp"
#include "core/base/text.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <utility>

extern char** environ;

namespace alcove {
namespace {

constexpr std::size_t kLongestLine = std::size_t{64} << 10;
constexpr std::streamoff kLogTail = 16 << 10;

/// A descriptor that is closed at the end of the scope.
class Descriptor {
  public:
    explicit Descriptor(int descriptor = -1) : m_descriptor(descriptor) {}
    ~Descriptor() {
        if (m_descriptor >= 0) {
            ::close(m_descriptor);
        }
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    [[nodiscard]] int get() const { return m_descriptor; }
    [[nodiscard]] int release() { return std::exchange(m_descriptor, -1); }

  private:
    int m_descriptor;
};

class SpawnActions {
  public:
    SpawnActions() { ::posix_spawn_file_actions_init(&m_actions); }
    ~SpawnActions() { ::posix_spawn_file_actions_destroy(&m_actions); }
    SpawnActions(const SpawnActions&) = delete;
    SpawnActions& operator=(const SpawnActions&) = delete;
    [[nodiscard]] ::posix_spawn_file_actions_t* get() { return &m_actions; }

  private:
    ::posix_spawn_file_actions_t m_actions{};
};

class SpawnAttributes {
  public:
    explicit SpawnAttributes(ProcessGroup group) {
        ::posix_spawnattr_init(&m_attributes);
        if (group == ProcessGroup::own) {
            ::posix_spawnattr_setflags(&m_attributes, POSIX_SPAWN_SETPGROUP);
            ::posix_spawnattr_setpgroup(&m_attributes, 0);
        }
    }
    ~SpawnAttributes() { ::posix_spawnattr_destroy(&m_attributes); }
    SpawnAttributes(const SpawnAttributes&) = delete;
    SpawnAttributes& operator=(const SpawnAttributes&) = delete;
    [[nodiscard]] const ::posix_spawnattr_t* get() const { return &m_attributes; }

  private:
    ::posix_spawnattr_t m_attributes{};
};

[[noreturn]] void fail(const std::filesystem::path& program, int error) {
    throw FailureError(program.string(), "cannot be started", std::strerror(error));
}

ProcessEnd wait_for(::pid_t process) {
    int status = 0;
    while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFEXITED(status) ? ProcessEnd{WEXITSTATUS(status), 0}
                             : ProcessEnd{-1, WTERMSIG(status)};
}

} // namespace

PipedProcess::PipedProcess(const std::filesystem::path& program,
                           const std::vector<std::string>& arguments, std::filesystem::path log,
                           ProcessGroup group)
    : m_program(program.string()), m_log(std::move(log)), m_group(group) {
    // A socket for its input: writing to one that nobody reads can be told not to raise SIGPIPE.
    std::array<int, 2> input{};
    std::array<int, 2> output{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, input.data()) != 0) {
        fail(program, errno);
    }
    Descriptor our_input(input[0]);
    const Descriptor its_input(input[1]);
    if (::pipe2(output.data(), O_CLOEXEC) != 0) {
        fail(program, errno);
    }
    Descriptor our_output(output[0]);
    const Descriptor its_output(output[1]);

    std::vector<std::string> words{program.string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) {
        argv.push_back(word.data());
    }
    argv.push_back(nullptr);
    SpawnActions actions;
    ::posix_spawn_file_actions_adddup2(actions.get(), its_input.get(), STDIN_FILENO);
    ::posix_spawn_file_actions_adddup2(actions.get(), its_output.get(), STDOUT_FILENO);
    ::posix_spawn_file_actions_addopen(actions.get(), STDERR_FILENO, m_log.c_str(),
                                       O_WRONLY | O_CREAT | O_TRUNC, 0666);
    const SpawnAttributes attributes(group);
    const int error =
        ::posix_spawn(&m_process, argv[0], actions.get(), attributes.get(), argv.data(), environ);
    if (error != 0) {
        fail(program, error);
    }
    m_input = our_input.release();
    m_output = our_output.release();
}

PipedProcess::~PipedProcess() {
    ::close(m_input);
    ::close(m_output);
    if (!m_end) {
        ::kill(m_group == ProcessGroup::own ? -m_process : m_process, SIGKILL);
        reap();
    }
}

std::optional<std::string> PipedProcess::read_line() {
    for (;;) {
        if (const std::size_t end = m_buffer.find('\n'); end != std::string::npos) {
            std::string line = m_buffer.substr(0, end);
            m_buffer.erase(0, end + 1);
            return line;
        }
        if (m_buffer.size() > kLongestLine) {
            throw FailureError("a started program", "wrote a line of more than 64 KiB");
        }
        std::array<char, 4096> bytes{};
        const ::ssize_t count = ::read(m_output, bytes.data(), bytes.size());
        if (count > 0) {
            m_buffer.append(bytes.data(), static_cast<std::size_t>(count));
        } else if (count == 0 || errno != EINTR) {
            return std::nullopt;
        }
    }
}

bool PipedProcess::write(std::string_view text) {
    while (!text.empty()) {
        const ::ssize_t count = ::send(m_input, text.data(), text.size(), MSG_NOSIGNAL);
        if (count < 0 && errno != EINTR) {
            return false;
        }
        text.remove_prefix(count > 0 ? static_cast<std::size_t>(count) : 0);
    }
    return true;
}

ProcessEnd PipedProcess::finish() {
    if (!m_end) {
        reap();
    }
    return *m_end;
}

bool PipedProcess::has_ended() const {
    ::siginfo_t info{};
    return ::waitid(P_PID, static_cast<::id_t>(m_process), &info, WEXITED | WNOHANG | WNOWAIT) ==
               0 &&
           info.si_pid == m_process;
}

void PipedProcess::reap() {
    if (m_group == ProcessGroup::own) {
        // Until it is reaped nothing else can have its number.
        ::siginfo_t info{};
        while (::waitid(P_PID, static_cast<::id_t>(m_process), &info, WEXITED | WNOWAIT) != 0 &&
               errno == EINTR) {
        }
        ::kill(-m_process, SIGKILL);
    }
    m_end = wait_for(m_process);
}

bool PipedProcess::take_output(std::string& output, std::chrono::milliseconds patience) {
    ::pollfd waits{m_output, POLLIN, 0};
    if (::poll(&waits, 1, static_cast<int>(patience.count())) <= 0) {
        return true;
    }
    std::array<char, 65536> bytes{};
    const ::ssize_t count = ::read(m_output, bytes.data(), bytes.size());
    if (count > 0) {
        output.append(bytes.data(), static_cast<std::size_t>(count));
    }
    return count > 0 || (count < 0 && errno == EINTR);
}

std::string PipedProcess::run_to_end(const ProcessLimits& limits) {
    using namespace std::chrono_literals;
    const auto deadline = std::chrono::steady_clock::now() + limits.time;
    ::shutdown(m_input, SHUT_WR);
    std::string output = std::exchange(m_buffer, {});
    const auto check_output = [&] {
        if (output.size() > limits.output_bytes) {
            throw FailureError(m_program, "wrote too much on its standard output", "",
                               "at most " + std::to_string(limits.output_bytes) + " bytes");
        }
    };
    bool is_open = true;
    while (!has_ended()) {
        if (std::chrono::steady_clock::now() >= deadline) {
            throw FailureError(
                m_program, "has not ended in time", "",
                "at most " + format_number(static_cast<double>(limits.time.count()) * 1e-3) + " s");
        }
        std::error_code error;
        const std::uintmax_t log_bytes = std::filesystem::file_size(m_log, error);
        if (!error && log_bytes > limits.log_bytes) {
            throw FailureError(m_program, "wrote too much on its standard error", "",
                               "at most " + std::to_string(limits.log_bytes) + " bytes");
        }
        if (is_open) {
            is_open = take_output(output, 20ms);
            check_output();
        } else {
            std::this_thread::sleep_for(1ms);
        }
    }
    reap();
    // What is left in the pipe; another program may hold it open for ever.
    for (std::size_t before = output.size() + 1; is_open && before != output.size();) {
        before = output.size();
        is_open = take_output(output, 0ms);
        check_output();
    }
    return output;
}

std::string PipedProcess::read_log() const {
    std::ifstream file(m_log, std::ios::binary | std::ios::ate);
    if (!file) {
        return {};
    }
    const std::streamoff size = file.tellg();
    std::string text(static_cast<std::size_t>(std::min(size, kLogTail)), '\0');
    file.seekg(size - static_cast<std::streamoff>(text.size()));
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    return text;
}

} // namespace alcove
