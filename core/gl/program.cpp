#include "core/gl/program.hpp"

#include "core/base/error.hpp"
#include "core/base/nearest_name.hpp"

#include <regex>
#include <set>
#include <sstream>
#include <vector>

namespace alcove::gl {
namespace {

class Expander {
  public:
    Expander(const ShaderLibrary& library, const GeneratedFiles& generated)
        : m_library(library), m_generated(generated) {}

    ExpandedSource run(const std::string& file) {
        m_source.text = "#version 450 core\n";
        insert(file, "");
        return std::move(m_source);
    }

  private:
    void insert(const std::string& file, const std::string& included_from) {
        if (!m_seen.insert(file).second) {
            return;
        }
        const std::size_t index = m_source.files.size();
        m_source.files.push_back({file, included_from});
        const auto generated = m_generated.find(file);
        const std::string text(generated != m_generated.end() ? std::string_view(generated->second)
                                                              : m_library.find(file));
        static const std::regex kInclude(R"re(^\s*#include\s+"([^"]+)"\s*$)re");
        std::istringstream lines(text);
        std::string line;
        m_source.text += "#line 1 " + std::to_string(index) + "\n";
        for (int number = 1; std::getline(lines, line); ++number) {
            std::smatch match;
            if (std::regex_match(line, match, kInclude)) {
                insert(match[1], file + ":" + std::to_string(number));
                m_source.text +=
                    "#line " + std::to_string(number + 1) + " " + std::to_string(index) + "\n";
            } else {
                m_source.text += line + "\n";
            }
        }
    }

    const ShaderLibrary& m_library;
    const GeneratedFiles& m_generated;
    std::set<std::string> m_seen;
    ExpandedSource m_source;
};

std::string get_log(const Functions& gl, GLuint name, bool is_program) {
    GLint length = 0;
    if (is_program) {
        gl.GetProgramiv(name, GL_INFO_LOG_LENGTH, &length);
    } else {
        gl.GetShaderiv(name, GL_INFO_LOG_LENGTH, &length);
    }
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    if (is_program) {
        gl.GetProgramInfoLog(name, length, nullptr, log.data());
    } else {
        gl.GetShaderInfoLog(name, length, nullptr, log.data());
    }
    while (!log.empty() && (log.back() == '\0' || log.back() == '\n')) {
        log.pop_back();
    }
    return log;
}

ShaderHandle compile(const Functions& gl, const ShaderLibrary& library, const ShaderStage& stage,
                     const GeneratedFiles& generated) {
    const ExpandedSource source = expand_includes(library, stage.file, generated);
    ShaderHandle shader(gl, gl.CreateShader(stage.stage));
    const char* text = source.text.c_str();
    gl.ShaderSource(shader.get(), 1, &text, nullptr);
    gl.CompileShader(shader.get());
    GLint compiled = 0;
    gl.GetShaderiv(shader.get(), GL_COMPILE_STATUS, &compiled);
    if (compiled == 0) {
        throw FailureError(stage.file, "shader does not compile:\n" +
                                           name_places(get_log(gl, shader.get(), false), source));
    }
    return shader;
}

} // namespace

ShaderLibrary::ShaderLibrary(std::initializer_list<std::span<const EmbeddedFile>> parts) {
    for (const std::span<const EmbeddedFile> part : parts) {
        for (const EmbeddedFile& file : part) {
            m_files.emplace(file.name, file.text);
        }
    }
}

std::string_view ShaderLibrary::find(const std::string& name) const {
    const auto found = m_files.find(name);
    if (found == m_files.end()) {
        std::vector<std::string> names;
        for (const auto& [known, text] : m_files) {
            names.push_back(known);
        }
        throw FailureError("shader library", "no such file", name,
                           "for example " + nearest_name(name, names));
    }
    return found->second;
}

void Program::bind_block(const char* name, GLuint binding) const {
    const GLuint index = m_gl->GetUniformBlockIndex(get(), name);
    if (index != GL_INVALID_INDEX) {
        m_gl->UniformBlockBinding(get(), index, binding);
    }
}

ExpandedSource expand_includes(const ShaderLibrary& library, const std::string& file,
                               const GeneratedFiles& generated) {
    return Expander{library, generated}.run(file);
}

std::string name_places(std::string_view log, const ExpandedSource& source) {
    // Mesa: "0:12(5): error: ..."; NVIDIA: "0(12) : error C1: ...".
    static const std::regex kPlace(R"re(^(\d+)(?::(\d+)(?:\((\d+)\))?|\((\d+)\)))re");
    std::istringstream lines{std::string(log)};
    std::string line;
    std::string text;
    while (std::getline(lines, line)) {
        std::smatch match;
        if (std::regex_search(line, match, kPlace)) {
            const auto index = static_cast<std::size_t>(std::stoul(match[1]));
            if (index < source.files.size()) {
                const ExpandedSource::File& file = source.files[index];
                const std::string number = match[2].matched ? match[2] : match[4];
                const std::string included =
                    file.included_from.empty() ? "" : " (included from " + file.included_from + ")";
                line = file.name + ":" + number + included + match.suffix().str();
            }
        }
        text += line + "\n";
    }
    return text;
}

Program build_program(const Functions& gl, const ShaderLibrary& library,
                      std::initializer_list<ShaderStage> stages, const GeneratedFiles& generated) {
    ProgramHandle program(gl, gl.CreateProgram());
    std::string files;
    for (const ShaderStage& stage : stages) {
        const ShaderHandle shader = compile(gl, library, stage, generated);
        gl.AttachShader(program.get(), shader.get());
        files += (files.empty() ? "" : " + ") + stage.file;
    }
    gl.LinkProgram(program.get());
    GLint linked = 0;
    gl.GetProgramiv(program.get(), GL_LINK_STATUS, &linked);
    if (linked == 0) {
        throw FailureError(files, "program does not link:\n" + get_log(gl, program.get(), true));
    }
    return {gl, std::move(program)};
}

} // namespace alcove::gl
