#include "tests/harness/child_process.hpp"

#include "core/base/file.hpp"

#include <csignal>
#include <fcntl.h>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace alcove {
namespace {

namespace fs = std::filesystem;

/// Only calls that are safe between fork and exec.
void redirect(const char* path, int descriptor) {
    const int file = ::open(path, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::dup2(file, descriptor);
}

} // namespace

ChildProcess::ChildProcess(const fs::path& program, const std::vector<std::string>& arguments,
                           const ChildOptions& options) {
    std::vector<std::string> words{program.string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) {
        argv.push_back(word.data());
    }
    argv.push_back(nullptr);
    const std::string out = (m_output.path() / "out").string();
    const std::string err = (m_output.path() / "err").string();
    m_process = ::fork();
    if (m_process < 0) {
        throw std::runtime_error("cannot fork");
    }
    if (m_process == 0) {
        redirect(out.c_str(), STDOUT_FILENO);
        redirect(err.c_str(), STDERR_FILENO);
        for (const auto& [name, value] : options.environment) {
            ::setenv(name.c_str(), value.c_str(), 1);
        }
        if (!options.folder.empty() && ::chdir(options.folder.c_str()) != 0) {
            ::_exit(126);
        }
        std::signal(SIGXFSZ, SIG_IGN); // under limit_file_size the write itself fails
        ::execv(argv[0], argv.data());
        ::_exit(127);
    }
}

ChildProcess::~ChildProcess() {
    if (!m_status) {
        ::kill(m_process, SIGKILL);
        ::waitpid(m_process, nullptr, 0);
    }
}

bool ChildProcess::wait_for(std::chrono::milliseconds time) {
    const auto end = std::chrono::steady_clock::now() + time;
    while (!m_status) {
        int status = 0;
        if (::waitpid(m_process, &status, WNOHANG) == m_process) {
            m_status = status;
        } else if (std::chrono::steady_clock::now() >= end) {
            return false;
        } else {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }
    return true;
}

std::string ChildProcess::read_errors() const {
    return fs::exists(m_output.path() / "err") ? read_file(m_output.path() / "err") : std::string();
}

void ChildProcess::limit_file_size(std::uintmax_t bytes) const {
    const ::rlimit limit{bytes, bytes};
    if (::prlimit(m_process, RLIMIT_FSIZE, &limit, nullptr) != 0) {
        throw std::runtime_error("cannot limit the child's files");
    }
}

void ChildProcess::kill() {
    if (!m_status) {
        ::kill(m_process, SIGKILL);
        int status = 0;
        ::waitpid(m_process, &status, 0);
        m_status = status;
    }
}

ChildResult ChildProcess::finish() {
    if (!m_status) {
        int status = 0;
        ::waitpid(m_process, &status, 0);
        m_status = status;
    }
    ChildResult result;
    if (WIFEXITED(*m_status)) {
        result.exit_code = WEXITSTATUS(*m_status);
    } else {
        result.signal = WTERMSIG(*m_status);
    }
    result.out = read_file(m_output.path() / "out");
    result.err = read_file(m_output.path() / "err");
    return result;
}

ChildResult run_child(const fs::path& program, const std::vector<std::string>& arguments,
                      const ChildOptions& options) {
    return ChildProcess(program, arguments, options).finish();
}

} // namespace alcove
