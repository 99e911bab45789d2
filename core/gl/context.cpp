#include "core/gl/context.hpp"

#include "core/base/error.hpp"
#include "core/base/nearest_name.hpp"
#include "core/gl/osmesa_context.hpp"

#include <algorithm>
#include <array>

namespace alcove::gl {
namespace {

constexpr std::array kKinds{"auto", "osmesa", "egl", "glfw"};

/// Units that reset_state clears; no pass of Alcove binds more.
constexpr GLuint kTextureUnits = 16;
constexpr GLuint kImageUnits = 8;
constexpr GLuint kBufferBindings = 8;

} // namespace

std::string_view to_text(ContextKind kind) {
    return kKinds.at(static_cast<std::size_t>(kind));
}

ContextKind parse_context_kind(std::string_view text) {
    const std::vector<std::string> names(kKinds.begin(), kKinds.end());
    const auto found = std::find(names.begin(), names.end(), text);
    if (found == names.end()) {
        throw InputError("--context", "unknown context", text, describe_choices(text, names));
    }
    return static_cast<ContextKind>(found - names.begin());
}

void Context::collect_message(GLenum source, GLenum type, GLuint /*id*/, GLenum /*severity*/,
                              GLsizei /*length*/, const GLchar* message, const void* user) {
    // What the shader compiler has to say is thrown by build_program, with the files' names.
    if (type == GL_DEBUG_TYPE_ERROR && source != GL_DEBUG_SOURCE_SHADER_COMPILER) {
        const auto* context = static_cast<const Context*>(user);
        const_cast<Context*>(context)->m_errors.emplace_back(message);
    }
}

void Context::initialise(Resolver resolve) {
    m_functions = load_functions(resolve);
    const auto get = [this](GLenum name) {
        return std::string(reinterpret_cast<const char*>(m_functions.GetString(name)));
    };
    m_device.vendor = get(GL_VENDOR);
    m_device.renderer = get(GL_RENDERER);
    m_device.version = get(GL_VERSION);
    const auto has = [this](std::string_view part) {
        return m_device.renderer.find(part) != std::string::npos;
    };
    const bool software = has("llvmpipe") || has("softpipe") || has("swrast") || has("Software");
    m_device.device_class = software ? "software" : "hardware";
    m_functions.DebugMessageCallback(&Context::collect_message, this);
    m_functions.Enable(GL_DEBUG_OUTPUT);
    m_functions.Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
}

void Context::check_errors() {
    // Some drivers report an error without a message.
    for (GLenum error = m_functions.GetError(); error != GL_NO_ERROR;
         error = m_functions.GetError()) {
        if (m_errors.empty()) {
            m_errors.push_back("GL error " + std::to_string(error));
        }
    }
    if (!m_errors.empty()) {
        const std::string first = m_errors.front();
        const std::size_t count = m_errors.size();
        m_errors.clear();
        throw FailureError("OpenGL", first + " (" + std::to_string(count) + " in all)");
    }
}

void Context::reset_state() {
    const Functions& gl = m_functions;
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl.UseProgram(0);
    gl.BindVertexArray(0);
    for (GLuint unit = 0; unit < kTextureUnits; ++unit) {
        gl.BindTextureUnit(unit, 0);
        gl.BindSampler(unit, 0);
    }
    for (GLuint unit = 0; unit < kImageUnits; ++unit) {
        gl.BindImageTexture(unit, 0, 0, GL_FALSE, 0, GL_READ_ONLY, GL_R32F);
    }
    for (GLuint binding = 0; binding < kBufferBindings; ++binding) {
        gl.BindBufferBase(GL_UNIFORM_BUFFER, binding, 0);
        gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, 0);
    }
    for (const GLenum capability : {GL_BLEND, GL_DEPTH_TEST, GL_CULL_FACE, GL_SCISSOR_TEST,
                                    GL_STENCIL_TEST, GL_POLYGON_OFFSET_FILL}) {
        gl.Disable(static_cast<GLenum>(capability));
    }
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl.DepthMask(GL_TRUE);
    gl.DepthFunc(GL_LESS);
    gl.FrontFace(GL_CCW);
    gl.CullFace(GL_BACK);
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    gl.ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
}

std::unique_ptr<Context> open_context(ContextKind kind) {
    switch (kind) {
    case ContextKind::autodetect:
    case ContextKind::osmesa:
        return open_osmesa_context();
    case ContextKind::egl:
    case ContextKind::glfw:
        break;
    }
    throw InputError("--context", "planned, not built yet", to_text(kind), "auto or osmesa");
}

} // namespace alcove::gl
