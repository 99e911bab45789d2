// This work is based on: Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild. FLIP: A
// Difference Evaluator for Alternating Images. 2020.
#include "metrics/common/flip_colour.hpp"

#include "metrics/common/clones.hpp"
#include "metrics/common/fast_pow.hpp"

#include <cmath>

namespace alcove {
namespace {

// Linear sRGB to X / Xn, Y / Yn, Z / Zn: the matrix of the published implementation, each row over
// the white point that its own sum is (0.950428545, 1, 1.088900371), so that white is 1 in all.
constexpr double kSumX = 10135552.0 + 8788810.0 + 4435075.0;
constexpr double kSumY = 2613072.0 + 8788810.0 + 887015.0;
constexpr double kSumZ = 1425312.0 + 8788810.0 + 70074185.0;
using Matrix = std::array<std::array<double, 3>, 3>;
constexpr Matrix kToWhite{{{10135552.0 / kSumX, 8788810.0 / kSumX, 4435075.0 / kSumX},
                           {2613072.0 / kSumY, 8788810.0 / kSumY, 887015.0 / kSumY},
                           {1425312.0 / kSumZ, 8788810.0 / kSumZ, 70074185.0 / kSumZ}}};

constexpr Matrix invert(const Matrix& m) {
    const auto minor = [&m](std::size_t row, std::size_t column) {
        const std::size_t r0 = row == 0 ? 1 : 0;
        const std::size_t r1 = row == 2 ? 1 : 2;
        const std::size_t c0 = column == 0 ? 1 : 0;
        const std::size_t c1 = column == 2 ? 1 : 2;
        const double sign = (row + column) % 2 == 0 ? 1.0 : -1.0;
        return sign * (m[r0][c0] * m[r1][c1] - m[r0][c1] * m[r1][c0]);
    };
    const double determinant =
        m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
    Matrix inverse{};
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            inverse[row][column] = minor(column, row) / determinant;
        }
    }
    return inverse;
}
constexpr Matrix kFromWhite = invert(kToWhite);

/// A row of a matrix as the floats that a loop multiplies with.
struct Weights {
    float r;
    float g;
    float b;
};
constexpr Weights take_row(const Matrix& matrix, std::size_t row) {
    return {static_cast<float>(matrix[row][0]), static_cast<float>(matrix[row][1]),
            static_cast<float>(matrix[row][2])};
}
constexpr Weights kX = take_row(kToWhite, 0);
constexpr Weights kY = take_row(kToWhite, 1);
constexpr Weights kZ = take_row(kToWhite, 2);
constexpr Weights kR = take_row(kFromWhite, 0);
constexpr Weights kG = take_row(kFromWhite, 1);
constexpr Weights kB = take_row(kFromWhite, 2);

constexpr float kErrorExponent = 0.7f; // q_c
constexpr float kKneeShare = 0.4f;     // p_c
constexpr float kKneeError = 0.95f;    // p_t
constexpr float kHunt = 0.01f;

inline float clamp_to_one(float value) {
    const float low = value < 0.0f ? 0.0f : value;
    return low > 1.0f ? 1.0f : low;
}

/// The cube root of CIELab with its linear toe below (6/29)^3.
inline float compress(float value) {
    constexpr float kToe = 216.0f / 24389.0f;
    const float root = compute_pow(value, 1.0f / 3.0f);
    const float line = value * (841.0f / 108.0f) + 4.0f / 29.0f;
    return value > kToe ? root : line;
}

float compute_largest_error() {
    std::array<float, 2> x{0.0f, 0.0f};
    std::array<float, 2> y{1.0f, 0.0f};
    std::array<float, 2> z{0.0f, 1.0f};
    const std::array<float*, 3> planes{x.data(), y.data(), z.data()};
    convert_to_opponent(planes, 2);
    convert_to_hunt_lab(planes, 2);
    const float distance = std::abs(x[0] - x[1]) + std::hypot(y[0] - y[1], z[0] - z[1]);
    return std::pow(distance, kErrorExponent);
}

ALCOVE_CLONES void map_error(const float* distances, std::size_t count, float largest,
                             float* __restrict out) {
    const float knee = kKneeShare * largest;
    const float low_slope = kKneeError / knee;
    const float high_slope = (1.0f - kKneeError) / (largest - knee);
    for (std::size_t i = 0; i < count; ++i) {
        const float error = compute_pow(distances[i], kErrorExponent);
        const float low = low_slope * error;
        const float high = kKneeError + high_slope * (error - knee);
        out[i] = error < knee ? low : high;
    }
}

