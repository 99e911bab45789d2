#pragma once
// Summed-area tables on the corner lattice: S(u, v) = sum of the samples at i < u, j < v, so that
// the sum over any rectangle of whole samples is four values, at a cost that does not depend on its
// size. Row 0 and column 0 are zero: tables whose first entry is a sample itself are wrong at the
// left and the bottom border.
//
// Samples are what the shader of their owner says they are: xyz a sum, w a count. Sums of float32
// cancel: with N samples of value v before the rectangle a sum is exact to about N v / 2^24. uint32
// wraps around, and a rectangle's sum is exact as long as it fits into 32 signed bits by itself.
//
// This work is based on: Crow. Summed-area tables for texture mapping. 1984.

#include "core/frame/full_screen.hpp"

namespace alcove {

enum class SummedAreaFormat { float32, uint32 };

struct SummedAreaTable {
    SummedAreaTable() = default;
    /// Of samples of this size: the lattice is one larger each way.
    SummedAreaTable(const gl::Functions& gl, SummedAreaFormat format, ImageSize samples);
    gl::Texture texture; ///< RGBA32F or RGBA32UI
    ImageSize samples;
};

/// What a shader needs to hold for tables of this format, as "summed_area_format.glsl";
/// `interpolated` for rectangles that cut through samples.
[[nodiscard]] std::string make_summed_area_glsl(SummedAreaFormat format, bool interpolated);

/// Builds tables: one running sum down each column, then one along each row in place, an invocation
/// a column and a row.
class SummedAreaScan {
  public:
    SummedAreaScan() = default;
    /// `generated` holds "summed_area_format.glsl" and "summed_area_input.glsl", which defines
    ///     struct SummedAreaInput {...}; SummedAreaInput begin_input();
    ///     SAT_VALUE read_input(SummedAreaInput, ivec2 sample)
    SummedAreaScan(const gl::Functions& gl, const gl::GeneratedFiles& generated);
    /// Makes the program that reads the samples current, for its textures and uniforms.
    void use() const { m_columns.use(); }
    [[nodiscard]] const gl::Program& program() const noexcept { return m_columns; }
    /// The program of use() must be current. Later draws see the table; the current program is
    /// another one.
    void build(const SummedAreaTable& table) const;

  private:
    const gl::Functions* m_gl = nullptr;
    gl::Program m_columns;
    gl::Program m_rows;
};

} // namespace alcove
