#pragma once
// OpenGL 4.5 core contexts. Their libraries are opened at run time, so that one binary starts where
// one is missing.

#include "core/base/error.hpp"
#include "core/gl/functions.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace alcove::gl {

/// Spelt auto, osmesa, egl and glfw on the command line. autodetect is the embedded default:
/// OSMesa, or EGL's surfaceless platform on llvmpipe where libOSMesa is missing (same device class,
/// same images; DeviceInfo.context says which it became).
enum class ContextKind { autodetect, osmesa, egl, glfw };
[[nodiscard]] std::string_view to_text(ContextKind kind);
/// Throws InputError with the nearest name.
[[nodiscard]] ContextKind parse_context_kind(std::string_view text);

/// What becomes of egl and glfw where they turn out to be a software renderer. autodetect and
/// osmesa are software by definition and never refused.
enum class SoftwarePolicy { refuse, allow };

/// What executes the passes; printed beside every time.
struct DeviceInfo {
    std::string device_class; ///< to_text(DeviceClass), see core/gl/device_class.hpp
    std::string vendor;
    std::string renderer;
    std::string version;
    std::string context; ///< "osmesa", "egl-device", "egl-surfaceless", "glfw"
};
[[nodiscard]] bool is_software(const DeviceInfo& device);

class Context {
  public:
    virtual ~Context() = default;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    [[nodiscard]] const Functions& functions() const noexcept { return m_functions; }
    [[nodiscard]] const DeviceInfo& device() const noexcept { return m_device; }

    /// Throws FailureError with the driver's words if it reported a GL error since the last call.
    void check_errors();

    /// Brings back the state every method may rely on: no framebuffer, program, vertex array,
    /// texture, sampler, image or buffer bound, blending, depth test, culling and scissor off, all
    /// masks on, default clip control and packing.
    void reset_state();

    /// For FetchCounter alone: whether programs that are built from now on count their fetches.
    void set_counts_fetches(bool counts) noexcept { m_functions.counts_fetches = counts; }

  protected:
    explicit Context(std::string context_name) { m_device.context = std::move(context_name); }
    /// To be called by the derived class once its context is current.
    void initialise(Resolver resolve);

  private:
    static void APIENTRY collect_message(GLenum source, GLenum type, GLuint id, GLenum severity,
                                         GLsizei length, const GLchar* message, const void* user);
    Functions m_functions;
    DeviceInfo m_device;
    std::vector<std::string> m_errors;
};

/// Creates a context and makes it current on the calling thread. egl takes a GPU wherever it finds
/// one, and a software renderer only if it is allowed and there is no GPU. Throws FailureError
/// naming the library and package that is missing or what the driver refused, InputError naming the
/// renderer for a software renderer that is not allowed.
[[nodiscard]] std::unique_ptr<Context> open_context(ContextKind kind,
                                                    SoftwarePolicy policy = SoftwarePolicy::refuse);

/// The error of a software renderer where `kind` asked for a GPU.
[[nodiscard]] InputError make_software_error(ContextKind kind, std::string_view renderer);

} // namespace alcove::gl
