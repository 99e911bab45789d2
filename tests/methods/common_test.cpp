// What methods share: sequences, pixel noise, tangent frames.
#include "core/frame/full_screen.hpp"
#include "methods/common/sequence.hpp"
#include "methods/common/shaders.hpp"
#include "tests/methods/depth_image_rig.hpp"
#include "tests/methods/hemisphere_ssao_oracle.hpp"

#include <array>
#include <cmath>
#include <set>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

TEST(RadicalInverse, MatchesValuesByHand) {
    EXPECT_EQ(compute_radical_inverse(0, 2), 0.0);
    EXPECT_EQ(compute_radical_inverse(1, 2), 0.5);
    EXPECT_EQ(compute_radical_inverse(6, 2), 0.375);               // 110 -> .011
    EXPECT_EQ(compute_radical_inverse(13, 2), 0.6875);             // 1101 -> .1011
    EXPECT_DOUBLE_EQ(compute_radical_inverse(5, 3), 7.0 / 9.0);    // 12 -> .21
    EXPECT_DOUBLE_EQ(compute_radical_inverse(26, 3), 26.0 / 27.0); // 222 -> .222
    EXPECT_DOUBLE_EQ(compute_radical_inverse(7, 5), 11.0 / 25.0);  // 12 -> .21
    EXPECT_LT(compute_radical_inverse(0xffffffffu, 2), 1.0);
    EXPECT_LT(compute_radical_inverse(0xffffffffu, 3), 1.0);
}

class CommonShaderTest : public GlTest {
  protected:
    /// Draws `main_text`, which writes `out vec4 result`, over the library's file `included`.
    Image draw(const char* included, const char* main_text, ImageSize size,
               std::uint32_t seed = 0) {
        const gl::ShaderLibrary methods = make_method_shader_library();
        const std::string text = "#include \"" + std::string(included) +
                                 "\"\nlayout(location = 0) out vec4 result;\nuniform uint seed;\n" +
                                 std::string(main_text);
        const std::array files{EmbeddedFile{"test.frag.glsl", text},
                               EmbeddedFile{included, methods.find(included)},
                               EmbeddedFile{"core/gl/full_screen.vert.glsl",
                                            methods.find("core/gl/full_screen.vert.glsl")}};
        const gl::ShaderLibrary library{std::span<const EmbeddedFile>(files)};
        context().reset_state();
        const FullScreenProgram program(gl(), library, "test.frag.glsl");
        const gl::Texture target(gl(), GL_RGBA32F, size);
        const gl::FramebufferHandle framebuffer = gl::create_framebuffer(gl(), {&target});
        program.use();
        gl().Uniform1ui(program.location("seed"), seed);
        program.draw(framebuffer.get(), size);
        return gl::read_texture(gl(), target, 4);
    }

    Image draw_noise(std::uint32_t seed) {
        return draw(
            "methods/common/noise.glsl",
            "void main() { result = vec4(compute_pixel_noise(ivec2(gl_FragCoord.xy), seed)); }",
            kNoise, seed);
    }
    static constexpr ImageSize kNoise{256, 256};
};

TEST_F(CommonShaderTest, TangentFramesAreOrthonormalAndRightHandedForEveryNormal) {
    // A pixel a normal: a grid over the sphere, the poles exactly, tiny components, and directions
    // just beside -z, where the denominator s + n.z would vanish without the sign. The result is
    // the largest error of the six products.
    const char* const kMain = R"(
        void main() {
            ivec2 i = ivec2(gl_FragCoord.xy);
            float polar = 3.14159265 * float(i.y) / 63.0;
            float azimuth = 6.2831853 * float(i.x) / 64.0;
            vec3 n = normalize(vec3(sin(polar) * cos(azimuth), sin(polar) * sin(azimuth), cos(polar)));
            if (i.y == 1) {
                float e = pow(10.0, -float(i.x % 10));
                n = normalize(vec3(i.x < 32 ? e : 0.0, -e * 0.7, i.x % 2 == 0 ? -1.0 : 1.0));
            }
            if (i.y == 0) {
                n = vec3[](vec3(0, 0, -1), vec3(0, 0, 1), vec3(1, 0, 0), vec3(0, -1, 0), vec3(1, 0, -0.0),
                           vec3(0, 1, 1e-20))[i.x % 6];
            }
            vec3 t;
            vec3 b;
            compute_tangent_frame(n, t, b);
            vec3 products = abs(vec3(dot(t, b), dot(t, n), dot(b, n)));
            vec3 lengths = abs(vec3(dot(t, t), dot(b, b), dot(cross(t, b), n)) - 1.0);
            vec3 largest = max(products, lengths);
            result = vec4(max(largest.x, max(largest.y, largest.z)), n);
        })";
    const Image image = draw("methods/common/tangent_frame.glsl", kMain, {64, 64});
    EXPECT_EQ(image.at(0, 63, 3), -1.0f); // the exact pole was there
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            // A few units in the last place of 1.
            ASSERT_LT(image.at(x, y), 2e-6f)
                << image.at(x, y, 1) << " " << image.at(x, y, 2) << " " << image.at(x, y, 3);
        }
    }
}

