// The kernels of crytek_ssao: indices, frames and random numbers, in the shader and in double.
#include "core/frame/full_screen.hpp"
#include "methods/common/parameter_block.hpp"
#include "methods/common/shaders.hpp"
#include "methods/crytek_ssao/crytek_ssao.hpp"
#include "methods/crytek_ssao/crytek_ssao_description.hpp"
#include "tests/core/gl/test_context.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include <glm/geometric.hpp>

namespace alcove {
namespace {

using Pair = std::pair<int, int>;

CrytekSsaoParams make_params(CrytekIndexing indexing) {
    CrytekSsaoParams params;
    params.indexing = indexing;
    params.samples = 4;
    return params;
}

std::vector<Pair> list_pairs(const CrytekSsaoParams& params, int direction_offset,
                             int length_offset) {
    std::vector<Pair> pairs;
    for (int j = 0; j < params.samples; ++j) {
        const CrytekIndices indices =
            compute_crytek_indices(j, direction_offset, length_offset, params);
        pairs.emplace_back(indices.direction, indices.length);
    }
    return pairs;
}

TEST(CrytekIndices, TheLiteralFormGivesThePrintedVectors) {
    const CrytekSsaoParams params = make_params(CrytekIndexing::decoupled_literal);
    EXPECT_EQ(list_pairs(params, 12, 12), (std::vector<Pair>{{1, 7}, {2, 3}, {3, 10}, {4, 6}}));
    EXPECT_EQ(list_pairs(params, 5, 5), (std::vector<Pair>{{5, 2}, {6, 9}, {7, 5}, {8, 1}}));
}

TEST(CrytekIndices, TheLiteralFormReachesElevenPairsAndTheOtherAllOf121) {
    const auto count_pairs = [](CrytekIndexing indexing) {
        const CrytekSsaoParams params = make_params(indexing);
        const bool is_literal = indexing == CrytekIndexing::decoupled_literal;
        std::set<Pair> pairs;
        for (int q = 0; q < (is_literal ? params.offsets : params.kernel_size); ++q) {
            for (int second = 0; second < params.kernel_size; ++second) {
                for (const Pair& pair : list_pairs(params, q, is_literal ? q : second)) {
                    pairs.insert(pair);
                }
            }
        }
        return pairs.size();
    };
    EXPECT_EQ(count_pairs(CrytekIndexing::decoupled_literal), 11u);
    EXPECT_EQ(count_pairs(CrytekIndexing::decoupled), 121u);
}

TEST(CrytekIndices, EighteenOffsetsFavourTheFirstSevenOfEleven) {
    const CrytekSsaoParams params = make_params(CrytekIndexing::decoupled_literal);
    std::array<int, 11> counts{};
    for (int q = 0; q < params.offsets; ++q) {
        ++counts.at(static_cast<std::size_t>(compute_crytek_indices(0, q, q, params).direction));
    }
    EXPECT_EQ(counts, (std::array<int, 11>{2, 2, 2, 2, 2, 2, 2, 1, 1, 1, 1}));
}

TEST(CrytekKernelPoints, AHemisphereKeepsAllItsPointsAndASphereLosesWhatLiesBelowTheLeastCosine) {
    CrytekSsaoParams params;
    params.samples = 512;
    params.weighting = CrytekWeighting::uniform;
    for (const CrytekKernel kernel :
         {CrytekKernel::hemisphere_frame, CrytekKernel::hemisphere_gram_schmidt}) {
        params.kernel = kernel;
        double mean = 0.0;
        for (const glm::vec4& point : make_crytek_kernel(params)) {
            EXPECT_GE(point.z, 0.15f);
            EXPECT_NEAR(glm::length(glm::dvec3(point)), 1.0, 1e-6);
            mean += static_cast<double>(point.z) / 512.0;
        }
        // Uniform over what is left: half-way between 0.15 and 1, as far as 512 points tell.
        EXPECT_NEAR(mean, 0.575, 0.004);
    }
    params.kernel = CrytekKernel::sphere_reflected;
    const std::vector<glm::vec4> sphere = make_crytek_kernel(params);
    for (const glm::dvec3& axis :
         {glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0), glm::dvec3(0.36, 0.48, 0.8)}) {
        int accepted = 0;
        for (const glm::vec4& point : sphere) {
            accepted += std::abs(glm::dot(glm::dvec3(point), axis)) >= params.min_cosine ? 1 : 0;
        }
        // 1 - 0.15 of uniform directions.
        EXPECT_NEAR(accepted / 512.0, 0.85, 0.01);
    }
    params.kernel = CrytekKernel::sphere;
    EXPECT_EQ(make_crytek_kernel(params).size(), 256u); // opposite pairs
}

class CrytekShaderTest : public GlTest {
  protected:
    /// Draws `main_text`, which writes `out vec4 result`, over the method's own kernel and random
    /// numbers.
    Image draw(const CrytekSsaoParams& params, const std::string& main_text, ImageSize size,
               std::uint32_t seed = 1) {
        const ParameterTable table = make_crytek_table();
        const ParameterBlock block(gl(), table, table.read(params));
        const gl::ShaderLibrary methods = make_method_shader_library();
        const std::string text = "#include \"parameters.glsl\"\n"
                                 "#include \"methods/crytek_ssao/crytek_ssao_kernel.glsl\"\n"
                                 "#include \"methods/crytek_ssao/crytek_ssao_random.glsl\"\n"
                                 "layout(location = 0) out vec4 result;\nuniform uint seed;\n" +
                                 main_text;
        std::vector<EmbeddedFile> files{EmbeddedFile{"test.frag.glsl", text}};
        for (const char* name :
             {"methods/crytek_ssao/crytek_ssao_kernel.glsl",
              "methods/crytek_ssao/crytek_ssao_random.glsl", "methods/common/tangent_frame.glsl",
              "methods/common/noise.glsl", "core/gl/full_screen.vert.glsl"}) {
            files.push_back({name, methods.find(name)});
        }
        const gl::ShaderLibrary library{std::span<const EmbeddedFile>(files)};
        context().reset_state();
        const FullScreenProgram program(gl(), library, "test.frag.glsl", block.generated_files());
        block.connect(program.program());
        const gl::Texture target(gl(), GL_RGBA32F, size);
        const gl::FramebufferHandle framebuffer = gl::create_framebuffer(gl(), {&target});
        program.use();
        block.bind();
        gl().Uniform1ui(program.location("seed"), seed);
        program.draw(framebuffer.get(), size);
        return gl::read_texture(gl(), target, 4);
    }

