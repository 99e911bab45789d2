#include "core/gl/osmesa_context.hpp"

#include "core/base/error.hpp"
#include "core/gl/library.hpp"

#include <array>
#include <cstdint>
#include <memory>

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

constexpr std::array kLibraryNames{"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"};

class OsmesaContext final : public Context {
  public:
    OsmesaContext()
        : Context("osmesa"),
          m_library("OSMesa", kLibraryNames, "libosmesa6 (Mesa 25.1 and later no longer have it)"),
          m_context(nullptr, m_library.find<DestroyContext>("OSMesaDestroyContext")) {
        const auto create = m_library.find<CreateContext>("OSMesaCreateContextAttribs");
        const auto make_current = m_library.find<MakeCurrent>("OSMesaMakeCurrent");
        constexpr std::array kAttributes{
            kFormat,       kRgba, kDepthBits,    0, kProfile, kCoreProfile,
            kMajorVersion, 4,     kMinorVersion, 5, 0,        0};
        m_context.reset(create(kAttributes.data(), nullptr));
        if (m_context == nullptr) {
            throw FailureError("OSMesa", "no OpenGL 4.5 core context");
        }
        if (make_current(m_context.get(), m_pixels.data(), GL_UNSIGNED_BYTE, kSide, kSide) == 0) {
            throw FailureError("OSMesa", "the context cannot be made current");
        }
        initialise(m_library.find<Resolver>("OSMesaGetProcAddress"));
    }

  private:
    /// The default framebuffer, which nothing draws into.
    static constexpr int kSide = 4;
    std::array<std::uint8_t, kSide * kSide * 4> m_pixels{};
    Library m_library;
    std::unique_ptr<Opaque, DestroyContext> m_context;
};

} // namespace

bool is_osmesa_installed() {
    return can_open_library(kLibraryNames);
}

std::unique_ptr<Context> open_osmesa_context() {
    return std::make_unique<OsmesaContext>();
}

} // namespace alcove::gl
