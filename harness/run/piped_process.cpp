#include "harness/run/piped_process.hpp"

#include "core/base/error.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
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
                           const std::vector<std::string>& arguments, std::filesystem::path log)
    : m_log(std::move(log)) {
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
    const int error =
        ::posix_spawn(&m_process, argv[0], actions.get(), nullptr, argv.data(), environ);
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
        ::kill(m_process, SIGKILL);
        static_cast<void>(wait_for(m_process));
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
        m_end = wait_for(m_process);
    }
    return *m_end;
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