    /// Chi square of the angles that a kernel's frame turns to about a normal that leans `tilt`
    /// radians, for 4096 evenly spaced random numbers in 16 bins.
    double measure_clumping(CrytekKernel kernel, double tilt) {
        CrytekSsaoParams params;
        params.kernel = kernel;
        const std::string text =
            "void main() {\n    vec3 n = vec3(0.0, " + std::to_string(std::sin(tilt)) + ", " +
            std::to_string(std::cos(tilt)) +
            ");\n    vec3 t; vec3 b; vec3 t0; vec3 b0;\n"
            "    float angle = kTwoPi * (gl_FragCoord.x / 64.0 + floor(gl_FragCoord.y)) / 64.0;\n"
            "    compute_kernel_frame(n, angle, t, b);\n"
            "    compute_tangent_frame(n, t0, b0);\n"
            "    result = vec4(dot(t, t0), dot(t, b0), dot(t, n), 0.0);\n}";
        const Image image = draw(params, text, {64, 64});
        std::array<double, 16> counts{};
        for (int y = 0; y < 64; ++y) {
            for (int x = 0; x < 64; ++x) {
                EXPECT_NEAR(image.at(x, y, 2), 0.0f, 1e-5f);
                const double turns =
                    std::atan2(image.at(x, y, 1), image.at(x, y, 0)) / (2.0 * std::numbers::pi) +
                    1.0;
                ++counts.at(static_cast<std::size_t>(turns * 16.0) % 16);
            }
        }
        double chi_square = 0.0;
        for (const double count : counts) {
            chi_square += (count - 256.0) * (count - 256.0) / 256.0;
        }
        return chi_square;
    }
};

TEST_F(CrytekShaderTest, TheShaderIndexesAsPrinted) {
    CrytekSsaoParams params = make_params(CrytekIndexing::decoupled_literal);
    // Random numbers in the middle of the q-th of 18 parts, a column each; sample j a row.
    const Image literal =
        draw(params,
             "void main() { ivec2 at = ivec2(gl_FragCoord.xy);\n"
             "result = vec4(compute_indices(at.y, vec2((float(at.x) + 0.5) / 18.0)), 0, 0); }",
             {18, 4});
    for (int q = 0; q < 18; ++q) {
        for (int j = 0; j < 4; ++j) {
            const CrytekIndices expected = compute_crytek_indices(j, q, q, params);
            EXPECT_EQ(literal.at(q, 3 - j, 0), static_cast<float>(expected.direction));
            EXPECT_EQ(literal.at(q, 3 - j, 1), static_cast<float>(expected.length));
        }
    }
    params.indexing = CrytekIndexing::decoupled;
    const Image apart =
        draw(params,
             "void main() { result = vec4(compute_indices(3, floor(gl_FragCoord.xy) / 11.0 + "
             "0.01), 0, 0); }",
             {11, 11});
    for (int q = 0; q < 11; ++q) {
        for (int second = 0; second < 11; ++second) {
            const CrytekIndices expected = compute_crytek_indices(3, q, second, params);
            EXPECT_EQ(apart.at(q, 10 - second, 0), static_cast<float>(expected.direction));
            EXPECT_EQ(apart.at(q, 10 - second, 1), static_cast<float>(expected.length));
        }
    }
}

TEST_F(CrytekShaderTest, GramSchmidtClumpsTheAnglesOfATiltedNormalAndAFixedFrameDoesNot) {
    // 15 degrees of freedom; even spacing leaves almost nothing. Projected onto a plane that leans
    // by a the density of angles runs from cos a to 1 / cos a.
    double before = -1.0;
    for (const int degrees : {0, 30, 60, 80}) {
        const double tilt = degrees * std::numbers::pi / 180.0;
        const double clumped = measure_clumping(CrytekKernel::hemisphere_gram_schmidt, tilt);
        const double fixed = measure_clumping(CrytekKernel::hemisphere_frame, tilt);
        RecordProperty("chi_square_gram_schmidt_" + std::to_string(degrees),
                       std::to_string(clumped));
        RecordProperty("chi_square_frame_" + std::to_string(degrees), std::to_string(fixed));
        EXPECT_LT(fixed, 1.0) << degrees;
        EXPECT_GT(clumped, before) << degrees;
        before = clumped;
        if (degrees == 0) {
            EXPECT_LT(clumped, 1.0);
        }
        if (degrees == 60) {
            EXPECT_GT(clumped, 300.0); // 15 + 5 sqrt(30) is chance
        }
    }
}

TEST_F(CrytekShaderTest, ARandomVectorAlongTheNormalStillGivesAFrame) {
    CrytekSsaoParams params;
    params.kernel = CrytekKernel::hemisphere_gram_schmidt;
    const Image image = draw(params,
                             "void main() { vec3 t; vec3 b; vec3 n = vec3(1.0, 0.0, 0.0);\n"
                             "compute_kernel_frame(n, 0.0, t, b);\n"
                             "result = vec4(dot(t, t), dot(b, b), dot(t, b), dot(t, n)); }",
                             {1, 1});
    EXPECT_NEAR(image.at(0, 0, 0), 1.0f, 1e-5f);
    EXPECT_NEAR(image.at(0, 0, 1), 1.0f, 1e-5f);
    EXPECT_NEAR(image.at(0, 0, 2), 0.0f, 1e-5f);
    EXPECT_NEAR(image.at(0, 0, 3), 0.0f, 1e-5f);
}

TEST_F(CrytekShaderTest, ATileHoldsSixteenAnglesEvenlyAndRepeats) {
    CrytekSsaoParams params;
    const char* const kMain =
        "void main() { TexelRandom r = compute_texel_random(ivec2(gl_FragCoord.xy), seed);\n"
        "result = vec4(r.angle / kTwoPi, r.direction); }";
    const Image tile = draw(params, kMain, {8, 8}, 5);
    std::set<int> angles;
    glm::dvec3 mean(0.0);
    const double first = tile.at(0, 0);
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 4; ++x) {
            EXPECT_EQ(tile.at(x, y), tile.at(x + 4, y + 4));
            const double sixteenths = (tile.at(x, y) - first) * 16.0;
            EXPECT_NEAR(sixteenths, std::round(sixteenths), 1e-4);
            angles.insert((static_cast<int>(std::round(sixteenths)) + 16) % 16);
            const glm::dvec3 d(tile.at(x, y, 1), tile.at(x, y, 2), tile.at(x, y, 3));
            EXPECT_NEAR(glm::length(d), 1.0, 1e-5);
            mean += d / 16.0;
        }
    }
    EXPECT_EQ(angles.size(), 16u);
    EXPECT_LT(glm::length(mean), 0.15); // of 16 random ones it would be 0.25
    EXPECT_NE(draw(params, kMain, {8, 8}, 6).at(0, 0), tile.at(0, 0));
    params.randomisation = CrytekRandomisation::pixel;
    const Image pixel = draw(params, kMain, {8, 8}, 5);
    EXPECT_NE(pixel.at(0, 0), pixel.at(4, 4));
}

} // namespace
} // namespace alcove
