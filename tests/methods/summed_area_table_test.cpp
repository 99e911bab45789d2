// Summed-area tables against sums in double precision and in whole numbers, at every point of the
// corner lattice.
#include "core/gl/texels.hpp"
#include "methods/common/summed_area_table.hpp"
#include "tests/core/gl/test_context.hpp"

#include <cmath>
#include <cstring>
#include <random>

namespace alcove {
namespace {

// Neither side a multiple of a group of the scan.
constexpr ImageSize kSize{53, 37};

/// Samples as they are in a texture; whole numbers are their values times 2^20.
constexpr const char* kInput = R"(
layout(binding = 0) uniform sampler2D values;
struct SummedAreaInput { int unused; };
SummedAreaInput begin_input() { return SummedAreaInput(0); }
SAT_VALUE read_input(SummedAreaInput state, ivec2 place) {
    vec4 value = texelFetch(values, place, 0);
    return SAT_IS_FLOAT ? SAT_VALUE(value) : SAT_VALUE(ivec4(value * 1048576.0));
}
)";

class SummedAreaTableTest : public GlTest {
  protected:
    static std::vector<float> make_values() {
        std::minstd_rand random(11);
        std::vector<float> values(kSize.pixel_count() * 4);
        for (float& value : values) {
            // Multiples of 2^-20 up to 500: floats hold those of 2^-15 exactly.
            value = static_cast<float>(random() % 32768000u) / 32768.0f - 500.0f;
        }
        return values;
    }

    /// (W + 1) x (H + 1) entries of four components, rows from the bottom.
    template <class Number>
    std::vector<Number> build(SummedAreaFormat format, const std::vector<float>& values) {
        const gl::Texture input(gl(), GL_RGBA32F, kSize);
        gl::write_texels(gl(), input, std::as_bytes(std::span(values)));
        const SummedAreaScan scan(
            gl(), {{"summed_area_format.glsl", make_summed_area_glsl(format, false)},
                   {"summed_area_input.glsl", kInput}});
        const SummedAreaTable table(gl(), format, kSize);
        scan.use();
        gl().BindTextureUnit(0, input.get());
        scan.build(table);
        const bool is_float = format == SummedAreaFormat::float32;
        std::vector<Number> sums(table.texture.size().pixel_count() * 4);
        gl().GetTextureImage(table.texture.get(), 0, is_float ? GL_RGBA : GL_RGBA_INTEGER,
                             is_float ? GL_FLOAT : GL_UNSIGNED_INT,
                             static_cast<GLsizei>(sums.size() * sizeof(Number)), sums.data());
        context().check_errors();
        return sums;
    }

    /// The same in `Sum`, by definition: everything left of and below each corner.
    template <class Sum, class Convert>
    static std::vector<Sum> add_up(const std::vector<float>& values, Convert convert) {
        const std::size_t stride = (static_cast<std::size_t>(kSize.width) + 1) * 4;
        std::vector<Sum> sums(stride * (static_cast<std::size_t>(kSize.height) + 1));
        for (int v = 1; v <= kSize.height; ++v) {
            for (int u = 1; u <= kSize.width; ++u) {
                for (std::size_t c = 0; c < 4; ++c) {
                    const std::size_t at =
                        static_cast<std::size_t>(v) * stride + static_cast<std::size_t>(u) * 4 + c;
                    const std::size_t sample =
                        static_cast<std::size_t>((v - 1) * kSize.width + u - 1) * 4 + c;
                    sums[at] = sums[at - 4] + sums[at - stride] - sums[at - stride - 4] +
                               convert(values[sample]);
                }
            }
        }
        return sums;
    }
};

TEST_F(SummedAreaTableTest, FloatsMatchTheDoubleSumAtEveryCorner) {
    const std::vector<float> values = make_values();
    const std::vector<float> table = build<float>(SummedAreaFormat::float32, values);
    const std::vector<double> expected =
        add_up<double>(values, [](float value) { return static_cast<double>(value); });
    ASSERT_EQ(table.size(), expected.size());
    double largest = 0.0;
    for (std::size_t i = 0; i < table.size(); ++i) {
        largest = std::max(largest, std::abs(static_cast<double>(table[i]) - expected[i]));
    }
    // Column sums reach 37 * 500, sums 53 * 37 * 500 at most, here about a tenth of it as signs are
    // mixed: 90 roundings of half a unit in the last place of 2^17.
    EXPECT_LT(largest, 90.0 * 0.5 * 0x1p-6);
    EXPECT_GT(largest, 0.0) << "float32 rounds: nothing was compared";
    RecordProperty("largest_error_of_a_sum", std::to_string(largest));
}

TEST_F(SummedAreaTableTest, RowAndColumnZeroAreZero) {
    const std::vector<float> table = build<float>(SummedAreaFormat::float32, make_values());
    const auto width = static_cast<std::size_t>(kSize.width) + 1;
    for (std::size_t i = 0; i < 4 * width; ++i) {
        ASSERT_EQ(table[i], 0.0f);
    }
    for (std::size_t v = 0; v <= static_cast<std::size_t>(kSize.height); ++v) {
        ASSERT_EQ(table[v * width * 4], 0.0f);
    }
    EXPECT_NE(table[(width + 1) * 4], 0.0f);
}

TEST_F(SummedAreaTableTest, WholeNumbersWrapAroundExactly) {
    const std::vector<float> values = make_values();
    const std::vector<std::uint32_t> table = build<std::uint32_t>(SummedAreaFormat::uint32, values);
    const auto convert = [](float value) {
        return static_cast<std::int64_t>(static_cast<double>(value) * 0x1p20);
    };
    const std::vector<std::int64_t> expected = add_up<std::int64_t>(values, convert);
    bool wraps = false;
    for (std::size_t i = 0; i < table.size(); ++i) {
        ASSERT_EQ(table[i], static_cast<std::uint32_t>(expected[i])) << i;
        wraps = wraps || std::abs(expected[i]) > (std::int64_t{1} << 32);
    }
    EXPECT_TRUE(wraps) << "no sum was long enough to wrap";
    // What fits 32 bits by itself is right for any rectangle: here of 2 x 2 samples, 2^31 at most.
    const std::size_t stride = (static_cast<std::size_t>(kSize.width) + 1) * 4;
    for (std::size_t v = 2; v <= static_cast<std::size_t>(kSize.height); ++v) {
        for (std::size_t at = v * stride + 8; at < (v + 1) * stride; ++at) {
            const std::uint32_t sum =
                table[at] - table[at - 8] - table[at - 2 * stride] + table[at - 2 * stride - 8];
            const std::int64_t truth = expected[at] - expected[at - 8] - expected[at - 2 * stride] +
                                       expected[at - 2 * stride - 8];
            ASSERT_EQ(static_cast<std::int32_t>(sum), truth);
        }
    }
}

} // namespace
} // namespace alcove
