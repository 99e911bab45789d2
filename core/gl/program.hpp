#pragma once
// Shaders: embedded GLSL with #include, and errors that name file, line and the way it was
// included.

#include "core/base/embedded_file.hpp"
#include "core/gl/handles.hpp"

#include <initializer_list>
#include <map>
#include <span>
#include <string>
#include <string_view>

namespace alcove::gl {

/// GLSL files by their path in the tree. `#include "core/frame/reconstruct.glsl"` inserts one, once
/// a program stage.
class ShaderLibrary {
  public:
    ShaderLibrary(std::initializer_list<std::span<const EmbeddedFile>> parts);
    /// Throws FailureError with the nearest name.
    [[nodiscard]] std::string_view find(const std::string& name) const;

  private:
    std::map<std::string, std::string_view, std::less<>> m_files;
};

struct ShaderStage {
    GLenum stage; ///< GL_VERTEX_SHADER, GL_FRAGMENT_SHADER or GL_COMPUTE_SHADER
    std::string file;
};

/// Texts that exist only for one program, by the name they are included under, e.g.
/// {"parameters.glsl", ...}.
using GeneratedFiles = std::map<std::string, std::string, std::less<>>;

/// A linked program with its uniforms by name. A name the compiler dropped has location -1, which
/// GL ignores.
class Program {
  public:
    Program() = default;
    Program(const Functions& gl, ProgramHandle handle) : m_gl(&gl), m_handle(std::move(handle)) {}
    [[nodiscard]] GLuint get() const noexcept { return m_handle.get(); }
    [[nodiscard]] GLint location(const char* name) const {
        return m_gl->GetUniformLocation(get(), name);
    }
    void use() const { m_gl->UseProgram(get()); }
    /// Connects a uniform block, if the program has it, to a binding point.
    void bind_block(const char* name, GLuint binding) const;

  private:
    const Functions* m_gl = nullptr;
    ProgramHandle m_handle;
};

/// Compiles and links. Every stage begins with `#version 450 core`, which the files themselves do
/// not hold. Throws FailureError: "methods/x/x.frag.glsl:12 (included from ...): the driver's
/// words".
[[nodiscard]] Program build_program(const Functions& gl, const ShaderLibrary& library,
                                    std::initializer_list<ShaderStage> stages,
                                    const GeneratedFiles& generated = {});

/// A stage with its includes inserted; `files[k]` is source string k of the #line directives.
/// Exposed for its test.
struct ExpandedSource {
    std::string text;
    struct File {
        std::string name;
        std::string included_from; ///< "file:line", empty for the stage's own file
    };
    std::vector<File> files;
};
/// `prelude` stands behind #version.
[[nodiscard]] ExpandedSource expand_includes(const ShaderLibrary& library, const std::string& file,
                                             const GeneratedFiles& generated,
                                             std::string_view prelude = {});

/// Rewrites the driver's "k:line(column)" and "k(line)" places into file names.
[[nodiscard]] std::string name_places(std::string_view log, const ExpandedSource& source);

} // namespace alcove::gl
