#include "core/gl/egl_context.hpp"

#include "core/base/error.hpp"
#include "core/gl/library.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <vector>

namespace alcove::gl {
namespace {

/// Reads EGL's lists: words parted by spaces. Null is an empty list.
bool has_extension(const char* list, std::string_view name) {
    std::string_view rest = list == nullptr ? std::string_view() : std::string_view(list);
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(' '), rest.size());
        if (rest.substr(0, end) == name) {
            return true;
        }
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return false;
}

std::string describe_code(EGLint code) {
    constexpr std::array kNames{
        "EGL_SUCCESS",       "EGL_NOT_INITIALIZED",     "EGL_BAD_ACCESS",
        "EGL_BAD_ALLOC",     "EGL_BAD_ATTRIBUTE",       "EGL_BAD_CONFIG",
        "EGL_BAD_CONTEXT",   "EGL_BAD_CURRENT_SURFACE", "EGL_BAD_DISPLAY",
        "EGL_BAD_MATCH",     "EGL_BAD_NATIVE_PIXMAP",   "EGL_BAD_NATIVE_WINDOW",
        "EGL_BAD_PARAMETER", "EGL_BAD_SURFACE",         "EGL_CONTEXT_LOST"};
    const auto index = static_cast<std::size_t>(code - EGL_SUCCESS);
    return index < kNames.size() ? kNames.at(index) : "code " + std::to_string(code);
}

/// The library with the functions that are used of it.
struct Egl {
    Library library{"EGL", std::array{"libEGL.so.1"}, "libegl1"};
    PFNEGLGETPROCADDRESSPROC get_proc_address =
        library.find<PFNEGLGETPROCADDRESSPROC>("eglGetProcAddress");
    PFNEGLQUERYSTRINGPROC query_string = library.find<PFNEGLQUERYSTRINGPROC>("eglQueryString");
    PFNEGLGETERRORPROC get_error = library.find<PFNEGLGETERRORPROC>("eglGetError");
    PFNEGLINITIALIZEPROC initialize = library.find<PFNEGLINITIALIZEPROC>("eglInitialize");
    PFNEGLTERMINATEPROC terminate = library.find<PFNEGLTERMINATEPROC>("eglTerminate");
    PFNEGLBINDAPIPROC bind_api = library.find<PFNEGLBINDAPIPROC>("eglBindAPI");
    PFNEGLCREATECONTEXTPROC create_context =
        library.find<PFNEGLCREATECONTEXTPROC>("eglCreateContext");
    PFNEGLDESTROYCONTEXTPROC destroy_context =
        library.find<PFNEGLDESTROYCONTEXTPROC>("eglDestroyContext");
    PFNEGLMAKECURRENTPROC make_current = library.find<PFNEGLMAKECURRENTPROC>("eglMakeCurrent");

    /// An extension's function. Its name stands in the list of extensions, so it is there.
    template <class Function>
    [[nodiscard]] Function find_extension(const char* name) const {
        const auto function = reinterpret_cast<Function>(get_proc_address(name));
        if (function == nullptr) {
            throw FailureError("EGL", "lacks a function of an extension that it lists", name);
        }
        return function;
    }
};

/// A display that may give a context.
struct Candidate {
    std::string context_name;
    std::string label; ///< for reasons: "device 0", "surfaceless"
    EGLenum platform = 0;
    void* native = nullptr;
};

std::vector<Candidate> list_devices(const Egl& egl, const char* client_extensions) {
    for (const char* name :
         {"EGL_EXT_platform_device", "EGL_EXT_device_enumeration", "EGL_EXT_device_query"}) {
        if (!has_extension(client_extensions, name)) {
            return {};
        }
    }
    const auto query_devices = egl.find_extension<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
    EGLint count = 0;
    if (query_devices(0, nullptr, &count) == EGL_FALSE || count <= 0) {
        return {};
    }
    std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(count));
    if (query_devices(count, devices.data(), &count) == EGL_FALSE) {
        return {};
    }
    devices.resize(static_cast<std::size_t>(std::max(count, 0)));
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < devices.size(); ++i) {
        candidates.push_back(
            {"egl-device", "device " + std::to_string(i), EGL_PLATFORM_DEVICE_EXT, devices[i]});
    }
    // Mesa lists its software device among the others.
    const auto query_device =
        egl.find_extension<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
    std::stable_partition(candidates.begin(), candidates.end(), [&](const Candidate& one) {
        return !has_extension(query_device(one.native, EGL_EXTENSIONS), "EGL_MESA_device_software");
    });
    return candidates;
}