ALCOVE_CLONES void add_chroma_distance(const float* a0, const float* a1, const float* b0,
                                       const float* b1, std::size_t count,
                                       float* __restrict distances) {
    for (std::size_t i = 0; i < count; ++i) {
        const float da = a0[i] - a1[i];
        const float db = b0[i] - b1[i];
        distances[i] += std::sqrt(da * da + db * db);
    }
}

ALCOVE_CLONES void subtract(const float* a, const float* b, std::size_t count,
                            float* __restrict out) {
    for (std::size_t i = 0; i < count; ++i) {
        out[i] = std::abs(a[i] - b[i]);
    }
}

ALCOVE_CLONES void convert_opponent_rows(float* __restrict r, float* __restrict g,
                                         float* __restrict b, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const float x = kX.r * r[i] + kX.g * g[i] + kX.b * b[i];
        const float y = kY.r * r[i] + kY.g * g[i] + kY.b * b[i];
        const float z = kZ.r * r[i] + kZ.g * g[i] + kZ.b * b[i];
        r[i] = y;
        g[i] = x - y;
        b[i] = y - z;
    }
}

ALCOVE_CLONES void convert_lab_rows(float* __restrict first, float* __restrict second,
                                    float* __restrict third, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const float y = first[i];
        const float x = y + second[i];
        const float z = y - third[i];
        const float r = clamp_to_one(kR.r * x + kR.g * y + kR.b * z);
        const float g = clamp_to_one(kG.r * x + kG.g * y + kG.b * z);
        const float b = clamp_to_one(kB.r * x + kB.g * y + kB.b * z);
        const float fx = compress(kX.r * r + kX.g * g + kX.b * b);
        const float fy = compress(kY.r * r + kY.g * g + kY.b * b);
        const float fz = compress(kZ.r * r + kZ.g * g + kZ.b * b);
        const float lightness = 116.0f * fy - 16.0f;
        first[i] = lightness;
        second[i] = kHunt * lightness * (500.0f * (fx - fy));
        third[i] = kHunt * lightness * (200.0f * (fy - fz));
    }
}

ALCOVE_CLONES void convert_plain_lab_rows(float* __restrict first, float* __restrict second,
                                          float* __restrict third, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const float r = first[i];
        const float g = second[i];
        const float b = third[i];
        const float fx = compress(kX.r * r + kX.g * g + kX.b * b);
        const float fy = compress(kY.r * r + kY.g * g + kY.b * b);
        const float fz = compress(kZ.r * r + kZ.g * g + kZ.b * b);
        first[i] = 116.0f * fy - 16.0f;
        second[i] = 500.0f * (fx - fy);
        third[i] = 200.0f * (fy - fz);
    }
}

ALCOVE_CLONES void convert_lightness_row(float* __restrict values, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        values[i] = 116.0f * compress(clamp_to_one(values[i])) - 16.0f;
    }
}

ALCOVE_CLONES void decode_row(float* __restrict values, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const float code = clamp_to_one(values[i]);
        const float power = compute_pow((code + 0.055f) / 1.055f, 2.4f);
        const float line = code / 12.92f;
        values[i] = code <= 0.04045f ? line : power;
    }
}

} // namespace

void decode_codes(float* values, std::size_t count) {
    decode_row(values, count);
}

void convert_to_opponent(const std::array<float*, 3>& planes, std::size_t count) {
    convert_opponent_rows(planes[0], planes[1], planes[2], count);
}

void convert_to_hunt_lab(const std::array<float*, 3>& planes, std::size_t count) {
    convert_lab_rows(planes[0], planes[1], planes[2], count);
}

void convert_to_lab(const std::array<float*, 3>& planes, std::size_t count) {
    convert_plain_lab_rows(planes[0], planes[1], planes[2], count);
}

void convert_to_lightness(float* values, std::size_t count) {
    convert_lightness_row(values, count);
}

void compute_colour_error(const std::array<float*, 3>& test, const std::array<float*, 3>& reference,
                          int planes, std::size_t count, float* out) {
    static const float largest = compute_largest_error();
    subtract(test[0], reference[0], count, test[0]);
    if (planes == 3) {
        add_chroma_distance(test[1], reference[1], test[2], reference[2], count, test[0]);
    }
    map_error(test[0], count, largest, out);
}

} // namespace alcove
