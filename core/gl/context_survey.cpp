#include "core/gl/context_survey.hpp"

#include "core/base/error.hpp"
#include "core/gl/egl_context.hpp"
#include "core/gl/glfw_context.hpp"
#include "core/gl/osmesa_context.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <exception>
#include <fcntl.h>
#include <memory>
#include <sys/wait.h>
#include <unistd.h>

namespace alcove::gl {
namespace {

constexpr unsigned kLimitSeconds = 20;

struct Way {
    const char* context;
    std::unique_ptr<Context> (*open)();
};

constexpr std::array kWays{
    Way{"osmesa", open_osmesa_context},
    Way{"egl-device", [] { return open_egl_context(EglPlatform::device, EglDevices::any); }},
    Way{"egl-surfaceless",
        [] { return open_egl_context(EglPlatform::surfaceless, EglDevices::any); }},
    Way{"glfw", open_glfw_context},
};

/// What a child says: '+' class newline renderer, or '-' reason.
std::string try_way(const Way& way) {
    try { // the child's own main: nothing may leave it but text
        const std::unique_ptr<Context> context = way.open();
        return "+" + context->device().device_class + "\n" + context->device().renderer;
    } catch (const std::exception& error) {
        return std::string("-") + error.what();
    }
}

[[noreturn]] void run_child(const Way& way, int descriptor) {
    // Drivers grumble on standard error about devices that are not there.
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    ::dup2(nowhere, STDERR_FILENO);
    std::signal(SIGALRM, SIG_DFL);
    ::alarm(kLimitSeconds);
    const std::string text = try_way(way);
    const char* rest = text.data();
    std::size_t left = text.size();
    while (left > 0) {
        const ::ssize_t written = ::write(descriptor, rest, left);
        if (written <= 0) {
            ::_exit(1);
        }
        rest += written;
        left -= static_cast<std::size_t>(written);
    }
    ::_exit(0);
}

std::string read_all(int descriptor) {
    std::string text;
    std::array<char, 1024> block{};
    while (true) {
        const ::ssize_t count = ::read(descriptor, block.data(), block.size());
        if (count > 0) {
            text.append(block.data(), static_cast<std::size_t>(count));
        } else if (count == 0 || errno != EINTR) {
            return text;
        }
    }
}

std::string describe_end(int status) {
    if (WIFSIGNALED(status)) {
        return WTERMSIG(status) == SIGALRM
                   ? "the driver did not answer within " + std::to_string(kLimitSeconds) + " s"
                   : "the driver crashed with signal " + std::to_string(WTERMSIG(status));
    }
    return "the driver ended the process with code " + std::to_string(WEXITSTATUS(status));
}

ContextFinding find(const Way& way) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
        throw FailureError("contexts", "no pipe to a child process");
    }
    const ::pid_t child = ::fork();
    if (child == 0) {
        run_child(way, ends[1]);
    }
    ::close(ends[1]);
    const std::string text = child < 0 ? std::string() : read_all(ends[0]);
    ::close(ends[0]);
    if (child < 0) {
        throw FailureError("contexts", "no child process");
    }
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    ContextFinding finding;
    finding.context = way.context;
    const std::size_t line_end = text.find('\n');
    if (text.starts_with('+') && line_end != std::string::npos) {
        finding.device_class = text.substr(1, line_end - 1);
        finding.renderer = text.substr(line_end + 1);
    } else {
        finding.failure = text.starts_with('-') ? text.substr(1) : describe_end(status);
    }
    return finding;
}

} // namespace

std::vector<ContextFinding> survey_contexts() {
    std::vector<ContextFinding> findings;
    for (const Way& way : kWays) {
        findings.push_back(find(way));
    }
    return findings;
}

} // namespace alcove::gl
