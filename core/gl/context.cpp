#include "core/gl/context.hpp"

#include "core/base/error.hpp"
#include "core/base/nearest_name.hpp"
#include "core/gl/device_class.hpp"
#include "core/gl/egl_context.hpp"
#include "core/gl/glfw_context.hpp"
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
    m_device.device_class = to_text(classify_device(m_device.vendor, m_device.renderer));
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
    gl.BlendEquation(GL_FUNC_ADD);
    gl.BlendFunc(GL_ONE, GL_ZERO);
    gl.CullFace(GL_BACK);
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    gl.ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
}

bool is_software(const DeviceInfo& device) {
    return device.device_class == to_text(DeviceClass::software);
}

InputError make_software_error(ContextKind kind, std::string_view renderer) {
    return {"--context " + std::string(to_text(kind)), "turns out to be a software renderer",
            renderer, "a GPU; --allow-software takes it all the same"};
}

std::unique_ptr<Context> open_context(ContextKind kind, SoftwarePolicy policy) {
    switch (kind) {
    case ContextKind::osmesa:
        return open_osmesa_context();
    case ContextKind::egl:
        return open_egl_context(EglPlatform::either, policy == SoftwarePolicy::allow
                                                         ? EglDevices::any
                                                         : EglDevices::hardware);
    case ContextKind::glfw: {
        std::unique_ptr<Context> context = open_glfw_context();
        if (policy == SoftwarePolicy::refuse && is_software(context->device())) {
            throw make_software_error(kind, context->device().renderer);
        }
        return context;
    }
    case ContextKind::autodetect:
        break;
    }
    return is_osmesa_installed() ? open_osmesa_context()
                                 : open_egl_context(EglPlatform::surfaceless, EglDevices::software);
}

} // namespace alcove::gl
