#include "core/gl/osmesa_context.hpp"

#include "core/base/error.hpp"

#include <array>
#include <cstdint>
#include <dlfcn.h>

namespace alcove::gl {
namespace {

// From GL/osmesa.h, which cannot be included beside glcorearb.h.
constexpr int kFormat = 0x22;
constexpr int kRgba = 0x1908;
constexpr int kDepthBits = 0x30;
constexpr int kProfile = 0x33;
constexpr int kCoreProfile = 0x34;
constexpr int kMajorVersion = 0x36;
constexpr int kMinorVersion = 0x37;

struct Opaque;
using CreateContext = Opaque* (*)(const int*, Opaque*);
using DestroyContext = void (*)(Opaque*);
using MakeCurrent = GLboolean (*)(Opaque*, void*, GLenum, GLsizei, GLsizei);

/// libOSMesa for as long as the process runs: its worker threads do not survive an unload.
void* open_library() {
    for (const char* name : {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"}) {
        if (void* library = dlopen(name, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE)) {
            return library;
        }
    }
    throw FailureError("OSMesa", "libOSMesa cannot be opened", "",
                       "the package libosmesa6 (Mesa 25.1 and later no longer have it)");
}

template <class Function>
Function find_symbol(void* library, const char* name) {
    const auto function = reinterpret_cast<Function>(dlsym(library, name));
    if (function == nullptr) {
        throw FailureError("OSMesa", "the library lacks a function", name);
    }
    return function;
}

class OsmesaContext final : public Context {
  public:
    OsmesaContext() : Context("osmesa") {
        void* library = open_library();
        m_destroy = find_symbol<DestroyContext>(library, "OSMesaDestroyContext");
        const auto create = find_symbol<CreateContext>(library, "OSMesaCreateContextAttribs");
        const auto make_current = find_symbol<MakeCurrent>(library, "OSMesaMakeCurrent");
        constexpr std::array kAttributes{
            kFormat,       kRgba, kDepthBits,    0, kProfile, kCoreProfile,
            kMajorVersion, 4,     kMinorVersion, 5, 0,        0};
        m_context = create(kAttributes.data(), nullptr);
        if (m_context == nullptr) {
            throw FailureError("OSMesa", "no OpenGL 4.5 core context");
        }
        if (make_current(m_context, m_pixels.data(), GL_UNSIGNED_BYTE, kSide, kSide) == 0) {
            m_destroy(m_context);
            throw FailureError("OSMesa", "the context cannot be made current");
        }
        initialise(find_symbol<Resolver>(library, "OSMesaGetProcAddress"));
    }
    ~OsmesaContext() override { m_destroy(m_context); }
    OsmesaContext(const OsmesaContext&) = delete;
    OsmesaContext& operator=(const OsmesaContext&) = delete;

  private:
    /// The default framebuffer, which nothing draws into.
    static constexpr int kSide = 4;
    std::array<std::uint8_t, kSide * kSide * 4> m_pixels{};
    DestroyContext m_destroy = nullptr;
    Opaque* m_context = nullptr;
};

} // namespace

std::unique_ptr<Context> open_osmesa_context() {
    return std::make_unique<OsmesaContext>();
}

} // namespace alcove::gl
