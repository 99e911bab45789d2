#include "core/gl/program.hpp"

#include "core/base/error.hpp"
#include "core/base/nearest_name.hpp"
#include "core/gl/fetch_counter.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <sstream>
#include <vector>

namespace alcove::gl {
namespace {

constexpr std::string_view kSpaces = " \t\r\f\v";
constexpr std::string_view kDigits = "0123456789";

/// The file that a line `#include "file"` names; nothing on any other line.
std::optional<std::string> read_include(std::string_view line) {
    constexpr std::string_view kDirective = "#include";
    line.remove_prefix(std::min(line.find_first_not_of(kSpaces), line.size()));
    if (!line.starts_with(kDirective)) {
        return std::nullopt;
    }
    line.remove_prefix(kDirective.size());
    const std::size_t open = line.find_first_not_of(kSpaces);
    if (open == 0 || open == std::string_view::npos || line[open] != '"') {
        return std::nullopt;
    }
    const std::size_t close = line.find('"', open + 1);
    const bool is_whole = close != std::string_view::npos && close > open + 1 &&
                          line.find_first_not_of(kSpaces, close + 1) == std::string_view::npos;
    return is_whole ? std::optional(std::string(line.substr(open + 1, close - open - 1)))
                    : std::nullopt;
}

/// Removes the digits that `text` begins with and returns them.
std::string take_number(std::string_view& text) {
    const std::size_t end = std::min(text.find_first_not_of(kDigits), text.size());
    const std::string number(text.substr(0, end));
    text.remove_prefix(end);
    return number;
}

/// Removes "(number)" and returns the number; nothing, and nothing removed, if that is not there.
std::string take_number_in_parentheses(std::string_view& text) {
    std::string_view rest = text;
    if (!rest.starts_with('(')) {
        return {};
    }
    rest.remove_prefix(1);
    std::string number = take_number(rest);
    if (number.empty() || !rest.starts_with(')')) {
        return {};
    }
    rest.remove_prefix(1);
    text = rest;
    return number;
}

/// Where a driver's message points: Mesa "0:12(5): error: ...", NVIDIA "0(12) : error C1: ...".
struct Place {
    std::string source;
    std::string line;
    std::string_view rest;
};

std::optional<Place> read_place(std::string_view message) {
    Place place{take_number(message), {}, {}};
    if (place.source.empty()) {
        return std::nullopt;
    }
    if (message.starts_with(':')) {
        message.remove_prefix(1);
        place.line = take_number(message);
        static_cast<void>(take_number_in_parentheses(message)); // the column
    } else {
        place.line = take_number_in_parentheses(message);
    }
    place.rest = message;
    return place.line.empty() ? std::nullopt : std::optional(place);
}

class Expander {
  public:
    Expander(const ShaderLibrary& library, const GeneratedFiles& generated)
        : m_library(library), m_generated(generated) {}

    ExpandedSource run(const std::string& file, std::string_view prelude) {
        m_source.text = "#version 450 core\n";
        m_source.text += prelude;
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
        std::istringstream lines(text);
        std::string line;
        m_source.text += "#line 1 " + std::to_string(index) + "\n";
        for (int number = 1; std::getline(lines, line); ++number) {
            if (const std::optional<std::string> included = read_include(line)) {
                insert(*included, file + ":" + std::to_string(number));
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
    const ExpandedSource source = expand_includes(
        library, stage.file, generated, gl.counts_fetches ? make_counting_text() : std::string());
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
                               const GeneratedFiles& generated, std::string_view prelude) {
    return Expander{library, generated}.run(file, prelude);
}

std::string name_places(std::string_view log, const ExpandedSource& source) {
    std::istringstream lines{std::string(log)};
    std::string line;
    std::string text;
    while (std::getline(lines, line)) {
        if (const std::optional<Place> place = read_place(line)) {
            const std::size_t index =
                place->source.size() < 10 ? std::stoul(place->source) : source.files.size();
            if (index < source.files.size()) {
                const ExpandedSource::File& file = source.files[index];
                const std::string included =
                    file.included_from.empty() ? "" : " (included from " + file.included_from + ")";
                line = file.name + ":" + place->line + included + std::string(place->rest);
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
