#include "core/gl/glfw_context.hpp"

#include "core/base/error.hpp"
#include "core/gl/library.hpp"

#include <array>
#include <chrono>
#include <cstdlib>
#include <thread>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace alcove::gl {
namespace {

/// The library with the functions that are used of it.
struct Glfw {
    Library library{"GLFW", std::array{"libglfw.so.3"}, "libglfw3"};
    decltype(&glfwInit) init = library.find<decltype(init)>("glfwInit");
    decltype(&glfwTerminate) terminate = library.find<decltype(terminate)>("glfwTerminate");
    decltype(&glfwGetError) get_error = library.find<decltype(get_error)>("glfwGetError");
    decltype(&glfwWindowHint) window_hint = library.find<decltype(window_hint)>("glfwWindowHint");
    decltype(&glfwCreateWindow) create_window =
        library.find<decltype(create_window)>("glfwCreateWindow");
    decltype(&glfwMakeContextCurrent) make_current =
        library.find<decltype(make_current)>("glfwMakeContextCurrent");
    decltype(&glfwSwapInterval) swap_interval =
        library.find<decltype(swap_interval)>("glfwSwapInterval");
    decltype(&glfwGetProcAddress) get_proc_address =
        library.find<decltype(get_proc_address)>("glfwGetProcAddress");

    [[nodiscard]] std::string read_error() const {
        const char* words = nullptr;
        get_error(&words);
        return words == nullptr ? "" : words;
    }
};

class GlfwContext final : public Context {
  public:
    GlfwContext() : Context("glfw") {
        if (!try_init()) {
            throw FailureError("GLFW", "cannot be initialised", m_glfw.read_error(),
                               "a display: set DISPLAY, or start under `xvfb-run -a`");
        }
        m_session = Session(&m_glfw);
        m_glfw.window_hint(GLFW_VISIBLE, GLFW_FALSE);
        m_glfw.window_hint(GLFW_CONTEXT_VERSION_MAJOR, 4);
        m_glfw.window_hint(GLFW_CONTEXT_VERSION_MINOR, 5);
        m_glfw.window_hint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        GLFWwindow* window = m_glfw.create_window(kSide, kSide, "Alcove", nullptr, nullptr);
        if (window == nullptr) {
            throw FailureError("GLFW", "no OpenGL 4.5 core context", m_glfw.read_error());
        }
        m_glfw.make_current(window);
        m_glfw.swap_interval(0);
        initialise(m_glfw.get_proc_address);
    }

  private:
    /// An X server starts anew when its last client leaves (Xvfb does, after the survey's window)
    /// and for a moment takes no client, so a display that is named gets 1 s.
    [[nodiscard]] bool try_init() const {
        constexpr int kTries = 10;
        const char* display = std::getenv("DISPLAY");
        const bool is_named = display != nullptr && *display != '\0';
        for (int i = 0; i < (is_named ? kTries : 1); ++i) {
            if (i > 0) {
                std::this_thread::sleep_for(std::chrono::milliseconds(100));
            }
            if (m_glfw.init() != GLFW_FALSE) {
                return true;
            }
        }
        return false;
    }

    struct End {
        void operator()(const Glfw* glfw) const { glfw->terminate(); }
    };
    /// Ends GLFW, and with it the window and its context.
    using Session = std::unique_ptr<const Glfw, End>;
    /// The default framebuffer's, which nothing draws into.
    static constexpr int kSide = 16;
    Glfw m_glfw;
    Session m_session;
};

} // namespace

std::unique_ptr<Context> open_glfw_context() {
    return std::make_unique<GlfwContext>();
}

} // namespace alcove::gl
