#include "methods/common/summed_area_table.hpp"

#include "methods/common/shaders.hpp"

namespace alcove {
namespace {

constexpr GLuint kImageUnit = 0;
constexpr int kGroupSize =
    16; ///< as in the shaders: few enough that 180 rows keep all threads busy

GLuint count_groups(int lines) {
    return static_cast<GLuint>((lines + kGroupSize - 1) / kGroupSize);
}

} // namespace

SummedAreaTable::SummedAreaTable(const gl::Functions& gl, SummedAreaFormat format,
                                 ImageSize sample_size)
    : texture(gl, format == SummedAreaFormat::float32 ? GL_RGBA32F : GL_RGBA32UI,
              {sample_size.width + 1, sample_size.height + 1}),
      samples(sample_size) {
    // The scan never writes row 0 and column 0.
    const bool is_float = format == SummedAreaFormat::float32;
    gl.ClearTexImage(texture.get(), 0, is_float ? GL_RGBA : GL_RGBA_INTEGER,
                     is_float ? GL_FLOAT : GL_UNSIGNED_INT, nullptr);
}

std::string make_summed_area_glsl(SummedAreaFormat format, bool interpolated) {
    const bool is_float = format == SummedAreaFormat::float32;
    std::string text;
    text += std::string("#define SAT_VALUE ") + (is_float ? "vec4" : "uvec4") + "\n";
    text += std::string("#define SAT_SAMPLER ") + (is_float ? "sampler2D" : "usampler2D") + "\n";
    text += std::string("#define SAT_IMAGE ") + (is_float ? "image2D" : "uimage2D") + "\n";
    text += std::string("#define SAT_FORMAT ") + (is_float ? "rgba32f" : "rgba32ui") + "\n";
    text += std::string("#define SAT_IS_FLOAT ") + (is_float ? "true" : "false") + "\n";
    text += std::string("#define SAT_INTERPOLATED ") + (interpolated ? "true" : "false") + "\n";
    text += "#define SAT_GROUP_SIZE " + std::to_string(kGroupSize) + "\n";
    return text;
}

SummedAreaScan::SummedAreaScan(const gl::Functions& gl, const gl::GeneratedFiles& generated)
    : m_gl(&gl),
      m_columns(gl::build_program(
          gl, make_method_shader_library(),
          {{GL_COMPUTE_SHADER, "methods/common/summed_area_columns.comp.glsl"}}, generated)),
      m_rows(gl::build_program(gl, make_method_shader_library(),
                               {{GL_COMPUTE_SHADER, "methods/common/summed_area_rows.comp.glsl"}},
                               generated)) {}

void SummedAreaScan::build(const SummedAreaTable& table) const {
    const gl::Functions& gl = *m_gl;
    const GLuint name = table.texture.get();
    const GLenum format = table.texture.format();
    gl.BindImageTexture(kImageUnit, name, 0, GL_FALSE, 0, GL_WRITE_ONLY, format);
    gl.Uniform2i(m_columns.location("samples"), table.samples.width, table.samples.height);
    gl.DispatchCompute(count_groups(table.samples.width), 1, 1);
    gl.MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    m_rows.use();
    gl.BindImageTexture(kImageUnit, name, 0, GL_FALSE, 0, GL_READ_WRITE, format);
    gl.Uniform2i(m_rows.location("samples"), table.samples.width, table.samples.height);
    gl.DispatchCompute(count_groups(table.samples.height), 1, 1);
    gl.MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

} // namespace alcove