std::vector<Candidate> list_candidates(const Egl& egl, EglPlatform platform) {
    const char* extensions = egl.query_string(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    std::vector<Candidate> candidates;
    if (platform != EglPlatform::surfaceless) {
        candidates = list_devices(egl, extensions);
    }
    if (platform != EglPlatform::device &&
        has_extension(extensions, "EGL_MESA_platform_surfaceless")) {
        candidates.push_back(
            {"egl-surfaceless", "surfaceless", EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY});
    }
    return candidates;
}

/// An initialised display with a context that is current; gives both back.
class Current {
  public:
    /// On failure the reason is in `failure` and the object is empty.
    Current(const Egl& egl, const Candidate& candidate, std::string& failure) : m_egl(egl) {
        const char* failed_call = open(candidate);
        if (failed_call != nullptr) {
            failure = candidate.label + ": " + failed_call + " " + describe_code(egl.get_error());
            close();
        }
    }
    ~Current() { close(); }
    Current(const Current&) = delete;
    Current& operator=(const Current&) = delete;

    [[nodiscard]] explicit operator bool() const noexcept { return m_context != EGL_NO_CONTEXT; }

  private:
    /// The call that failed, or null.
    const char* open(const Candidate& candidate) {
        const auto get_display =
            m_egl.find_extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
        m_display = get_display(candidate.platform, candidate.native, nullptr);
        if (m_display == EGL_NO_DISPLAY) {
            return "eglGetPlatformDisplayEXT";
        }
        if (m_egl.initialize(m_display, nullptr, nullptr) == EGL_FALSE) {
            m_display = EGL_NO_DISPLAY;
            return "eglInitialize";
        }
        if (m_egl.bind_api(EGL_OPENGL_API) == EGL_FALSE) {
            return "eglBindAPI";
        }
        constexpr std::array<EGLint, 7> kAttributes{EGL_CONTEXT_MAJOR_VERSION,
                                                    4,
                                                    EGL_CONTEXT_MINOR_VERSION,
                                                    5,
                                                    EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                                    EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                                    EGL_NONE};
        // No surface, so no configuration of one: nothing draws into a default framebuffer.
        m_context =
            m_egl.create_context(m_display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, kAttributes.data());
        if (m_context == EGL_NO_CONTEXT) {
            return "eglCreateContext (OpenGL 4.5 core)";
        }
        if (m_egl.make_current(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, m_context) == EGL_FALSE) {
            return "eglMakeCurrent (without a surface)";
        }
        return nullptr;
    }

    void close() {
        if (m_display == EGL_NO_DISPLAY) {
            return;
        }
        m_egl.make_current(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (m_context != EGL_NO_CONTEXT) {
            m_egl.destroy_context(m_display, m_context);
        }
        m_egl.terminate(m_display);
        m_display = EGL_NO_DISPLAY;
        m_context = EGL_NO_CONTEXT;
    }

    const Egl& m_egl;
    EGLDisplay m_display = EGL_NO_DISPLAY;
    EGLContext m_context = EGL_NO_CONTEXT;
};

class EglContext final : public Context {
  public:
    EglContext(std::shared_ptr<const Egl> egl, const Candidate& candidate,
               std::unique_ptr<Current> current)
        : Context(candidate.context_name), m_egl(std::move(egl)), m_current(std::move(current)) {
        initialise(m_egl->get_proc_address);
    }

  private:
    std::shared_ptr<const Egl> m_egl; // outlives m_current
    std::unique_ptr<Current> m_current;
};

/// Mesa's surfaceless platform takes the first GPU it finds unless this is set.
class AlwaysSoftware {
  public:
    AlwaysSoftware() {
        if (const char* value = std::getenv(kName)) {
            m_before = value;
        }
        ::setenv(kName, "1", 1);
    }
    ~AlwaysSoftware() {
        if (m_before) {
            ::setenv(kName, m_before->c_str(), 1);
        } else {
            ::unsetenv(kName);
        }
    }
    AlwaysSoftware(const AlwaysSoftware&) = delete;
    AlwaysSoftware& operator=(const AlwaysSoftware&) = delete;

  private:
    static constexpr const char* kName = "LIBGL_ALWAYS_SOFTWARE";
    std::optional<std::string> m_before;
};

bool is_taken(const DeviceInfo& device, EglDevices devices) {
    return devices == EglDevices::any || is_software(device) == (devices == EglDevices::software);
}

} // namespace

std::unique_ptr<Context> open_egl_context(EglPlatform platform, EglDevices devices) {
    const auto egl = std::make_shared<const Egl>();
    std::optional<AlwaysSoftware> always_software;
    if (devices == EglDevices::software && platform == EglPlatform::surfaceless) {
        always_software.emplace();
    }
    std::string failures;
    std::string not_taken;
    for (const Candidate& candidate : list_candidates(*egl, platform)) {
        std::string failure;
        auto current = std::make_unique<Current>(*egl, candidate, failure);
        if (!*current) {
            failures += (failures.empty() ? "" : "; ") + failure;
            continue;
        }
        auto context = std::make_unique<EglContext>(egl, candidate, std::move(current));
        if (is_taken(context->device(), devices)) {
            return context;
        }
        if (not_taken.empty()) {
            not_taken = context->device().renderer;
        }
    }
    if (not_taken.empty()) {
        throw FailureError("EGL", "no OpenGL 4.5 core context without a display", failures,
                           "a driver with the device or the surfaceless platform, such as the "
                           "package libgl1-mesa-dri");
    }
    if (devices == EglDevices::software) {
        throw FailureError("EGL", "no software renderer", not_taken, "llvmpipe of Mesa");
    }
    throw make_software_error(ContextKind::egl, not_taken);
}

} // namespace alcove::gl