TEST_F(CommonShaderTest, PixelNoiseIsThePublishedHash) {
    const Image noise = draw_noise(77);
    for (std::uint32_t y = 0; y < 256; y += 17) {
        for (std::uint32_t x = 0; x < 256; x += 5) {
            ASSERT_EQ(static_cast<double>(noise.at(static_cast<int>(x), static_cast<int>(255 - y))),
                      compute_oracle_noise(x, y, 77));
        }
    }
    // Worked out apart, in integers of another language: 24 bits at (0, 0) with seed 0 and at (3,
    // 5) with seed 77.
    EXPECT_EQ(draw_noise(0).at(0, 255), 8379828.0f * 0x1p-24f);
    EXPECT_EQ(noise.at(3, 250), 2370295.0f * 0x1p-24f);
}

TEST_F(CommonShaderTest, PixelNoiseIsUniform) {
    for (const std::uint32_t seed : {0u, 1u, 4000000000u}) {
        const Image noise = draw_noise(seed);
        std::array<int, 256> counts{};
        double sum = 0.0;
        for (int y = 0; y < 256; ++y) {
            for (int x = 0; x < 256; ++x) {
                const float value = noise.at(x, y);
                ASSERT_TRUE(value >= 0.0f && value < 1.0f);
                ++counts.at(static_cast<std::size_t>(value * 256.0f));
                sum += static_cast<double>(value);
            }
        }
        // Five standard errors: 5 sqrt(1/12) / 256.
        EXPECT_NEAR(sum / 65536.0, 0.5, 0.00564) << seed;
        double chi_square = 0.0;
        for (const int count : counts) {
            chi_square += (count - 256.0) * (count - 256.0) / 256.0;
        }
        RecordProperty("chi_square_" + std::to_string(seed), std::to_string(chi_square));
        // 255 degrees of freedom: 255 +- 5 sqrt(510).
        EXPECT_NEAR(chi_square, 255.0, 113.0) << seed;
    }
}

/// Correlation of two images over the pixels where both exist, the second moved by (dx, dy).
double compute_correlation(const Image& a, const Image& b, int dx, int dy) {
    double sum = 0.0;
    int count = 0;
    for (int y = 0; y + dy < a.height(); ++y) {
        for (int x = 0; x + dx < a.width(); ++x) {
            sum += (static_cast<double>(a.at(x, y)) - 0.5) *
                   (static_cast<double>(b.at(x + dx, y + dy)) - 0.5);
            ++count;
        }
    }
    return 12.0 * sum / count;
}

TEST_F(CommonShaderTest, PixelNoiseHasNoPatternInRowsColumnsOrSeeds) {
    // Correlation of independent pixels: 1 / 256 a standard error; five of them.
    constexpr double kLimit = 5.0 / 256.0 * 1.05; // the overlap is a little smaller than the image
    const Image first = draw_noise(10);
    const Image second = draw_noise(11);
    for (const auto& [dx, dy] : std::array<std::pair<int, int>, 7>{
             {{1, 0}, {0, 1}, {1, 1}, {2, 0}, {0, 2}, {4, 0}, {0, 4}}}) {
        EXPECT_LT(std::abs(compute_correlation(first, first, dx, dy)), kLimit) << dx << " " << dy;
        EXPECT_LT(std::abs(compute_correlation(first, second, dx, dy)), kLimit) << dx << " " << dy;
    }
    EXPECT_LT(std::abs(compute_correlation(first, second, 0, 0)), kLimit);
    // Means of rows and of columns scatter as those of 256 independent values: 255 +- 5 sqrt(510)
    // in chi square.
    for (const bool rows : {true, false}) {
        double chi_square = 0.0;
        for (int i = 0; i < 256; ++i) {
            double sum = 0.0;
            for (int j = 0; j < 256; ++j) {
                sum += static_cast<double>(rows ? first.at(j, i) : first.at(i, j)) - 0.5;
            }
            chi_square += sum * sum * 12.0 / 256.0;
        }
        EXPECT_NEAR(chi_square, 256.0, 113.0) << (rows ? "rows" : "columns");
    }
}

} // namespace
} // namespace alcove
